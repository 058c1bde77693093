// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/language/program.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "reasoners/icarus/language/program_builder.h"
#include "reasoners/icarus/language/reader.h"
#include "reasoners/icarus/lint/lint.h"

namespace latchwork::icarus {

std::uint32_t Program::Find(std::string_view name) const {
  const std::string folded = Fold(name);
  const auto found = std::find_if(skills.begin(), skills.end(),
                                  [&](const Skill& skill) { return skill.name == folded; });
  return found == skills.end() ? kNoSkill : static_cast<std::uint32_t>(found - skills.begin());
}

namespace {

/// `'name'`, folded, of each form that begins a line and could not be read.
std::vector<std::string> LostNames(const SourceTree& source) {
  std::vector<std::string> lost;
  auto root = source.roots.begin();
  const std::string_view text = source.text;
  for (std::size_t line = 0; line < text.size();) {
    while (root != source.roots.end() && source.at(*root).end <= line) ++root;
    const bool is_read = root != source.roots.end() && source.at(*root).begin <= line;
    if (text[line] == '(' && !is_read) {
      const std::size_t end = std::min(text.find_first_of(" \t\r\n(){};", line + 1), text.size());
      lost.push_back("'" + Fold(text.substr(line + 1, end - line - 1)) + "'");
    }
    const std::size_t newline = text.find('\n', line);
    line = newline == std::string_view::npos ? text.size() : newline + 1;
  }
  return lost;
}

/// What is only said because forms are missing: those with these names could not be read.
bool IsFollowUp(const Finding& finding, const std::vector<std::string>& lost) {
  if (finding.code == Code::kUnreachable || finding.code == Code::kUnknownFact ||
      finding.code == Code::kNoSuchFact) {
    return true;
  }
  const std::string message = Fold(finding.diagnostic.message);
  return std::any_of(lost.begin(), lost.end(), [&](const std::string& name) {
    return message.find(name) != std::string::npos;
  });
}

/// What `result` holds so far is about reading.
void Check(ProgramFile& result, const CheckOptions& options) {
  Program& program = result.program;
  Findings found;
  BuildProgram(program, found);
  Reporter reporter(program.source, found);
  const bool is_whole = !HasErrors(found) && !HasErrors(result.findings);
  LintCalls(program, options, reporter, found);
  LintTypes(program, reporter);
  LintVariables(program, options, reporter);
  LintSkills(program, options, reporter);
  LintSpelling(program, reporter);
  if (!is_whole) {
    const std::vector<std::string> lost = LostNames(program.source);
    std::erase_if(found, [&](const Finding& finding) { return IsFollowUp(finding, lost); });
  }
  std::move(found.begin(), found.end(), std::back_inserter(result.findings));
}

/// Builds and checks what was read.
void Finish(ProgramFile& result, const CheckOptions& options) {
  Program& program = result.program;
  Check(result, options);
  Settle(program.source, result.findings);
}

}  // namespace

ProgramFile ReadProgram(std::string text, std::string file, const CheckOptions& options) {
  ProgramFile result;
  result.program.source = ReadForms(std::move(text), std::move(file), result.findings);
  Finish(result, options);
  return result;
}

ProgramFile ReadProgram(std::string text, std::vector<SourcePart> parts,
                        const CheckOptions& options) {
  ProgramFile result;
  result.program.source =
      ReadForms(std::move(text), parts.empty() ? "" : parts.front().file, result.findings);
  result.program.source.parts = std::move(parts);
  Finish(result, options);
  return result;
}

}  // namespace latchwork::icarus

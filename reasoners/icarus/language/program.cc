// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/language/program.h"

#include <algorithm>
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

/// Builds and checks what was read.
void Finish(ProgramFile& result, const CheckOptions& options) {
  Program& program = result.program;
  BuildProgram(program, result.findings);
  Reporter reporter(program.source, result.findings);
  if (!HasErrors(result.findings)) {
    LintCalls(program, options, reporter, result.findings);
    LintTypes(program, reporter);
    LintVariables(program, reporter);
    LintSkills(program, options, reporter);
    LintSpelling(program, reporter);
  }
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

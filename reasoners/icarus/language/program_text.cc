// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/language/program_text.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "reasoners/icarus/language/reader.h"

namespace latchwork::icarus {

namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// What a form defines: the name of a skill or constant, "(top)", or nothing.
std::string NameDefinedBy(const SourceTree& tree, FormId root) {
  if (tree.kind(root) != FormKind::kList) return {};
  const std::vector<FormId> children = tree.Children(root);
  if (children.empty() || tree.kind(children[0]) != FormKind::kSymbol) return {};
  std::string head = tree.Folded(children[0]);
  if (head == "facts" || tree.IsNever(root)) return {};
  if (tree.IsTop(root)) return "(top)";
  if (head != "constant") return head;
  return children.size() > 1 ? tree.Folded(children[1]) : std::string();
}

}  // namespace

bool ProgramText::Blank(Part& part, std::string_view name) {
  Findings none;
  const SourceTree tree = ReadForms(part.text, part.file, none);
  std::size_t found = 0;
  for (const FormId root : tree.roots) {
    if (NameDefinedBy(tree, root) != name) continue;
    ++found;
    for (std::uint32_t i = tree.at(root).begin; i < tree.at(root).end; ++i) {
      if (part.text[i] != '\n') part.text[i] = ' ';
    }
  }
  if (found == tree.roots.size()) part.text.clear();
  return found > 0;
}

void ProgramText::Add(std::string text, std::string file, Findings& findings) {
  Append(std::move(text), std::move(file), false, findings);
}

void ProgramText::Tell(std::string text, std::string file, Findings& findings) {
  Append(std::move(text), std::move(file), true, findings);
}

void ProgramText::Append(std::string text, std::string file, bool replace, Findings& findings) {
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  const std::size_t before = findings.size();
  const SourceTree tree = ReadForms(text, file, findings);
  if (findings.size() > before) return;
  if (!text.ends_with('\n')) text += '\n';
  for (const FormId root : tree.roots) {
    const std::string name = NameDefinedBy(tree, root);
    if (replace && !name.empty()) Remove(name);
  }
  parts_.push_back({std::move(file), std::move(text)});
}

bool ProgramText::Remove(std::string_view name) {
  const std::string folded = Fold(name);
  bool found = false;
  for (Part& part : parts_) found = Blank(part, folded) || found;
  std::erase_if(parts_, [](const Part& part) { return part.text.empty(); });
  return found;
}

ProgramFile ProgramText::Read(const CheckOptions& options) const {
  std::string text;
  std::vector<SourcePart> parts;
  std::uint32_t line = 1;
  for (const Part& part : parts_) {
    parts.push_back({line, part.file});
    line += static_cast<std::uint32_t>(std::count(part.text.begin(), part.text.end(), '\n'));
    text += part.text;
  }
  return ReadProgram(std::move(text), std::move(parts), options);
}

std::uint32_t ProgramText::last_begin() const {
  std::size_t begin = 0;
  for (std::size_t i = 0; i + 1 < parts_.size(); ++i) begin += parts_[i].text.size();
  return static_cast<std::uint32_t>(begin);
}

}  // namespace latchwork::icarus

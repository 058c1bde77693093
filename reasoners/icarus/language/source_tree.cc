// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/language/source_tree.h"

#include <algorithm>
#include <iterator>

namespace latchwork::icarus {

namespace {

constexpr std::size_t kLongestLine = 1U << 14U;

}  // namespace

std::string Fold(std::string_view name) {
  std::string folded(name);
  for (char& c : folded) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return folded;
}

std::string_view SourceTree::Text(FormId id) const {
  const std::string_view all = text;
  return all.substr(at(id).begin, at(id).end - at(id).begin);
}

std::string_view SourceTree::Text(const Comment& comment) const {
  const std::string_view all = text;
  return all.substr(comment.begin, comment.end - comment.begin);
}

std::string SourceTree::Folded(FormId id) const { return Fold(Text(id)); }

std::string SourceTree::Unquoted(FormId id) const {
  const std::string_view quoted = Text(id);
  std::string plain;
  for (std::size_t i = 1; i + 1 < quoted.size(); ++i) {
    if (quoted[i] == '\\') ++i;
    plain += quoted[i];
  }
  return plain;
}

std::vector<FormId> SourceTree::Children(FormId id) const {
  std::vector<FormId> children;
  for (FormId c = at(id).first_child; c != kNoForm; c = at(c).next_sibling) children.push_back(c);
  return children;
}

bool SourceTree::IsTop(FormId root) const {
  const FormId head = at(root).first_child;
  if (kind(root) != FormKind::kList || head == kNoForm || Folded(head) != "top") return false;
  const FormId call = at(head).next_sibling;
  return call != kNoForm && kind(call) == FormKind::kList && at(call).first_child != kNoForm &&
         at(call).next_sibling == kNoForm;
}

bool SourceTree::IsNever(FormId root) const {
  const std::vector<FormId> children = Children(root);
  if (kind(root) != FormKind::kList || children.size() < 2 || Folded(children[0]) != "never") {
    return false;
  }
  return std::all_of(children.begin() + 1, children.end(), [this](FormId child) {
    return kind(child) == FormKind::kCall ||
           (kind(child) == FormKind::kList && at(child).first_child != kNoForm);
  });
}

logic::SourcePlace SourceTree::Place(FormId id) const {
  return PlaceAt(at(id).line, at(id).column);
}

logic::SourcePlace SourceTree::PlaceAt(std::uint32_t line, std::uint32_t column) const {
  const auto next =
      std::upper_bound(parts.begin(), parts.end(), line,
                       [](std::uint32_t l, const SourcePart& part) { return l < part.first_line; });
  if (next == parts.begin()) return {file, line, column};
  const SourcePart& part = *std::prev(next);
  return {part.file, line - part.first_line + 1, column};
}

std::string_view SourceTree::LineAt(std::size_t offset) const {
  const std::string_view all = text;
  const std::size_t from = offset > kLongestLine ? offset - kLongestLine : 0;
  const std::size_t before = all.substr(from, offset - from).rfind('\n');
  if (before == std::string_view::npos && from > 0) return {};
  const std::size_t begin = before == std::string_view::npos ? 0 : from + before + 1;
  const std::size_t length = all.substr(begin, 2 * kLongestLine).find_first_of("\r\n");
  if (length == std::string_view::npos && all.size() - begin > 2 * kLongestLine) return {};
  return all.substr(begin, length);
}

}  // namespace latchwork::icarus

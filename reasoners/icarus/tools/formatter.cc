// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/tools/formatter.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

namespace latchwork::icarus {

namespace {

constexpr std::size_t kColumns = 100;
constexpr std::size_t kDeepestIndent = 60;
constexpr std::uint32_t kEndOfText = std::numeric_limits<std::uint32_t>::max();

class Formatter {
 public:
  explicit Formatter(const SourceTree& tree) : tree_(tree), widths_(tree.forms.size()) {
    for (std::size_t i = tree.forms.size(); i-- > 0;) {
      widths_[i] = Width(static_cast<FormId>(i));
    }
  }

  std::string Run() {
    for (std::size_t i = 0; i < tree_.roots.size(); ++i) {
      const FormId root = tree_.roots[i];
      TopLevelComments(tree_.at(root).begin);
      BeginTopLevel(tree_.at(root).line);
      PrintRoot(root);
      const bool last = i + 1 == tree_.roots.size();
      Trailing(root, last ? kEndOfText : tree_.at(tree_.roots[i + 1]).begin);
      last_line_ = tree_.at(root).end_line;
    }
    TopLevelComments(kEndOfText);
    if (!out_.empty()) out_ += '\n';
    return std::move(out_);
  }

 private:
  bool IsAtom(FormId id) const {
    return tree_.kind(id) != FormKind::kList && tree_.kind(id) != FormKind::kCall;
  }

  /// On one line. Children have greater ids than their parents.
  std::size_t Width(FormId id) const {
    const Form& form = tree_.at(id);
    if (IsAtom(id)) return form.end - form.begin;
    std::size_t width = 1;
    for (FormId c = form.first_child; c != kNoForm; c = tree_.at(c).next_sibling) {
      width += widths_[c] + 1;
    }
    return std::max<std::size_t>(width, 2);
  }

  bool HasComments(FormId id) const {
    const auto next = std::lower_bound(
        tree_.comments.begin(), tree_.comments.end(), tree_.at(id).begin,
        [](const Comment& comment, std::uint32_t begin) { return comment.begin < begin; });
    return next != tree_.comments.end() && next->begin < tree_.at(id).end;
  }

  bool CommentBefore(std::uint32_t offset) const {
    return comment_ < tree_.comments.size() && tree_.comments[comment_].begin < offset;
  }

  std::size_t Column() const { return out_.size() - line_start_; }

  void NewLine(std::size_t indent) {
    out_ += '\n';
    line_start_ = out_.size();
    out_.append(std::min(indent, kDeepestIndent), ' ');
  }

  /// The first of the comments that stand before `offset`, if there is one.
  bool PrintComment(std::uint32_t offset) {
    if (!CommentBefore(offset)) return false;
    out_ += tree_.Text(tree_.comments[comment_++]);
    return true;
  }

  void BeginTopLevel(std::uint32_t line) {
    if (out_.empty()) return;
    NewLine(0);
    if (line > last_line_ + 1) NewLine(0);
  }

  void TopLevelComments(std::uint32_t offset) {
    while (CommentBefore(offset)) {
      const std::uint32_t line = tree_.comments[comment_].line;
      BeginTopLevel(line);
      PrintComment(offset);
      last_line_ = line;
    }
  }

  /// A comment between the end of the form and `limit` on the form's last line.
  bool Trailing(FormId id, std::uint32_t limit) {
    const Form& form = tree_.at(id);
    if (!CommentBefore(limit)) return false;
    const Comment& comment = tree_.comments[comment_];
    if (comment.begin < form.end || comment.line != form.end_line) return false;
    out_ += "  ";
    return PrintComment(limit);
  }

  void PrintFlat(FormId id) {
    if (IsAtom(id)) {
      out_ += tree_.Text(id);
      return;
    }
    const bool list = tree_.kind(id) == FormKind::kList;
    out_ += list ? '(' : '{';
    const FormId first = tree_.at(id).first_child;
    for (FormId c = first; c != kNoForm; c = tree_.at(c).next_sibling) {
      if (c != first) out_ += ' ';
      PrintFlat(c);
    }
    out_ += list ? ')' : '}';
  }

  /// `closers`: the brackets that will follow on the same line.
  void Print(FormId id, std::size_t closers) {
    const bool fits = Column() + widths_[id] + closers <= kColumns;
    if (IsAtom(id) || (fits && !HasComments(id))) {
      PrintFlat(id);
      return;
    }
    out_ += tree_.kind(id) == FormKind::kList ? '(' : '{';
    PrintItems(tree_.at(id).first_child, Column(), tree_.at(id).end - 1, closers + 1, true);
    out_ += tree_.kind(id) == FormKind::kList ? ')' : '}';
  }

  /// The forms from `item` on, one a line, and the comments up to `close`.
  void PrintItems(FormId item, std::size_t indent, std::uint32_t close, std::size_t closers,
                  bool at_start) {
    bool comment_last = false;
    for (FormId c = item; c != kNoForm; c = tree_.at(c).next_sibling) {
      if (!at_start) NewLine(indent);
      at_start = false;
      Leading(tree_.at(c).begin, indent);
      const FormId next = tree_.at(c).next_sibling;
      Print(c, next == kNoForm ? closers : 0);
      comment_last = Trailing(c, next == kNoForm ? close : tree_.at(next).begin);
    }
    Dangling(close, indent, comment_last, at_start);
  }

  void Leading(std::uint32_t offset, std::size_t indent) {
    while (PrintComment(offset)) NewLine(indent);
  }

  /// The comments between the last item and the bracket that closes the list.
  void Dangling(std::uint32_t close, std::size_t indent, bool comment_last, bool at_start) {
    while (CommentBefore(close)) {
      if (!at_start) NewLine(indent);
      at_start = false;
      PrintComment(close);
      comment_last = true;
    }
    if (comment_last) NewLine(indent);
  }

  void PrintRoot(FormId root) {
    const Form& form = tree_.at(root);
    const FormId head = form.first_child;
    if (IsAtom(root) || head == kNoForm || !IsAtom(head) || IsOneLine(root)) {
      Print(root, 0);
      return;
    }
    out_ += tree_.kind(root) == FormKind::kList ? '(' : '{';
    PrintFlat(head);
    FormId last = head;
    const FormId second = tree_.at(head).next_sibling;
    if (second != kNoForm && tree_.kind(second) == FormKind::kList && IsSkill(root) &&
        !HasComments(second)) {
      out_ += ' ';
      PrintFlat(second);
      last = second;
    }
    const FormId rest = tree_.at(last).next_sibling;
    const std::uint32_t close = form.end - 1;
    const bool commented = Trailing(last, rest == kNoForm ? close : tree_.at(rest).begin);
    if (rest == kNoForm) {
      Dangling(close, 2, commented, false);
    } else {
      PrintSlots(rest, close);
    }
    out_ += tree_.kind(root) == FormKind::kList ? ')' : '}';
  }

  bool IsSkill(FormId root) const {
    const std::string head = tree_.Folded(tree_.at(root).first_child);
    return head != "facts" && head != "constant" && !tree_.IsTop(root) && !tree_.IsNever(root);
  }

  /// A skill stands on one line when it has one slot at most.
  bool IsOneLine(FormId root) const {
    if (HasComments(root) || widths_[root] > kColumns) return false;
    std::size_t slots = 0;
    for (FormId c = tree_.at(root).first_child; c != kNoForm; c = tree_.at(c).next_sibling) {
      if (tree_.kind(c) == FormKind::kKeyword) ++slots;
    }
    return slots < 2;
  }

  std::size_t LongestKeyword(FormId from) const {
    std::size_t longest = 0;
    for (FormId c = from; c != kNoForm; c = tree_.at(c).next_sibling) {
      if (tree_.kind(c) == FormKind::kKeyword) longest = std::max(longest, widths_[c]);
    }
    return longest;
  }

  void PrintSlots(FormId item, std::uint32_t close) {
    constexpr std::size_t kIndent = 2;
    const std::size_t longest = LongestKeyword(item);
    bool comment_last = false;
    while (item != kNoForm) {
      NewLine(kIndent);
      FormId value = item;
      const FormId after = tree_.at(item).next_sibling;
      if (tree_.kind(item) == FormKind::kKeyword && after != kNoForm &&
          tree_.kind(after) != FormKind::kKeyword) {
        value = after;
      }
      Leading(tree_.at(value).begin, kIndent);
      if (value != item) {
        PrintFlat(item);
        out_.append(longest - widths_[item] + 1, ' ');
      }
      const FormId next = tree_.at(value).next_sibling;
      Print(value, next == kNoForm ? 1 : 0);
      comment_last = Trailing(value, next == kNoForm ? close : tree_.at(next).begin);
      item = next;
    }
    Dangling(close, kIndent, comment_last, false);
  }

  const SourceTree& tree_;
  std::vector<std::size_t> widths_;
  std::string out_;
  std::size_t line_start_ = 0;
  std::size_t comment_ = 0;
  std::uint32_t last_line_ = 0;
};

}  // namespace

std::string FormatProgram(const SourceTree& tree) { return Formatter(tree).Run(); }

}  // namespace latchwork::icarus

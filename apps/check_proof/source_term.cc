// SPDX-License-Identifier: BSD-3-Clause
#include "apps/check_proof/source_term.h"

#include <utility>

namespace latchwork::check_proof {
namespace {

constexpr int kDeepest = 100;

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  bool ReadTerm(SourceTerm& term, int depth) {
    if (depth > kDeepest) return false;
    SkipBlanks();
    if (Accept('[')) {
      term.name = "[]";
      if (!ReadArguments(term, ']', depth)) return false;
    } else {
      if (!ReadName(term.name)) return false;
      if (Accept('(') && !ReadArguments(term, ')', depth)) return false;
    }
    SourceTerm comment;
    return !Accept(':') || ReadTerm(comment, depth + 1);
  }

 private:
  bool ReadArguments(SourceTerm& term, char end, int depth) {
    if (Accept(end)) return true;
    do {
      if (!ReadTerm(term.arguments.emplace_back(), depth + 1)) return false;
    } while (Accept(','));
    return Accept(end);
  }

  bool ReadName(std::string& name) {
    if (Accept('\'')) return ReadQuoted(name);
    const std::size_t begin = position_;
    const std::size_t end = text_.find_first_of(" \t\r\n,:()[]'\"", begin);
    position_ = end == std::string_view::npos ? text_.size() : end;
    name = text_.substr(begin, position_ - begin);
    return !name.empty();
  }

  bool ReadQuoted(std::string& name) {
    for (; position_ < text_.size(); ++position_) {
      if (text_[position_] == '\'') {
        ++position_;
        return true;
      }
      if (text_[position_] == '\\' && ++position_ == text_.size()) return false;
      name += text_[position_];
    }
    return false;
  }

  bool Accept(char wanted) {
    SkipBlanks();
    if (position_ == text_.size() || text_[position_] != wanted) return false;
    ++position_;
    return true;
  }

  void SkipBlanks() {
    const std::size_t next = text_.find_first_not_of(" \t\r\n", position_);
    position_ = next == std::string_view::npos ? text_.size() : next;
  }

  std::string_view text_;
  std::size_t position_ = 0;
};

}  // namespace

const SourceTerm* SourceTerm::List(std::size_t index) const {
  return index < arguments.size() && arguments[index].is_list() ? &arguments[index] : nullptr;
}

std::optional<SourceTerm> ReadSource(std::string_view text) {
  SourceTerm term;
  if (!Reader(text).ReadTerm(term, 0)) return std::nullopt;
  return term;
}

}  // namespace latchwork::check_proof

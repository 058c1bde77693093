// SPDX-License-Identifier: BSD-3-Clause
#include <string_view>

#include "core/logic/print.h"

namespace latchwork::logic {

namespace {

using Kind = Formula::Kind;

std::string_view Connective(Kind kind) {
  switch (kind) {
    case Kind::kAnd:
      return " & ";
    case Kind::kOr:
      return " | ";
    case Kind::kImplies:
      return " => ";
    default:
      return " <=> ";
  }
}

bool IsBinary(Kind kind) {
  return kind == Kind::kAnd || kind == Kind::kOr || kind == Kind::kImplies ||
         kind == Kind::kEquivalent;
}

/// Prints one formula; what is begun and not yet ended stands on an explicit stack.
class Printer {
 public:
  Printer(std::string& text, std::span<const std::string> names) : text_(text), names_(names) {}

  void Print(const Formula& formula) {
    Begin(formula, false);
    while (!open_.empty()) {
      Frame& frame = open_.back();
      if (frame.next == frame.formula->children().size()) {
        if (frame.parentheses) text_ += ')';
        open_.pop_back();
        continue;
      }
      if (frame.next > 0) text_ += Connective(frame.formula->kind());
      Begin(frame.formula->children()[frame.next++], true);
    }
  }

 private:
  struct Frame {
    const Formula* formula;
    bool parentheses;
    std::size_t next = 0;
  };

  void Begin(const Formula& formula, bool inside) {
    const Kind kind = formula.kind();
    if (kind == Kind::kTrue || kind == Kind::kFalse) {
      text_ += kind == Kind::kTrue ? "$true" : "$false";
    } else if (kind == Kind::kAtom) {
      AppendAtom(text_, formula.atom(), names_);
    } else if (kind == Kind::kNot && formula.children()[0].kind() == Kind::kAtom) {
      AppendLiteral(text_, false, formula.children()[0].atom(), names_);
    } else {
      const bool parentheses = inside && IsBinary(kind);
      text_ += parentheses ? "(" : Prefix(formula);
      open_.push_back({&formula, parentheses});
    }
  }

  std::string Prefix(const Formula& formula) const {
    if (IsBinary(formula.kind())) return {};
    if (formula.kind() == Kind::kNot) return "~ ";
    std::string text = formula.kind() == Kind::kForall ? "! " : "? ";
    std::string_view separator = "[";
    for (const Variable variable : formula.variables()) {
      text += separator;
      AppendVariable(text, variable, names_);
      separator = ", ";
    }
    return text + "] : ";
  }

  std::string& text_;
  std::span<const std::string> names_;
  std::vector<Frame> open_;
};

}  // namespace

std::string ToString(const Formula& formula, std::span<const std::string> variable_names) {
  std::string text;
  Printer(text, variable_names).Print(formula);
  return text;
}

}  // namespace latchwork::logic

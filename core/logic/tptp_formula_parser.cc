// SPDX-License-Identifier: BSD-3-Clause
#include "core/logic/tptp_formula_parser.h"

#include <iterator>
#include <utility>

namespace latchwork::logic {

namespace {

using Kind = TptpToken::Kind;

bool IsConnective(Kind kind) { return kind >= Kind::kAnd && kind <= Kind::kNand; }
bool IsAssociative(Kind kind) { return kind == Kind::kAnd || kind == Kind::kOr; }

Formula Connect(Kind connective, std::vector<Formula> values) {
  switch (connective) {
    case Kind::kAnd:
      return Formula::And(std::move(values));
    case Kind::kOr:
      return Formula::Or(std::move(values));
    case Kind::kNand:
      return Formula::Not(Formula::And(std::move(values)));
    case Kind::kNor:
      return Formula::Not(Formula::Or(std::move(values)));
    case Kind::kImplies:
      return Formula::Implies(std::move(values[0]), std::move(values[1]));
    case Kind::kImpliedBy:
      return Formula::Implies(std::move(values[1]), std::move(values[0]));
    case Kind::kXor:
      return Formula::Not(Formula::Equivalent(std::move(values[0]), std::move(values[1])));
    default:
      return Formula::Equivalent(std::move(values[0]), std::move(values[1]));
  }
}

}  // namespace

bool ReadTptpType(TptpCursor& cursor, TptpType& type) {
  const std::string_view name = cursor.token().text;
  if (name == "$i") {
    type = TptpType::kIndividual;
  } else if (name == "$int") {
    type = TptpType::kInteger;
  } else if (name == "$real") {
    type = TptpType::kReal;
  } else {
    return cursor.FailExpected("the type $i, $int or $real", "other types are not supported");
  }
  cursor.Advance();
  return true;
}

TptpFormulaParser::TptpFormulaParser(TptpCursor& cursor, SymbolTable& symbols)
    : cursor_(cursor), terms_(cursor, symbols) {}

std::optional<Formula> TptpFormulaParser::Read(TptpLanguage language) {
  language_ = language;
  terms_.Begin(language == TptpLanguage::kCnf);
  prefixes_.clear();
  values_.clear();
  types_.clear();
  groups_.assign(1, Group());
  const SourcePlace place = cursor_.place();
  while (true) {
    if (!ReadPrefixes()) return std::nullopt;
    auto atom = terms_.ReadAtom();
    if (!atom) return std::nullopt;
    values_.push_back(std::move(*atom));
    const Step step = ReadAfterUnit();
    if (step == Step::kFault) return std::nullopt;
    if (step == Step::kEnd) break;
  }
  CloseGroup();
  if (language == TptpLanguage::kCnf) return ToClause(values_.back(), place);
  return std::move(values_.back());
}

bool TptpFormulaParser::ReadPrefixes() {
  while (true) {
    if (prefixes_.size() + groups_.size() > kDeepestNesting) {
      return cursor_.Fail("formula is nested too deeply");
    }
    if (cursor_.Accept(Kind::kNot)) {
      prefixes_.emplace_back();
    } else if (cursor_.Is(Kind::kForall) || cursor_.Is(Kind::kExists)) {
      if (!ReadQuantifier()) return false;
    } else if (cursor_.Accept(Kind::kLeftParenthesis)) {
      groups_.push_back({prefixes_.size(), values_.size()});
    } else {
      return true;
    }
  }
}

bool TptpFormulaParser::ReadQuantifier() {
  if (language_ == TptpLanguage::kCnf) {
    return cursor_.Fail("a clause has no quantifiers",
                        "its variables are universal without; write other formulas as fof(...)");
  }
  Prefix prefix;
  prefix.kind = cursor_.Is(Kind::kForall) ? Formula::Kind::kForall : Formula::Kind::kExists;
  cursor_.Advance();
  if (!ReadVariables(prefix.variables)) return false;
  prefixes_.push_back(std::move(prefix));
  return cursor_.Expect(Kind::kColon, "':' after the quantified variables",
                        "a quantified formula reads '! [X] : p(X)'");
}

bool TptpFormulaParser::ReadVariables(std::vector<Variable>& variables) {
  if (!cursor_.Expect(Kind::kLeftBracket, "'[' and the quantified variables",
                      "a quantified formula reads '! [X] : p(X)'")) {
    return false;
  }
  do {
    if (!cursor_.Is(Kind::kUpperWord)) {
      return cursor_.FailExpected("a variable", "variables begin with an upper-case letter");
    }
    variables.push_back(terms_.scope().Bind(cursor_.token().text));
    cursor_.Advance();
    if (!ReadVariableType()) return false;
  } while (cursor_.Accept(Kind::kComma));
  return cursor_.Expect(Kind::kRightBracket, "',' or ']'");
}

bool TptpFormulaParser::ReadVariableType() {
  TptpType& type = types_.emplace_back(TptpType::kNone);
  if (!cursor_.Is(Kind::kColon)) return true;
  if (language_ != TptpLanguage::kTff) {
    return cursor_.Fail("types belong to tff", "write tff(...) instead of fof(...)");
  }
  cursor_.Advance();
  return ReadTptpType(cursor_, type);
}

void TptpFormulaParser::ApplyPrefixes() {
  Formula& value = values_.back();
  for (; prefixes_.size() > groups_.back().first_prefix; prefixes_.pop_back()) {
    Prefix& prefix = prefixes_.back();
    for (std::size_t i = prefix.variables.size(); i-- > 0;) {
      terms_.scope().Unbind(prefix.variables[i]);
    }
    if (prefix.kind == Formula::Kind::kNot) {
      value = Formula::Not(std::move(value));
    } else if (prefix.kind == Formula::Kind::kForall) {
      value = Formula::Forall(std::move(prefix.variables), std::move(value));
    } else {
      value = Formula::Exists(std::move(prefix.variables), std::move(value));
    }
  }
}

TptpFormulaParser::Step TptpFormulaParser::ReadAfterUnit() {
  while (true) {
    ApplyPrefixes();
    if (IsConnective(cursor_.kind())) return ReadConnective() ? Step::kUnit : Step::kFault;
    if (groups_.size() == 1) return Step::kEnd;
    if (!cursor_.Is(Kind::kRightParenthesis)) {
      FailUnclosed();
      return Step::kFault;
    }
    cursor_.Advance();
    CloseGroup();
  }
}

bool TptpFormulaParser::FailUnclosed() {
  std::string_view hint;
  if (cursor_.Is(Kind::kComma)) hint = "TPTP writes conjunction as '&'";
  if (cursor_.Is(Kind::kDot) || cursor_.Is(Kind::kEnd)) hint = "a '(' is not closed";
  return cursor_.FailExpected("a connective or ')'", hint);
}

bool TptpFormulaParser::ReadConnective() {
  const Kind connective = cursor_.kind();
  Kind& before = groups_.back().connective;
  if (language_ == TptpLanguage::kCnf && connective != Kind::kOr) {
    return cursor_.Fail("a clause is a disjunction of literals, but here is " + cursor_.Found(),
                        "write other formulas as fof(...)");
  }
  if (before != Kind::kEnd && (before != connective || !IsAssociative(connective))) {
    return FailMixed(before);
  }
  before = connective;
  cursor_.Advance();
  return true;
}

bool TptpFormulaParser::FailMixed(Kind connective) {
  if (cursor_.Is(connective)) {
    return cursor_.Fail(cursor_.Found() + " does not associate", "set parentheses");
  }
  if (IsAssociative(connective) && IsAssociative(cursor_.kind())) {
    return cursor_.Fail("'&' and '|' are mixed without parentheses",
                        "neither binds tighter: write (a & b) | c, or a & (b | c)");
  }
  return cursor_.Fail(cursor_.Found() + " follows another connective without parentheses",
                      "no connective binds tighter than another: write (a & b) => c");
}

/// The values of the innermost group become one.
void TptpFormulaParser::CloseGroup() {
  const Group group = groups_.back();
  groups_.pop_back();
  if (values_.size() - group.first_value == 1) return;
  const auto first = values_.begin() + static_cast<std::ptrdiff_t>(group.first_value);
  std::vector<Formula> values(std::make_move_iterator(first),
                              std::make_move_iterator(values_.end()));
  values_.erase(first, values_.end());
  values_.push_back(Connect(group.connective, std::move(values)));
}

std::optional<Formula> TptpFormulaParser::ToClause(const Formula& formula,
                                                   const SourcePlace& place) {
  std::vector<Formula> literals;
  std::vector<Formula> pending = {formula};
  while (!pending.empty()) {
    const Formula next = std::move(pending.back());
    pending.pop_back();
    const auto children = next.children();
    if (next.kind() == Formula::Kind::kOr) {
      pending.insert(pending.end(), children.rbegin(), children.rend());
    } else if (next.kind() == Formula::Kind::kAnd ||
               (next.kind() == Formula::Kind::kNot && !children[0].children().empty())) {
      cursor_.FailAt(place, "in a clause only atoms may be negated",
                     "write other formulas as fof(...)");
      return std::nullopt;
    } else {
      literals.push_back(next);
    }
  }
  Formula clause = literals.size() == 1 ? std::move(literals[0]) : Formula::Or(std::move(literals));
  if (terms_.scope().size() == 0) return clause;
  std::vector<Variable> variables(terms_.scope().size());
  for (std::size_t i = 0; i < variables.size(); ++i) variables[i] = static_cast<Variable>(i);
  return Formula::Forall(std::move(variables), std::move(clause));
}

}  // namespace latchwork::logic

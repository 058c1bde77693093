// SPDX-License-Identifier: BSD-3-Clause
#include "core/logic/tptp_term_parser.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/logic/decimal.h"
#include "core/logic/interpreted.h"

namespace latchwork::logic {

namespace {

using Kind = TptpToken::Kind;

constexpr std::size_t kMostDistinct = 1000;

bool BeginsTerm(Kind kind) { return kind >= Kind::kLowerWord && kind <= Kind::kReal; }

std::string Quote(std::string_view text) { return "'" + std::string(text) + "'"; }

std::string LowerFirst(std::string_view name) {
  std::string lower(name.substr(std::min(name.find_first_not_of('_'), name.size())));
  if (lower.empty()) return "x";
  if (lower[0] >= 'A' && lower[0] <= 'Z') lower[0] = static_cast<char>(lower[0] - 'A' + 'a');
  return lower;
}

std::string PredicateHint(std::string_view name) {
  return "predicates and functions begin with a lower-case letter, as in '" + LowerFirst(name) +
         "', or stand in single quotes";
}

template <std::size_t kCount>
const InterpretedName* FindInterpreted(const std::array<InterpretedName, kCount>& names,
                                       std::string_view name) {
  const auto found =
      std::find_if(names.begin(), names.end(), [&](const auto& each) { return each.name == name; });
  return found == names.end() ? nullptr : &*found;
}

std::string NearestInterpreted(std::string_view name, bool is_predicate) {
  std::vector<std::string> names;
  if (is_predicate) {
    names = {"$true", "$false", "$distinct"};
    for (const auto& each : kInterpretedPredicates) names.emplace_back(each.name);
  } else {
    for (const auto& each : kInterpretedFunctions) names.emplace_back(each.name);
  }
  const std::string_view nearest = NearestName(name, names);
  return nearest.empty() ? std::string() : "did you mean '" + std::string(nearest) + "'?";
}

}  // namespace

void TptpScope::Clear() {
  names_.clear();
  bound_.clear();
}

Variable TptpScope::Bind(std::string_view name) {
  const auto variable = static_cast<Variable>(names_.size());
  names_.push_back(name);
  bound_[name].push_back(variable);
  return variable;
}

void TptpScope::Unbind(Variable variable) { bound_[names_[variable]].pop_back(); }

std::optional<Variable> TptpScope::Find(std::string_view name) const {
  const auto found = bound_.find(name);
  if (found == bound_.end() || found->second.empty()) return std::nullopt;
  return found->second.back();
}

std::vector<std::string> TptpScope::Names() const { return {names_.begin(), names_.end()}; }

TptpTermParser::TptpTermParser(TptpCursor& cursor, SymbolTable& symbols)
    : cursor_(cursor),
      symbols_(symbols),
      equality_(symbols.Intern("=")),
      distinct_(symbols.Intern("$distinct")) {}

void TptpTermParser::Begin(bool implicit) {
  scope_.Clear();
  implicit_ = implicit;
}

std::optional<Term> TptpTermParser::ReadTerm() {
  open_.clear();
  values_.clear();
  while (true) {
    const std::size_t depth = open_.size();
    if (!ReadHead()) return std::nullopt;
    if (open_.size() > depth) continue;
    while (!open_.empty() && !cursor_.Accept(Kind::kComma)) {
      if (!Close()) return std::nullopt;
    }
    if (open_.empty()) return std::move(values_.back());
  }
}

bool TptpTermParser::ReadHead() {
  switch (cursor_.kind()) {
    case Kind::kUpperWord:
      return ReadVariable();
    case Kind::kInteger:
    case Kind::kRational:
    case Kind::kReal:
      return ReadNumber();
    case Kind::kLowerWord:
    case Kind::kDollarWord:
    case Kind::kQuoted:
      return ReadWord();
    case Kind::kDistinctObject:
      values_.push_back(Term::Constant(
          symbols_.Intern(Unquote(cursor_.token().text), SymbolKind::kDistinctObject)));
      cursor_.Advance();
      return true;
    default:
      return cursor_.FailExpected("a term");
  }
}

bool TptpTermParser::ReadVariable() {
  const SourcePlace place = cursor_.place();
  const std::string_view name = cursor_.token().text;
  cursor_.Advance();
  if (cursor_.Is(Kind::kLeftParenthesis)) {
    return cursor_.FailAt(place, "variable " + Quote(name) + " cannot take arguments",
                          PredicateHint(name));
  }
  auto variable = scope_.Find(name);
  if (!variable && implicit_) variable = scope_.Bind(name);
  if (!variable) {
    return cursor_.FailAt(
        place, "variable " + Quote(name) + " is not quantified",
        "write '! [" + std::string(name) + "] : ( ... )' around its scope; " + PredicateHint(name));
  }
  values_.push_back(Term::Var(*variable));
  return true;
}

bool TptpTermParser::ReadNumber() {
  const std::string_view text = cursor_.token().text;
  const std::string_view digits = text.substr(text[0] == '+' ? 1 : 0);
  const char* const end = digits.data() + digits.size();
  if (cursor_.Is(Kind::kRational)) {
    return cursor_.Fail("rational numbers are not supported",
                        "write a real such as 0.5, or '$quotient(1, 2)'");
  }
  if (cursor_.Is(Kind::kInteger)) {
    std::int64_t value = 0;
    if (std::from_chars(digits.data(), end, value).ec != std::errc()) {
      return cursor_.Fail("integer does not fit into 64 bits",
                          "use a constant: 'n" + std::string(digits.substr(0, 40)) + "'");
    }
    values_.push_back(Term::Integer(value));
  } else {
    double value = 0;
    if (std::from_chars(digits.data(), end, value).ec != std::errc()) {
      return cursor_.Fail("real is beyond the range of a double");
    }
    const std::string shortest = ToString(Term::Real(value));
    if (!AreEqualNumerals(digits, shortest)) {
      return cursor_.Fail("real has more digits than a double can tell apart",
                          "write " + shortest + " if that is near enough");
    }
    values_.push_back(Term::Real(value));
  }
  cursor_.Advance();
  return true;
}

bool TptpTermParser::ReadWord() {
  const SourcePlace place = cursor_.place();
  const auto symbol = InternWord();
  if (!symbol) return false;
  if (!cursor_.Accept(Kind::kLeftParenthesis)) {
    values_.push_back(Term::Constant(*symbol));
    return open_.empty() || CheckInterpreted(*symbol, 0, false, place);
  }
  if (open_.size() >= kDeepestNesting) return cursor_.Fail("term is nested too deeply");
  open_.push_back({*symbol, values_.size(), place});
  return true;
}

std::optional<Symbol> TptpTermParser::InternWord() {
  Symbol symbol;
  const std::string_view text = cursor_.token().text;
  if (cursor_.Is(Kind::kQuoted)) {
    const std::string word = Unquote(text);
    if (word[0] == '$' || word == "=") {
      cursor_.Fail("quoted word " + std::string(text) + " is reserved",
                   word[0] == '$' ? "a word in quotes must not begin with '$'"
                                  : "write an equation as 'a = b'");
      return std::nullopt;
    }
    symbol = symbols_.Intern(word);
  } else {
    symbol = symbols_.Intern(text);
  }
  cursor_.Advance();
  return symbol;
}

bool TptpTermParser::Close() {
  if (!cursor_.Is(Kind::kRightParenthesis)) {
    return cursor_.FailExpected("',' or ')' in the arguments of '" +
                                std::string(open_.back().function.name()) + "'");
  }
  cursor_.Advance();
  const Open open = std::move(open_.back());
  open_.pop_back();
  const auto first = values_.begin() + static_cast<std::ptrdiff_t>(open.first_argument);
  std::vector<Term> arguments(std::make_move_iterator(first),
                              std::make_move_iterator(values_.end()));
  const std::size_t arity = arguments.size();
  values_.erase(first, values_.end());
  values_.push_back(Term::Compound(open.function, std::move(arguments)));
  return open_.empty() || CheckInterpreted(open.function, arity, false, open.place);
}

bool TptpTermParser::CheckInterpreted(Symbol symbol, std::size_t arity, bool is_predicate,
                                      const SourcePlace& place) {
  const std::string_view name = symbol.name();
  if (symbol.kind() != SymbolKind::kWord || !name.starts_with('$') || name.starts_with("$$")) {
    return true;
  }
  const InterpretedName* predicate = FindInterpreted(kInterpretedPredicates, name);
  const InterpretedName* function = FindInterpreted(kInterpretedFunctions, name);
  const InterpretedName* known = is_predicate ? predicate : function;
  if (known == nullptr && (predicate != nullptr || function != nullptr)) {
    return cursor_.FailAt(place, Quote(name) + (is_predicate ? " is a function, not a predicate"
                                                             : " is a predicate, not a function"));
  }
  if (known == nullptr) {
    return cursor_.FailAt(
        place, Quote(name) + " is not an interpreted " + (is_predicate ? "predicate" : "function"),
        NearestInterpreted(name, is_predicate));
  }
  if (known->arity == arity) return true;
  return cursor_.FailAt(place, Quote(name) + " takes " + std::to_string(known->arity) +
                                   (known->arity == 1 ? " argument, not " : " arguments, not ") +
                                   std::to_string(arity));
}

bool TptpTermParser::CheckFunction(const Term& term, const SourcePlace& place) {
  if (term.is_variable() || term.is_number()) return true;
  return CheckInterpreted(term.symbol(), term.arguments().size(), false, place);
}

std::optional<Formula> TptpTermParser::ReadAtom() {
  const SourcePlace place = cursor_.place();
  if (cursor_.Is(Kind::kDollarWord)) {
    const std::string_view word = cursor_.token().text;
    if (word == "$true" || word == "$false") {
      cursor_.Advance();
      return word == "$true" ? Formula::True() : Formula::False();
    }
  }
  if (!BeginsTerm(cursor_.kind())) {
    cursor_.FailExpected("a formula");
    return std::nullopt;
  }
  const bool is_variable = cursor_.Is(Kind::kUpperWord);
  const std::string_view name = cursor_.token().text;
  const auto term = ReadTerm();
  if (!term) return std::nullopt;
  if (cursor_.Is(Kind::kEqual) || cursor_.Is(Kind::kNotEqual)) return ReadEquation(*term, place);
  if (!is_variable) return ToAtom(*term, place);
  cursor_.FailAt(place, "variable " + Quote(name) + " cannot stand for a formula",
                 PredicateHint(name));
  return std::nullopt;
}

std::optional<Formula> TptpTermParser::ReadEquation(const Term& left, const SourcePlace& place) {
  const bool positive = cursor_.Is(Kind::kEqual);
  cursor_.Advance();
  if (!CheckFunction(left, place)) return std::nullopt;
  const SourcePlace right_place = cursor_.place();
  const auto right = ReadTerm();
  if (!right || !CheckFunction(*right, right_place)) return std::nullopt;
  Formula equation = Formula::Of(Atom(equality_, {left, *right}));
  return positive ? equation : Formula::Not(std::move(equation));
}

std::optional<Formula> TptpTermParser::ToAtom(const Term& term, const SourcePlace& place) {
  if (term.is_number() || term.symbol().kind() == SymbolKind::kDistinctObject) {
    cursor_.FailAt(place, std::string(term.is_number() ? "a number" : "a distinct object") +
                              " cannot stand for a formula");
    return std::nullopt;
  }
  if (term.symbol() == distinct_) return Distinct(term, place);
  if (!CheckInterpreted(term.symbol(), term.arguments().size(), true, place)) return std::nullopt;
  return Formula::Of(Atom(term.symbol(), term.arguments()));
}

/// Every two of the arguments differ.
std::optional<Formula> TptpTermParser::Distinct(const Term& term, const SourcePlace& place) {
  const auto terms = term.arguments();
  if (terms.size() < 2 || terms.size() > kMostDistinct) {
    cursor_.FailAt(place, "'$distinct' takes 2 to " + std::to_string(kMostDistinct) +
                              " arguments, not " + std::to_string(terms.size()));
    return std::nullopt;
  }
  std::vector<Formula> pairs;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    for (std::size_t j = i + 1; j < terms.size(); ++j) {
      pairs.push_back(Formula::Not(Formula::Of(Atom(equality_, {terms[i], terms[j]}))));
    }
  }
  if (pairs.size() == 1) return std::move(pairs[0]);
  return Formula::And(std::move(pairs));
}

}  // namespace latchwork::logic

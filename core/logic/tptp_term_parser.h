// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_TPTP_TERM_PARSER_H_
#define LATCHWORK_LOGIC_TPTP_TERM_PARSER_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/logic/tptp_cursor.h"
#include "latchwork/logic/formula.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/logic/term.h"

namespace latchwork::logic {

/// Parentheses, arguments, negations and quantifiers inside each other; more are refused.
inline constexpr std::size_t kDeepestNesting = 1'000'000;

/// The variables of one formula, by the names that they have where the parser stands.
class TptpScope {
 public:
  void Clear();
  Variable Bind(std::string_view name);
  /// Ends the binding of a variable; the last bound of its name first.
  void Unbind(Variable variable);
  std::optional<Variable> Find(std::string_view name) const;
  std::size_t size() const { return names_.size(); }
  std::vector<std::string> Names() const;

 private:
  std::vector<std::string_view> names_;
  std::unordered_map<std::string_view, std::vector<Variable>> bound_;
};

/// Reads terms and atoms. On a fault it has been reported, and nothing comes back.
class TptpTermParser {
 public:
  TptpTermParser(TptpCursor& cursor, SymbolTable& symbols);

  /// With `implicit` variables, a name that is not bound is bound at its first use.
  void Begin(bool implicit);
  TptpScope& scope() { return scope_; }

  std::optional<Term> ReadTerm();
  /// p(a), a = b, a != b, $true, $false or $distinct(...).
  std::optional<Formula> ReadAtom();

 private:
  struct Open {
    Symbol function;
    std::size_t first_argument = 0;
    SourcePlace place;
  };

  /// A variable, number, constant, or a function symbol with what it takes to `open_`.
  bool ReadHead();
  bool ReadVariable();
  bool ReadNumber();
  bool ReadWord();
  bool Close();
  std::optional<Symbol> InternWord();
  bool CheckInterpreted(Symbol symbol, std::size_t arity, bool is_predicate,
                        const SourcePlace& place);
  bool CheckFunction(const Term& term, const SourcePlace& place);
  std::optional<Formula> ReadEquation(const Term& left, const SourcePlace& place);
  std::optional<Formula> ToAtom(const Term& term, const SourcePlace& place);
  std::optional<Formula> Distinct(const Term& term, const SourcePlace& place);

  TptpCursor& cursor_;
  SymbolTable& symbols_;
  Symbol equality_;
  Symbol distinct_;
  TptpScope scope_;
  bool implicit_ = false;
  std::vector<Open> open_;
  std::vector<Term> values_;
};

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_TPTP_TERM_PARSER_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_TPTP_FORMULA_PARSER_H_
#define LATCHWORK_LOGIC_TPTP_FORMULA_PARSER_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/logic/tptp_cursor.h"
#include "core/logic/tptp_term_parser.h"
#include "core/logic/tptp_types.h"
#include "latchwork/logic/formula.h"

namespace latchwork::logic {

enum class TptpLanguage : std::uint8_t { kCnf, kFof, kTff };

/// $i, $int or $real; false: it is none, which is reported.
bool ReadTptpType(TptpCursor& cursor, TptpType& type);

/// Reads formulas. What is begun and not yet ended stands on explicit stacks. On a fault it has
/// been reported, and nothing comes back.
class TptpFormulaParser {
 public:
  TptpFormulaParser(TptpCursor& cursor, SymbolTable& symbols);

  /// A formula as far as it goes; clauses come closed.
  std::optional<Formula> Read(TptpLanguage language);
  /// Indexed by the variables of the formula read last.
  std::vector<std::string> VariableNames() { return terms_.scope().Names(); }
  /// The same: what was written of their types.
  std::vector<TptpType> VariableTypes() { return std::move(types_); }

 private:
  /// `~`, `! [X] :` or `? [X] :`, waiting for its formula.
  struct Prefix {
    Formula::Kind kind = Formula::Kind::kNot;
    std::vector<Variable> variables;
  };
  /// What stands between two parentheses, as far as it was read.
  struct Group {
    std::size_t first_prefix = 0;
    std::size_t first_value = 0;
    TptpToken::Kind connective = TptpToken::Kind::kEnd;
  };
  enum class Step : std::uint8_t { kFault, kUnit, kEnd };

  bool ReadPrefixes();
  bool ReadQuantifier();
  bool ReadVariables(std::vector<Variable>& variables);
  bool ReadVariableType();
  void ApplyPrefixes();
  /// After a unit: a connective, the ends of groups, or the end of the formula.
  Step ReadAfterUnit();
  bool ReadConnective();
  bool FailMixed(TptpToken::Kind connective);
  bool FailUnclosed();
  void CloseGroup();
  std::optional<Formula> ToClause(const Formula& formula, const SourcePlace& place);

  TptpCursor& cursor_;
  TptpTermParser terms_;
  TptpLanguage language_ = TptpLanguage::kFof;
  std::vector<Prefix> prefixes_;
  std::vector<Group> groups_;
  std::vector<Formula> values_;
  std::vector<TptpType> types_;
};

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_TPTP_FORMULA_PARSER_H_

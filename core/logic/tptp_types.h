// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_TPTP_TYPES_H_
#define LATCHWORK_LOGIC_TPTP_TYPES_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "latchwork/logic/symbol.h"
#include "latchwork/logic/tptp.h"

namespace latchwork::logic {

/// The types that tff names. kNone: none was written.
enum class TptpType : std::uint8_t { kNone, kIndividual, kInteger, kReal, kTruth };

/// tff(name, type, symbol: (arguments) > result).
struct TptpDeclaration {
  std::string name;
  Symbol symbol;
  std::vector<TptpType> arguments;
  TptpType result = TptpType::kIndividual;
  SourcePlace place;
};

/// What a text says of types.
struct TptpTypes {
  std::vector<TptpDeclaration> declarations;
  /// Of each formula the types of its variables, by number; nothing for cnf and fof.
  std::vector<std::optional<std::vector<TptpType>>> variables;
};

/// Reports where the tff formulas of `file`, read without a fault, use a symbol or a variable with
/// two types; what is not declared has the type that its uses give it. Where reading the formulas
/// without types would say more than they do with them, conditions keep the types apart:
/// - a variable for integers that is compared, computed with or equated is `$is_int`, in a file
/// with
///   reals;
/// - a variable for individuals is one, in a file with numbers where clauses equate such a
/// variable;
///   axioms, with the names of the declarations, say so of the functions.
/// Source: Claessen, Lilliestroem, Smallbone: Sort It Out with Monotonicity (CADE 2011), of which
/// this takes the plainest case.
void KeepTypes(TptpFile& file, const TptpTypes& types, SymbolTable& symbols);

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_TPTP_TYPES_H_

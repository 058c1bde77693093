// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_FORMATS_CIRC_FILE_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_FORMATS_CIRC_FILE_H_

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "latchwork/logic/diagnostic.h"
#include "reasoners/circumscription/formats/statement_reader.h"
#include "reasoners/circumscription/theory/ground_theory.h"

namespace latchwork::circumscription {

/// A ground theory in text: `p circ ATOMS CLAUSES`, then lines `P LEVEL atoms 0`, `Z atoms 0`,
/// `Q atoms 0`, clauses as in DIMACS, `n ATOM NAME`, facts `F literals 0`, and queries
/// `? ID c|b literals 0`. Expected answers (`=` and `x` lines) end what is read.
struct CircFile {
  GroundTheory theory;
  std::vector<Literal> facts;
  std::vector<Query> queries;
  logic::Diagnostics diagnostics;  ///< Where there are any, the rest must not be used.
};

/// Reads any bytes; all errors are reported, `max_diagnostics` at most.
CircFile ReadCirc(std::string_view text, std::string_view name, std::size_t max_diagnostics = 100);

/// Facts over fixed atoms are latches. The others become clauses of the theory: what search learns
/// holds for one set of them only.
std::vector<Literal> MoveFacts(std::span<const Literal> facts, GroundTheory& theory);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_FORMATS_CIRC_FILE_H_

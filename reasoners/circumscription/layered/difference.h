// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_LAYERED_DIFFERENCE_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_LAYERED_DIFFERENCE_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "reasoners/circumscription/layered/layered_models.h"
#include "reasoners/circumscription/layered/layered_theory.h"
#include "reasoners/circumscription/layered/procedure.h"

namespace latchwork::circumscription {

/// How the procedure's answer differs from that of Definition 1.
enum class Fault : std::uint8_t {
  kUnsound,     ///< The procedure concludes what some layered model falsifies.
  kIncomplete,  ///< It does not conclude what all of them satisfy.
};
std::string_view Name(Fault fault);

/// Nothing: they agree, or one of them is unknown.
std::optional<Fault> Compare(Verdict procedure, Verdict definition);

/// A layered theory on which the two differ.
struct CounterExample {
  LayeredTheory theory;
  std::vector<Literal> clause;  ///< What was asked of the lowest layer.
};

/// Leaves out clauses, facts, bridges, literals of the query, layers and atoms as long as the
/// procedure still errs in the same way. In the result no clause, fact, bridge or literal can be
/// left out alone. Precondition: it errs so on `example`.
CounterExample Shrink(CounterExample example, Transfer transfer, Fault fault,
                      const ProcedureOptions& options = {});

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_LAYERED_DIFFERENCE_H_

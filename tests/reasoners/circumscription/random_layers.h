// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_RANDOM_LAYERS_H_
#define LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_RANDOM_LAYERS_H_

#include <vector>

#include "reasoners/circumscription/layered/layered_theory.h"
#include "tests/reasoners/circumscription/random_theory.h"

namespace latchwork::circumscription {

/// Two to four layers, definite or general, with one or two bridges between neighbours; at most 15
/// atoms, an ab for each bridge among them.
LayeredTheory RandomLayers(Dice& dice);

/// Every clause and fact has exactly one literal that is not negated.
bool IsDefinite(const TheoryLayer& layer);

/// Each literal of the lowest layer, and some clauses.
std::vector<Clause> LayeredQueries(Dice& dice, const LayeredTheory& theory);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_RANDOM_LAYERS_H_

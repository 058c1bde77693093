// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/brooks/behaviour.h"

#include <cmath>

namespace latchwork::brooks {

double BodyNumber(const sdk::Body& body, std::string_view name, double otherwise) {
  for (const logic::Fact& fact : body.facts) {
    if (fact.predicate().name() == name && fact.arity() == 1 && fact.argument(0).is_number()) {
      return fact.argument(0).number();
    }
  }
  return otherwise;
}

double WrapAngle(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

}  // namespace latchwork::brooks

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_BROOKS_BEHAVIOUR_H_
#define LATCHWORK_BROOKS_BEHAVIOUR_H_

#include <cstdint>
#include <memory>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

#include "latchwork/sdk/random.h"
#include "latchwork/sdk/reasoner.h"

namespace latchwork::brooks {

/// What changes the mind of a robot that has nothing to do.
struct Whims {
  sdk::RandomStream random{1, "whims"};
  bool active = false;
  std::uint64_t every = 50;  ///< Cycles that a direction is kept.
};

/// Senses to acts, without a model, a plan or a memory but a count of cycles.
class Behaviour {
 public:
  virtual ~Behaviour() = default;
  /// Appends what to do now.
  virtual void Act(std::span<const sdk::Latch> latches, std::vector<logic::Fact>& acts) = 0;
};

/// avoid and wander: sonar, robot, objects in; fwd, turn, halt out.
std::unique_ptr<Behaviour> MakeAvoid(const sdk::Body& body, const Whims& whims,
                                     logic::SymbolTable& symbols);
/// explore: pose, destination in; object, distance, direction out.
std::unique_ptr<Behaviour> MakeExplore(const sdk::Body& body, const Whims& whims,
                                       logic::SymbolTable& symbols);

/// A parameter of the layer, which its body holds as a fact of that name.
double BodyNumber(const sdk::Body& body, std::string_view name, double otherwise);
/// Into (-pi, pi].
double WrapAngle(double angle);

/// Calls `visit` with the arguments of each fact of the predicate.
template <typename Visit>
void ForEachFact(std::span<const sdk::Latch> latches, logic::PredicateName name, Visit visit) {
  for (const sdk::Latch& latch : latches) {
    for (const logic::Fact& fact : latch.facts) {
      if (logic::NameOf(fact) == name) visit(fact.arguments());
    }
  }
}

}  // namespace latchwork::brooks

#endif  // LATCHWORK_BROOKS_BEHAVIOUR_H_

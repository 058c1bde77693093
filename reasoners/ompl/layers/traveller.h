// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_LAYERS_TRAVELLER_H_
#define LATCHWORK_OMPL_LAYERS_TRAVELLER_H_

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reasoners/ompl/layers/route.h"

namespace latchwork::planning {

/// What a traveller is about to do.
struct Outlook {
  FoundPath::State state = FoundPath::State::kNone;
  logic::Symbol next;      ///< On foot: the landmark to go to. By elevator: the one to get out at.
  logic::Symbol elevator;  ///< Null: on foot.
};

/// Keeps a route over landmarks and goes along it; plans anew when the target, the doors or the
/// elevators in service are others, or the robot is elsewhere.
class Traveller {
 public:
  Traveller(const JobSetup& setup, logic::SymbolTable& symbols);

  /// A landmark that the map lacks, as a message; empty: none.
  std::string Unknown(logic::Symbol landmark) const;
  const Place& PlaceOf(logic::Symbol landmark) const { return setup_.map->landmarks.at(landmark); }
  /// How to go on from landmark `here`; on foot in steps of the latches' adjacent/2.
  Outlook Look(const LatchFacts& latches, logic::Symbol here, logic::Symbol target, Effort& effort);
  /// As the latches of the last Look, or of this call, have it.
  const Building& Observe(const LatchFacts& latches);

 private:
  bool GoOn(logic::Symbol here);
  bool StillRides(const Stage& stage, logic::Symbol here) const;
  void KeepTo(logic::Symbol target);
  logic::Symbol NextOnFoot(const LatchFacts& latches, const Stage& stage) const;

  JobSetup setup_;
  Legs legs_;
  logic::Symbol adjacent_, elevator_front_, cab_, elevator_at_, out_of_order_, door_shut_;
  Building building_;
  std::vector<Stage> stages_;  ///< What is left of the route.
  logic::Symbol target_;
  std::vector<logic::Symbol> closed_;  ///< When the route was planned.
};

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_LAYERS_TRAVELLER_H_

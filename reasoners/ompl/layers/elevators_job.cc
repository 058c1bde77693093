// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "reasoners/ompl/layers/job.h"
#include "reasoners/ompl/layers/traveller.h"

namespace latchwork::planning {
namespace {

using logic::Fact;
using logic::Symbol;
using logic::Term;

class ElevatorsJob final : public Job {
 public:
  ElevatorsJob(const JobSetup& setup, logic::SymbolTable& symbols)
      : traveller_(setup, symbols),
        curr_landmark_(symbols.Intern("curr_landmark")),
        target_landmark_(symbols.Intern("target_landmark")),
        elevator_open_(symbols.Intern("elevator_open")),
        inside_(symbols.Intern("inside")),
        move_cmd_(symbols.Intern("move_cmd")),
        call_(symbols.Intern("call")),
        ride_(symbols.Intern("ride")) {}

  Verdict Decide(const LatchFacts& latches, Effort& effort) override {
    const Fact* const place = latches.First({curr_landmark_, 1});
    const Fact* const command = latches.First({target_landmark_, 1});
    if (place == nullptr || command == nullptr) return {};
    const Symbol here = place->argument(0).symbol();
    const Symbol target = command->argument(0).symbol();
    for (const Symbol landmark : {here, target}) {
      std::string message = traveller_.Unknown(landmark);
      if (!message.empty()) return {FoundPath::State::kNone, {}, std::move(message)};
    }
    const Elevator* const cab = CabAt(traveller_.Observe(latches), here);
    // Once out of a cab, it goes on to the target even if the elevator leaves behind its back.
    if (here == target || (cab != nullptr && !Holds(latches, inside_, cab->name))) {
      return Done({MoveTo(target)});
    }
    const Outlook outlook = traveller_.Look(latches, here, target, effort);
    if (outlook.state != FoundPath::State::kFound) return {outlook.state, {}, {}};
    if (!outlook.elevator) return Done({MoveTo(outlook.next)});
    return Done(ByElevator(latches, here, outlook));
  }

 private:
  static Verdict Done(std::vector<Fact> facts) {
    return {FoundPath::State::kFound, std::move(facts), {}};
  }
  static bool Holds(const LatchFacts& latches, Symbol predicate, Symbol elevator) {
    return latches.Holds(Fact(predicate, {Term::Constant(elevator)}));
  }
  static const Elevator* CabAt(const Building& building, Symbol landmark) {
    for (const Elevator& elevator : building.elevators) {
      if (elevator.cab == landmark) return &elevator;
    }
    return nullptr;
  }

  Fact MoveTo(Symbol landmark) const {
    const Point at = traveller_.PlaceOf(landmark).at;
    return Fact(move_cmd_, {Term::Real(at.x), Term::Real(at.y)});
  }

  /// In when it stands open here, out when it stands open there; a button until then.
  std::vector<Fact> ByElevator(const LatchFacts& latches, Symbol here, const Outlook& outlook) {
    const auto& elevators = traveller_.Observe(latches).elevators;
    const Elevator& elevator =
        *std::find_if(elevators.begin(), elevators.end(),
                      [&](const Elevator& each) { return each.name == outlook.elevator; });
    const bool in_cab = elevator.cab == here;
    const std::int64_t wanted = traveller_.PlaceOf(in_cab ? outlook.next : here).floor;
    const bool is_there = elevator.at == wanted;
    if (is_there && Holds(latches, elevator_open_, elevator.name)) {
      return {MoveTo(in_cab ? outlook.next : elevator.cab)};
    }
    std::vector<Fact> facts{MoveTo(here)};
    if (in_cab && is_there) return facts;
    facts.push_back(
        Fact(in_cab ? ride_ : call_, {Term::Constant(elevator.name), Term::Integer(wanted)}));
    return facts;
  }

  Traveller traveller_;
  Symbol curr_landmark_, target_landmark_, elevator_open_, inside_, move_cmd_, call_, ride_;
};

}  // namespace

std::unique_ptr<Job> MakeElevatorsJob(const JobSetup& setup, logic::SymbolTable& symbols) {
  return std::make_unique<ElevatorsJob>(setup, symbols);
}

}  // namespace latchwork::planning

// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/office_events.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace latchwork::office {

namespace {

using logic::Fact;
using logic::Term;

constexpr double kLargestBox = 5.0;  // m

std::string NameAt(const Fact& event, std::size_t index) {
  return std::string(event.argument(index).symbol().name());
}

std::string ShutDoor(const Fact& event, OfficeState& state) {
  const auto door = state.building.FindDoor(NameAt(event, 0));
  if (!door) return "the building has no door '" + NameAt(event, 0) + "'";
  state.ShutDoorOnceClear(*door);
  return {};
}

std::string OpenDoor(const Fact& event, OfficeState& state) {
  const auto door = state.building.FindDoor(NameAt(event, 0));
  if (!door) return "the building has no door '" + NameAt(event, 0) + "'";
  state.SetDoor(*door, false);
  return {};
}

std::string SetService(const Fact& event, OfficeState& state, bool in_service) {
  const auto elevator = state.building.FindElevator(NameAt(event, 0));
  if (!elevator) return "the building has no elevator '" + NameAt(event, 0) + "'";
  state.elevators[*elevator].SetInService(in_service);
  return {};
}

std::string Fail(const Fact& event, OfficeState& state) { return SetService(event, state, false); }
std::string Repair(const Fact& event, OfficeState& state) { return SetService(event, state, true); }

std::string PutBox(const Fact& event, OfficeState& state) {
  const auto floor = state.building.FindFloor(event.argument(0).integer());
  const double half = event.argument(3).number() / 2;
  const double x = event.argument(1).number();
  const double y = event.argument(2).number();
  if (!floor) return "the building has no floor " + logic::ToString(event.argument(0));
  if (!(half > 0.0 && half <= kLargestBox / 2)) return "a box measures more than 0 and at most 5 m";
  const Box box{*floor, {x - half, y - half, x + half, y + half}};
  if (*floor == state.floor && Distance(state.place(), box.area) <= state.reach()) {
    return "the robot is where the box is put";
  }
  state.PutBox(box);
  return {};
}

std::string SetSonar(const Fact& event, OfficeState& state, bool failed) {
  const auto number = event.argument(0).integer();
  if (number < 0 || number >= state.sonars->size()) {
    return "the robot has no sonar " + std::to_string(number);
  }
  state.sonars->SetFailed(static_cast<int>(number), failed);
  return {};
}

std::string FailSonar(const Fact& event, OfficeState& state) {
  return SetSonar(event, state, true);
}
std::string RepairSonar(const Fact& event, OfficeState& state) {
  return SetSonar(event, state, false);
}

std::string ChangeGoal(const Fact& event, OfficeState& state) {
  const auto goal = state.building.FindLandmark(NameAt(event, 0));
  if (!goal) return "the building has no landmark '" + NameAt(event, 0) + "'";
  state.goal = goal;
  return {};
}

struct Handler {
  std::string_view name;
  std::string (*apply)(const Fact&, OfficeState&);
};

constexpr std::array<Handler, 8> kHandlers{{{"door_shuts", &ShutDoor},
                                            {"door_opens", &OpenDoor},
                                            {"out_of_order", &Fail},
                                            {"in_service", &Repair},
                                            {"box_put", &PutBox},
                                            {"sonar_fails", &FailSonar},
                                            {"sonar_recovers", &RepairSonar},
                                            {"goal_changes", &ChangeGoal}}};

std::string_view KindOf(sdk::ArgumentType type) {
  if (type == sdk::ArgumentType::kSymbol) return "name";
  return type == sdk::ArgumentType::kInteger ? "whole number" : "number";
}

bool Fits(const Term& term, sdk::ArgumentType type) {
  if (type == sdk::ArgumentType::kSymbol) return term.kind() == Term::Kind::kConstant;
  if (type == sdk::ArgumentType::kInteger) return term.kind() == Term::Kind::kInteger;
  return term.is_number() && std::abs(term.number()) < 1e6;
}

}  // namespace

std::string ApplyEvent(const Fact& event, std::span<const sdk::PredicateSpec> known,
                       OfficeState& state) {
  const auto name = event.predicate().name();
  const auto spec =
      std::find_if(known.begin(), known.end(), [&](const auto& s) { return s.name == name; });
  const auto handler = std::find_if(kHandlers.begin(), kHandlers.end(),
                                    [&](const Handler& h) { return h.name == name; });
  if (spec == known.end() || handler == kHandlers.end() ||
      spec->arguments.size() != event.arity()) {
    return "the office knows no event '" + logic::ToString(event) + "'";
  }
  for (std::size_t i = 0; i < event.arity(); ++i) {
    const auto type = spec->arguments[i].type;
    if (Fits(event.argument(i), type)) continue;
    return "argument " + std::to_string(i + 1) + " of '" + std::string(name) + "' must be a " +
           std::string(KindOf(type));
  }
  return handler->apply(event, state);
}

}  // namespace latchwork::office

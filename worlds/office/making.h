// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_MAKING_H_
#define LATCHWORK_OFFICE_MAKING_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/parameters.h"
#include "latchwork/sdk/random.h"
#include "latchwork/sdk/world.h"
#include "worlds/office/office_state.h"

namespace latchwork::office {

/// What the steps of MakeOffice share: what they read, the run that they set up, and the mistakes
/// that they find. A step reports all its mistakes and leaves something harmless behind.
struct Making {
  const sdk::WorldSetup& setup;
  const sdk::Parameters& parameters;
  sdk::RandomStream random;
  OfficeState& state;
  logic::Diagnostics diagnostics;

  const Building& building() const { return state.building; }
  void Fail(std::string_view parameter, std::string message, std::string hint = {});
  /// A name that the building does not have; `known` are those that it has.
  void FailName(std::string_view parameter, std::string_view kind, std::string_view name,
                const std::vector<std::string>& known);
};

/// Puts the robot where the parameters say, or anywhere by seed.
void PlaceRobot(Making& making);
/// Shuts doors by seed so that a way from the start to the goal is left.
void ShutDoorsBySeed(Making& making);
/// The boxes that were declared, and those by seed.
void PutBoxes(Making& making);

std::vector<std::string_view> Words(std::string_view text, std::string_view separators = " ,\t\n");
/// The finite number that a whole word is.
std::optional<double> Number(std::string_view text);

template <typename Items>
std::vector<std::string> NamesOf(const Items& items) {
  std::vector<std::string> names;
  names.reserve(items.size());
  for (const auto& item : items) names.emplace_back(item.name.name());
  return names;
}

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_MAKING_H_

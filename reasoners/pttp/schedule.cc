// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/schedule.h"

#include <algorithm>
#include <array>

namespace latchwork::pttp {
namespace {

using Method = NamedStrategy::Method;

constexpr std::array kStrategies{
    NamedStrategy{.name = "complete",
                  .tableau = {},
                  .complete = true,
                  .help = "tableau, everything is tried again; from the negative clauses"},
    NamedStrategy{.name = "goal",
                  .tableau = {.start = Start::kConjecture},
                  .help = "the same from the conjecture"},
    NamedStrategy{.name = "fewest",
                  .tableau = {.order = BodyOrder::kFewest},
                  .complete = true,
                  .help = "the same, subgoals with the fewest connections first"},
    NamedStrategy{.name = "cut",
                  .tableau = {.cut = Cut::kExclusive, .start = Start::kConjecture},
                  .help = "tableau from the conjecture; solved subgoals are not solved again"},
    NamedStrategy{.name = "cut-positive",
                  .tableau = {.cut = Cut::kExclusive, .start = Start::kPositive},
                  .help = "the same from the positive clauses"},
    NamedStrategy{.name = "cut-all",
                  .tableau = {.cut = Cut::kInclusive, .start = Start::kConjecture},
                  .help = "the same, and a solved goal is not solved by another step either"},
    NamedStrategy{.name = "saturate",
                  .method = Method::kSaturation,
                  .complete = true,
                  .help = "superposition"},
    NamedStrategy{.name = "engine",
                  .method = Method::kEngine,
                  .complete = true,
                  .help = "the machine of the control loop, which computes with numbers"},
};

std::vector<Slice> Slices(std::initializer_list<std::pair<std::string_view, double>> parts) {
  std::vector<Slice> slices;
  for (const auto& [name, share] : parts) slices.push_back({FindStrategy(name), share});
  return slices;
}

}  // namespace

std::span<const NamedStrategy> Strategies() { return kStrategies; }

const NamedStrategy* FindStrategy(std::string_view name) {
  const auto place = std::find_if(kStrategies.begin(), kStrategies.end(),
                                  [&](const auto& strategy) { return strategy.name == name; });
  return place == kStrategies.end() ? nullptr : place;
}

std::vector<Slice> ScheduleFor(const ProverProblem& problem) {
  if (problem.has_arithmetic) return Slices({{"engine", 1}});
  if (problem.has_equality) {
    return Slices({{"complete", 0.03},
                   {"cut", 0.07},
                   {"saturate", 0.5},
                   {"goal", 0.1},
                   {"cut-all", 0.1},
                   {"cut-positive", 0.1},
                   {"fewest", 0.1}});
  }
  return Slices({{"goal", 0.1},
                 {"cut", 0.1},
                 {"saturate", 0.3},
                 {"complete", 0.2},
                 {"cut-positive", 0.1},
                 {"cut-all", 0.05},
                 {"fewest", 0.15}});
}

}  // namespace latchwork::pttp

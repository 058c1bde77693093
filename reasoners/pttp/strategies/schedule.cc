// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/strategies/schedule.h"

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
    NamedStrategy{.name = "plain",
                  .tableau = {.lemmata = false, .prune = false},
                  .complete = true,
                  .help = "the same as `complete` without lemmata and pruning, to compare with"},
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
                  .help = "superposition from all clauses"},
    NamedStrategy{.name = "saturate-goal",
                  .method = Method::kSaturation,
                  .saturation = {.selection = saturation::Selection::kLargest,
                                 .precedence = saturation::Precedence::kArity,
                                 .size_picks = 0,
                                 .goal_picks = 5,
                                 .age_picks = 1,
                                 .goal_first = true},
                  .complete = true,
                  .help = "the same, what descends from the conjecture first"},
    NamedStrategy{.name = "saturate-relevant",
                  .method = Method::kSaturation,
                  .saturation = {.selection = saturation::Selection::kMaximal,
                                 .relevance_depth = 2,
                                 .relevance_tolerance = 2},
                  .help = "the same with only the axioms that share symbols with the conjecture"},
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
  constexpr std::size_t kManyClauses = 400;
  if (problem.has_arithmetic) return Slices({{"engine", 1}});
  std::vector<Slice> slices = problem.has_equality ? Slices({{"complete", 0.02},
                                                             {"cut", 0.05},
                                                             {"saturate", 0.45},
                                                             {"saturate-goal", 0.15},
                                                             {"goal", 0.08},
                                                             {"cut-all", 0.08},
                                                             {"cut-positive", 0.08},
                                                             {"fewest", 0.05}})
                                                   : Slices({{"goal", 0.08},
                                                             {"cut", 0.08},
                                                             {"saturate", 0.35},
                                                             {"saturate-goal", 0.1},
                                                             {"complete", 0.15},
                                                             {"cut-positive", 0.08},
                                                             {"cut-all", 0.05},
                                                             {"fewest", 0.1}});
  if (problem.input_size >= kManyClauses) {
    slices.insert(slices.begin() + 2, {FindStrategy("saturate-relevant"), 0.1});
  }
  return slices;
}

}  // namespace latchwork::pttp

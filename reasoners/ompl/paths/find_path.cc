// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/paths/find_path.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "reasoners/ompl/paths/ompl_query.h"

namespace latchwork::planning {
namespace {

/// The ends as they were asked for, where they had to be moved.
Path WithEnds(Path path, Point from, Point to) {
  if (path.front() != from) path.insert(path.begin(), from);
  if (path.back() != to) path.push_back(to);
  if (path.size() == 1) path.push_back(to);
  return path;
}

/// Of as many tries as the settings say. Those after the first path may spend as much again.
Path ShortestOf(PlannerQuestion question, Effort& effort) {
  const auto tries = static_cast<std::uint64_t>(question.settings.tries);
  const std::uint64_t begin = effort.spent();
  question.effort_end = begin + question.settings.effort;
  Path best;
  for (std::uint64_t i = 0; i < tries; ++i) {
    if (effort.limit() != sdk::Limit::kNone || effort.spent() >= question.effort_end) break;
    question.attempt = question.settings.attempt * tries + i;
    Path path = AskPlanner(question, effort);
    if (path.size() < 2) continue;
    if (best.empty()) {
      question.effort_end =
          std::min(question.effort_end, effort.spent() + (effort.spent() - begin));
    }
    if (best.empty() || Length(path) < Length(best)) best = std::move(path);
  }
  return best;
}

}  // namespace

double Length(const Path& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length += Distance(path[i - 1], path[i]);
  return length;
}

FoundPath FindPath(const FreeSpace& space, const PathStart& from, Point to,
                   const PathSettings& settings, Effort& effort) {
  const auto start = space.NearestFree(from.at, settings.snap);
  const auto goal = space.NearestFree(to, settings.snap);
  if (!start || !goal || !space.MayConnect(*start, *goal)) return {FoundPath::State::kNone, {}};
  if (!effort.Spend()) return {FoundPath::State::kUnknown, {}};
  if (settings.space != SpaceKind::kReedsShepp && space.IsFree(*start, *goal)) {
    return {FoundPath::State::kFound, WithEnds({*start, *goal}, from.at, to)};
  }
  Path best = ShortestOf({space, {*start, from.heading}, *goal, settings}, effort);
  if (best.empty()) return {FoundPath::State::kUnknown, {}};
  return {FoundPath::State::kFound, WithEnds(std::move(best), from.at, to)};
}

}  // namespace latchwork::planning

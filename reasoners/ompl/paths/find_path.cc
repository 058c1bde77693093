// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/paths/find_path.h"

#include <optional>

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

}  // namespace

double Length(const Path& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length += Distance(path[i - 1], path[i]);
  return length;
}

FoundPath FindPath(const FreeSpace& space, Point from, Point to, const PathSettings& settings,
                   Effort& effort) {
  const auto start = space.NearestFree(from, settings.snap);
  const auto goal = space.NearestFree(to, settings.snap);
  if (!start || !goal || !space.MayConnect(*start, *goal)) return {FoundPath::State::kNone, {}};
  effort.Spend();
  if (settings.space != SpaceKind::kReedsShepp && space.IsFree(*start, *goal)) {
    return {FoundPath::State::kFound, WithEnds({*start, *goal}, from, to)};
  }
  Path best;
  const std::uint64_t end = effort.spent() + settings.effort;
  for (int i = 0; i < settings.tries; ++i) {
    if (effort.limit() != sdk::Limit::kNone || effort.spent() >= end) break;
    Path path = AskPlanner({space, *start, *goal, settings, i, end}, effort);
    if (path.size() >= 2 && (best.empty() || Length(path) < Length(best))) best = std::move(path);
  }
  if (best.empty()) return {FoundPath::State::kUnknown, {}};
  return {FoundPath::State::kFound, WithEnds(std::move(best), from, to)};
}

}  // namespace latchwork::planning

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_WORLDS_GARDEN_FIXED_ROUND_H_
#define LATCHWORK_TESTS_WORLDS_GARDEN_FIXED_ROUND_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "worlds/garden/garden_state.h"

namespace latchwork::garden {

/// A gardener that looks neither at the soil nor at the sky: every day it uncovers all beds, gives
/// each the same water, food on every seventh day, and covers them in the evening.
class FixedRound {
 public:
  struct Plan {
    double litres = 20;        ///< For each bed and day.
    int feed_every = 7;        ///< days
    bool covers = true;        ///< In the evening.
    double cover_from = 16.5;  ///< hour
  };

  FixedRound(const Plan& plan, std::size_t beds) : plan_(plan), beds_(beds) {}

  std::optional<Task> operator()(const GardenState& state) {
    if (state.day() != day_) Begin(state);
    if (plan_.covers && state.clock() >= plan_.cover_from && !covering_) {
      covering_ = true;
      steps_.clear();
      next_ = 0;
      for (std::size_t bed = 0; bed < beds_; ++bed) Add(Task::Kind::kCover, bed);
    }
    while (next_ < steps_.size() && IsDone(state)) Next(state);
    if (next_ >= steps_.size()) return std::nullopt;
    const Step& step = steps_[next_];
    if (state.gardener.place(beds_) != step.place) return Task{Task::Kind::kWalk, step.place};
    return Task{step.kind, kWell};
  }

 private:
  struct Step {
    Task::Kind kind;
    std::size_t place;
  };

  void Add(Task::Kind kind, std::size_t place) { steps_.push_back({kind, place}); }

  void Begin(const GardenState& state) {
    day_ = state.day();
    covering_ = false;
    steps_.clear();
    next_ = 0;
    if (plan_.covers) {
      for (std::size_t bed = 0; bed < beds_; ++bed) Add(Task::Kind::kUncover, bed);
    }
    for (std::size_t bed = 0; bed < beds_; ++bed) {
      Add(Task::Kind::kFill, kWell);
      Add(Task::Kind::kPour, bed);
      if (plan_.feed_every > 0 && day_ % plan_.feed_every == 0) Add(Task::Kind::kFeed, bed);
    }
    Mark(state);
  }

  void Mark(const GardenState& state) {
    poured_ = state.gardener.poured();
    portions_ = state.gardener.portions();
  }
  void Next(const GardenState& state) {
    ++next_;
    Mark(state);
  }

  bool IsDone(const GardenState& state) const {
    const Step& step = steps_[next_];
    switch (step.kind) {
      case Task::Kind::kFill:
        return state.gardener.water() >= state.gardener.options().tank || state.barrel.water < 0.5;
      case Task::Kind::kPour:
        return state.gardener.poured() >= poured_ + plan_.litres || (state.gardener.water() <= 0);
      case Task::Kind::kFeed:
        return state.gardener.portions() < portions_ || portions_ == 0;
      case Task::Kind::kCover:
        return state.beds[step.place].covered();
      case Task::Kind::kUncover:
        return !state.beds[step.place].covered();
      default:
        return true;
    }
  }

  Plan plan_;
  std::size_t beds_;
  int day_ = -1;
  bool covering_ = false;
  std::vector<Step> steps_;
  std::size_t next_ = 0;
  double poured_ = 0;
  int portions_ = 0;
};

/// What a season comes to.
struct Harvest {
  int alive = 0;
  int plants = 0;
  double weight = 0;
};

/// A whole season by a policy, in steps of five minutes.
template <typename Policy>
Harvest RunSeason(GardenState& state, int days, Policy policy) {
  while (state.hour < 24.0 * days) state.Step(policy(state), 300);
  return {state.Alive(), state.Plants(), state.Weight()};
}

}  // namespace latchwork::garden

#endif  // LATCHWORK_TESTS_WORLDS_GARDEN_FIXED_ROUND_H_

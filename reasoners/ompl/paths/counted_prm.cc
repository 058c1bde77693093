// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/paths/counted_prm.h"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/goals/GoalSampleableRegion.h>

namespace latchwork::planning {
namespace {

namespace ob = ::ompl::base;

constexpr int kGrowRounds = 40;
constexpr int kExpandRounds = 4;

/// True after `rounds` questions, or when `stop` is.
ob::PlannerTerminationCondition Rounds(const ob::PlannerTerminationCondition& stop, int rounds) {
  return ob::PlannerTerminationCondition(
      [&stop, rounds]() mutable { return stop() || rounds-- <= 0; });
}

}  // namespace

bool CountedPrm::AddEnds() {
  while (const ob::State* start = pis_.nextStart()) {
    startM_.push_back(addMilestone(si_->cloneState(start)));
  }
  while (const ob::State* goal = pis_.nextGoal()) {
    goalM_.push_back(addMilestone(si_->cloneState(goal)));
  }
  return !startM_.empty() && !goalM_.empty();
}

void CountedPrm::Extend(const ob::PlannerTerminationCondition& stop) {
  growRoadmap(Rounds(stop, kGrowRounds));
  expandRoadmap(Rounds(stop, kExpandRounds));
}

ob::PlannerStatus CountedPrm::solve(const ob::PlannerTerminationCondition& stop) {
  checkValidity();
  bestCost_ = opt_->infiniteCost();
  if (!AddEnds()) return ob::PlannerStatus::INVALID_START;
  ob::PathPtr path;
  while (!maybeConstructSolution(startM_, goalM_, path) && !stop()) Extend(stop);
  if (!path) return ob::PlannerStatus::TIMEOUT;
  ob::PlannerSolution solution(path);
  solution.setPlannerName(getName());
  pdef_->addSolutionPath(solution);
  return ob::PlannerStatus::EXACT_SOLUTION;
}

}  // namespace latchwork::planning

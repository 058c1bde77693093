// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_PATHS_COUNTED_PRM_H_
#define LATCHWORK_OMPL_PATHS_COUNTED_PRM_H_

#include <ompl/geometric/planners/prm/PRM.h>

namespace latchwork::planning {

/// PRM that grows and expands its roadmap by numbers of milestones and then looks for a way. OMPL's
/// own takes turns by the clock and looks from a second thread, so that its runs do not repeat.
class CountedPrm final : public ::ompl::geometric::PRM {
 public:
  CountedPrm(const ::ompl::base::SpaceInformationPtr& space, bool star) : PRM(space, star) {}

  ::ompl::base::PlannerStatus solve(const ::ompl::base::PlannerTerminationCondition& stop) override;

 private:
  bool AddEnds();
  void Extend(const ::ompl::base::PlannerTerminationCondition& stop);
};

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_PATHS_COUNTED_PRM_H_

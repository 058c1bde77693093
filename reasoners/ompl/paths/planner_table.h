// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_PATHS_PLANNER_TABLE_H_
#define LATCHWORK_OMPL_PATHS_PLANNER_TABLE_H_

#include <ompl/base/Planner.h>
#include <ompl/base/SpaceInformation.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latchwork/logic/diagnostic.h"

namespace latchwork::planning {

/// The planners that stop when told to and repeat with their seed. Left out are those of OMPL that
/// start threads, and those that read the clock.
std::vector<std::string> PlannerNames();

/// A name of the table.
::ompl::base::PlannerPtr MakePlanner(std::string_view name,
                                     const ::ompl::base::SpaceInformationPtr& space);

using PlannerOptions = std::vector<std::pair<std::string, std::string>>;

/// "range=2 goal_bias=0.1". What OMPL's planner of this name does not know or suggest as a value is
/// a diagnostic at `place`.
PlannerOptions ReadPlannerOptions(std::string_view text, std::string_view planner,
                                  const logic::SourcePlace& place, logic::Diagnostics& diagnostics);

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_PATHS_PLANNER_TABLE_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_OMPL_OPTIONS_H_
#define LATCHWORK_OMPL_OMPL_OPTIONS_H_

#include <span>

#include "latchwork/sdk/contract.h"
#include "latchwork/sdk/parameters.h"
#include "reasoners/ompl/layers/job.h"

namespace latchwork::planning {

/// The parameters of the reasoner.
std::span<const sdk::ParameterSpec> OmplOptions();
/// All but the map. What the planner does not understand is a diagnostic.
JobSetup SetupFrom(const sdk::Parameters& values, logic::Diagnostics& diagnostics);

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_OMPL_OPTIONS_H_

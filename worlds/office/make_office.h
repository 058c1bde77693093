// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_MAKE_OFFICE_H_
#define LATCHWORK_OFFICE_MAKE_OFFICE_H_

#include <memory>

#include "latchwork/logic/diagnostic.h"
#include "latchwork/sdk/parameters.h"
#include "latchwork/sdk/world.h"
#include "worlds/office/office_state.h"

namespace latchwork::office {

struct MadeOffice {
  std::unique_ptr<OfficeState> state;  ///< Null when there are diagnostics.
  logic::Diagnostics diagnostics;
};

/// Sets up a run from parameters that passed OfficeParameters; every mistake with the place of its
/// parameter.
MadeOffice MakeOffice(const sdk::WorldSetup& setup, const sdk::Parameters& parameters);

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_MAKE_OFFICE_H_

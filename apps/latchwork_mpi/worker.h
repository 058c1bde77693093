// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_MPI_WORKER_H_
#define LATCHWORK_APPS_LATCHWORK_MPI_WORKER_H_

#include "apps/compare/runs/launch.h"
#include "apps/latchwork_mpi/mpi_link.h"

namespace latchwork::mpi {

enum class Ending { kTogether, kLeave, kMasterSilent };

/// Makes the runs that the master, process 0, gives it, until it is sent away or the master has
/// been silent for `endurance` seconds.
Ending Work(MpiLink& link, const compare::Launch& launch, double endurance_seconds);

}  // namespace latchwork::mpi

#endif  // LATCHWORK_APPS_LATCHWORK_MPI_WORKER_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_MPI_MASTER_H_
#define LATCHWORK_APPS_LATCHWORK_MPI_MASTER_H_

#include <cstddef>

#include "apps/compare/folder/result_folder.h"
#include "apps/latchwork_mpi/mpi_link.h"

namespace latchwork::mpi {

struct MasterOptions {
  double patience_seconds = 30;    ///< With one worker.
  double endurance_seconds = 120;  ///< With all of them.
  bool quiet = false;
};

struct Shift {
  std::size_t missing = 0;  ///< Runs that nobody made.
  bool together = false;    ///< All processes are there to end the use of MPI.
};

/// Has the workers, all processes but this one, make what is missing.
Shift Lead(MpiLink& link, const compare::Experiment& experiment, compare::ResultFolder& folder,
           const MasterOptions& options);

/// Tells the workers that there is nothing to do.
Shift SendAway(MpiLink& link, const MasterOptions& options);

}  // namespace latchwork::mpi

#endif  // LATCHWORK_APPS_LATCHWORK_MPI_MASTER_H_

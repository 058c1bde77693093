// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_DISPATCH_SLURM_SCRIPTS_H_
#define LATCHWORK_APPS_COMPARE_DISPATCH_SLURM_SCRIPTS_H_

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "apps/compare/runs/launch.h"

namespace latchwork::compare {

/// How an experiment is to be run under SLURM. Relative paths are meant from `working_folder`.
struct SlurmJob {
  std::string name;
  std::filesystem::path working_folder;
  Launch launch;
  std::filesystem::path experiment;
  std::filesystem::path out;
  std::size_t shards = 1;
  unsigned jobs = 1;               ///< Runs at a time, and processors, of a shard.
  std::uint64_t memory_mb = 4096;  ///< Of a run; asked for with each processor.
};

/// For sbatch: an array of which each task makes one shard, the job that merges them, and the
/// shell script that submits both and hands its arguments to sbatch.
struct SlurmScripts {
  std::string shard;
  std::string merge;
  std::string submit;
};
SlurmScripts ToSlurmScripts(const SlurmJob& job);

/// Writes the three to the folder `slurm` of `job.out`: shard.sbatch, merge.sbatch, submit.sh.
/// Empty, or why it cannot.
std::string WriteSlurmScripts(const SlurmJob& job);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_DISPATCH_SLURM_SCRIPTS_H_

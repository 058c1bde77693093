// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/dispatch/slurm_scripts.h"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "apps/compare/runs/run_plan.h"

namespace latchwork::compare {
namespace {

std::string Header(const SlurmJob& job, const std::string& part) {
  return fmt::format(
      "#!/bin/sh\n#SBATCH --job-name=latchwork-{}{}\n#SBATCH --cpus-per-task={}\n"
      "#SBATCH --mem-per-cpu={}M\n",
      job.name, part, job.jobs, job.memory_mb);
}

std::string Begin(const SlurmJob& job) {
  return fmt::format("set -eu\ncd {}\n", ForShell(job.working_folder.string()));
}

std::string CommandLine(const SlurmJob& job) {
  std::string line = "exec " + ForShell(job.launch.program.string());
  for (const std::string& word : job.launch.arguments) line += ' ' + ForShell(word);
  return fmt::format("{} compare {} --quiet --jobs {}", line, ForShell(job.experiment.string()),
                     job.jobs);
}

std::string ShardScript(const SlurmJob& job) {
  return fmt::format(
      "{}#SBATCH --array=1-{}\n\n{}{} \\\n  --shard \"$SLURM_ARRAY_TASK_ID/{}\" "
      "--out {}/\"$SLURM_ARRAY_TASK_ID\"\n",
      Header(job, ""), job.shards, Begin(job), CommandLine(job), job.shards,
      ForShell((job.out / "shards").string()));
}

std::string MergeScript(const SlurmJob& job) {
  return fmt::format(
      "{}\n{}set --\nshard=1\nwhile [ \"$shard\" -le {} ]; do\n  set -- \"$@\" --merge "
      "{}/\"$shard\"\n"
      "  shard=$((shard + 1))\ndone\n{} --out {} \"$@\"\n",
      Header(job, "-merge"), Begin(job), job.shards, ForShell((job.out / "shards").string()),
      CommandLine(job), ForShell(job.out.string()));
}

/// sbatch prints the number of the job, and behind a semicolon the name of the cluster if it has
/// one.
std::string SubmitScript(const SlurmJob& job) {
  const std::filesystem::path folder = job.out / "slurm";
  const auto file = [&](const char* name) { return ForShell((folder / name).string()); };
  return fmt::format(
      "#!/bin/sh\n# Submits the shards and, for when all of them are done, their merging.\n"
      "# The arguments go to sbatch, as in: sh submit.sh --partition=short --time=60\n{}"
      "shards=$(sbatch --parsable --output={} \"$@\" {})\n"
      "sbatch --dependency=\"afterok:${{shards%%;*}}\" --kill-on-invalid-dep=yes \\\n"
      "  --output={} \"$@\" {}\n",
      Begin(job), file("shard-%a.log"), file("shard.sbatch"), file("merge.log"),
      file("merge.sbatch"));
}

}  // namespace

SlurmScripts ToSlurmScripts(const SlurmJob& job) {
  return {ShardScript(job), MergeScript(job), SubmitScript(job)};
}

std::string WriteSlurmScripts(const SlurmJob& job) {
  const std::filesystem::path folder = job.working_folder / job.out / "slurm";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const SlurmScripts scripts = ToSlurmScripts(job);
  for (const auto& [name, text] : {std::pair{"shard.sbatch", scripts.shard},
                                   {"merge.sbatch", scripts.merge},
                                   {"submit.sh", scripts.submit}}) {
    std::ofstream stream(folder / name, std::ios::binary);
    stream << text << std::flush;
    if (!stream) return fmt::format("{}: cannot be written", (folder / name).string());
  }
  return "";
}

}  // namespace latchwork::compare

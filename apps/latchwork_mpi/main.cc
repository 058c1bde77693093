// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "apps/compare/experiment/check_agents.h"
#include "apps/compare/folder/result_folder.h"
#include "apps/latchwork/command.h"
#include "apps/latchwork_mpi/master.h"
#include "apps/latchwork_mpi/mpi_link.h"
#include "apps/latchwork_mpi/worker.h"

namespace latchwork::mpi {
namespace {

/// How long one waits for somebody without whom there is nothing to do: a worker for the master,
/// the master for any worker at all.
double Endurance(double patience_seconds) { return std::max(60.0, 4 * patience_seconds); }

constexpr const char* kFooter =
    "Process 0 hands the runs out and writes the folder, as `latchwork compare` would; the others\n"
    "make one run at a time. Start one process more than there shall be runs at a time:\n"
    "  mpirun --enable-recovery -n 33 latchwork-mpi office.xml --out out/office\n"
    "With --enable-recovery the run of a worker that dies is made by another; without it, mpirun\n"
    "ends them all. Either way the same command goes on where it was stopped.\n";

struct Options {
  std::filesystem::path experiment;
  std::filesystem::path out;
  std::vector<std::filesystem::path> plugin_folders;
  double patience_seconds = 30;
  bool quiet = false;
};

void AddOptions(CLI::App& app, Options& options) {
  app.add_option("EXPERIMENT", options.experiment, "Experiment file (XML)")->required();
  app.add_option("--out", options.out, "Folder for the results (default out/EXPERIMENT)");
  app.add_option("--plugin-path", options.plugin_folders,
                 "Folder to search for plugins first; may be repeated")
      ->allow_extra_args(false);
  app.add_option("--patience", options.patience_seconds,
                 "Seconds after which a silent worker counts as lost (default 30)")
      ->check(CLI::Range(2.0, 3600.0));
  app.add_flag("-q,--quiet", options.quiet, "No progress");
  app.footer(kFooter);
}

/// mpirun starts many of us; one speaks.
bool IsSpeaker() {
  const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
  return rank == nullptr || std::string_view(rank) == "0";
}

[[noreturn]] void LeaveAlone(int exit_code) {
  std::fflush(nullptr);
  std::_Exit(exit_code);
}

compare::Launch LaunchOf(const Options& options) {
  return compare::LaunchOf(
      std::filesystem::read_symlink("/proc/self/exe").replace_filename("latchwork"),
      options.plugin_folders);
}

int Serve(MpiLink& link, const Options& options) {
  switch (Work(link, LaunchOf(options), Endurance(options.patience_seconds))) {
    case Ending::kTogether:
      link.Part();
      return app::kDone;
    case Ending::kLeave:
      LeaveAlone(app::kDone);
    case Ending::kMasterSilent:
      fmt::print(stderr, "latchwork-mpi: process {}: the master is silent\n", link.rank());
      LeaveAlone(app::kInternalError);
  }
  return app::kInternalError;
}

int ExitCode(const compare::Trouble& trouble, std::size_t missing) {
  fmt::print(stderr, "{}", trouble.text);
  if (trouble.kind == compare::Trouble::Kind::kInput) return app::kInvalidInput;
  if (trouble.kind == compare::Trouble::Kind::kWriting) return app::kInternalError;
  if (missing == 0) return app::kDone;
  fmt::print(stderr, "no worker is left, {} runs are missing; the same command goes on from here\n",
             missing);
  return app::kInternalError;
}

MasterOptions MasterOptionsOf(const Options& options) {
  return {options.patience_seconds, Endurance(options.patience_seconds), options.quiet};
}

/// After the results are written: who waits for the others may wait for somebody who just died.
int End(MpiLink& link, const Shift& shift, int exit_code) {
  if (!shift.together) {
    fmt::print(stderr, "a worker was lost: should mpirun wait for it, end mpirun\n");
    LeaveAlone(exit_code);
  }
  std::fflush(nullptr);
  link.Part();
  return exit_code;
}

int LeadExperiment(MpiLink& link, const compare::Experiment& experiment, const Options& options) {
  const std::filesystem::path out =
      options.out.empty() ? std::filesystem::path("out") / options.experiment.stem() : options.out;
  compare::ResultFolder folder(experiment, out);
  const std::atomic<bool> never = false;
  const auto diagnostics =
      compare::CheckAgents(experiment, folder.Missing(), LaunchOf(options), never);
  if (!diagnostics.empty()) {
    fmt::print(stderr, "{}", logic::Format(diagnostics));
    return End(link, SendAway(link, MasterOptionsOf(options)), app::kInvalidInput);
  }
  const Shift shift = Lead(link, experiment, folder, MasterOptionsOf(options));
  const std::string report = folder.WriteResults(
      {LaunchOf(options),
       {fmt::format("latchwork-mpi {} --out {}", compare::ForShell(options.experiment.string()),
                    compare::ForShell(out.string())),
        "latchwork", LATCHWORK_VERSION}});
  const int exit_code = ExitCode(folder.trouble(), shift.missing);
  fmt::print("{}", report);
  return End(link, shift, exit_code);
}

/// Only here need the file be: the others are told all that they need of it.
int ReadAndLead(MpiLink& link, const Options& options) {
  const compare::ExperimentFile file = compare::ReadExperiment(options.experiment);
  if (file.experiment) return LeadExperiment(link, *file.experiment, options);
  fmt::print(stderr, "{}", logic::Format(file.diagnostics));
  return End(link, SendAway(link, MasterOptionsOf(options)), app::kInvalidInput);
}

int Start(int argc, char** argv) {
  Options options;
  CLI::App app("latchwork-mpi: compares agents on many machines, under Open MPI", "latchwork-mpi");
  app.set_version_flag("--version", "latchwork-mpi " LATCHWORK_VERSION);
  AddOptions(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return IsSpeaker() ? app.exit(success) : app::kDone;
  } catch (const CLI::ParseError& error) {
    if (IsSpeaker()) fmt::print(stderr, "latchwork-mpi: {}\n  see: --help\n", error.what());
    return app::kUsage;
  }
  MpiLink link(argc, argv);
  if (link.rank() > 0) return Serve(link, options);
  if (link.size() > 1) return ReadAndLead(link, options);
  fmt::print(stderr,
             "latchwork-mpi: there is no worker; start it with mpirun and -n 2 or more:\n"
             "  mpirun --enable-recovery -n 3 latchwork-mpi {}\n",
             options.experiment.string());
  link.Part();
  return app::kUsage;
}

}  // namespace
}  // namespace latchwork::mpi

int main(int argc, char** argv) {
  try {
    return latchwork::mpi::Start(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "latchwork-mpi: internal error: %s\n", error.what());
  }
  return latchwork::app::kInternalError;
}

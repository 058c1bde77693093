// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/run_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace latchwork::app {
namespace {

/// The runs of one agent file, in the order in which the files were first given.
std::vector<std::vector<const FinishedRun*>> ByAgent(const std::vector<FinishedRun>& runs) {
  std::vector<std::vector<const FinishedRun*>> groups;
  for (const FinishedRun& run : runs) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& candidate) {
      return candidate.front()->request.agent_file == run.request.agent_file;
    });
    if (group == groups.end()) {
      groups.push_back({&run});
    } else {
      group->push_back(&run);
    }
  }
  return groups;
}

PooledSpread PoolLayer(const std::vector<const FinishedRun*>& runs, std::size_t layer, bool time) {
  std::vector<PooledSpread> samples;
  for (const FinishedRun* run : runs) {
    if (!run->began || layer >= run->result.layers.size()) continue;
    const schedule::LayerStatistics& statistics = run->result.layers[layer];
    const schedule::Spread& spread = time ? statistics.time_us : statistics.inferences;
    samples.push_back({static_cast<double>(statistics.decisions), spread.mean, spread.sd});
  }
  return Pool(samples);
}

std::string Header() {
  return fmt::format("{:<12} {:>7} {:>5} {:>7} | {:<11} {:<15} {:>9} {:>9} {:>11} {:>11}\n",
                     "scenario", "reached", "coll.", "time s", "layer", "reasoner", "time us", "sd",
                     "inferences", "sd");
}

/// What the runs of one agent file came to, before the first of its layers.
std::string Summary(const std::vector<const FinishedRun*>& runs) {
  std::size_t reached = 0;
  double collisions = 0;
  double seconds = 0;
  for (const FinishedRun* run : runs) {
    reached += run->began && run->result.state == schedule::RunResult::State::kReached ? 1 : 0;
    collisions += Measure(run->result, "collisions");
    seconds += Measure(run->result, "time_s") / static_cast<double>(runs.size());
  }
  return fmt::format("{:<12} {:>7} {:>5.0f} {:>7.1f}", runs.front()->agent_name,
                     fmt::format("{}/{}", reached, runs.size()), collisions, seconds);
}

std::string Rows(const std::vector<const FinishedRun*>& runs,
                 const std::vector<schedule::LayerStatistics>& layers) {
  std::string rows;
  std::string left = Summary(runs);
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    const PooledSpread time = PoolLayer(runs, layer, true);
    const PooledSpread inferences = PoolLayer(runs, layer, false);
    rows += fmt::format("{:<34} | {:<11} {:<15} {:>9.1f} {:>9.1f} {:>11.1f} {:>11.1f}\n", left,
                        layers[layer].name, layers[layer].reasoner, time.mean, time.sd,
                        inferences.mean, inferences.sd);
    left.clear();
  }
  return rows;
}

}  // namespace

PooledSpread Pool(std::span<const PooledSpread> samples) {
  PooledSpread pooled;
  for (const PooledSpread& sample : samples) {
    pooled.count += sample.count;
    pooled.mean += sample.count * sample.mean;
  }
  if (pooled.count == 0) return {};
  pooled.mean /= pooled.count;
  double squares = 0;
  for (const PooledSpread& sample : samples) {
    if (sample.count == 0) continue;
    const double offset = sample.mean - pooled.mean;
    squares += (sample.count - 1) * sample.sd * sample.sd + sample.count * offset * offset;
  }
  pooled.sd = pooled.count > 1 ? std::sqrt(squares / (pooled.count - 1)) : 0;
  return pooled;
}

double Measure(const schedule::RunResult& result, std::string_view name) {
  const auto found = std::find_if(result.measures.begin(), result.measures.end(),
                                  [&](const auto& measure) { return measure.first == name; });
  return found == result.measures.end() ? 0 : found->second;
}

std::string OutcomeText(const FinishedRun& run) {
  const schedule::RunResult& result = run.result;
  std::string text = fmt::format("{} (seed {}): {}{}{} after {} ticks\n", run.agent_name,
                                 result.seed, schedule::Name(result.state),
                                 result.message.empty() ? "" : ", ", result.message, result.ticks);
  for (const auto& [name, value] : result.measures) {
    text += fmt::format("  {}: {:g}\n", name, value);
  }
  for (const EventNote& event : run.events) {
    text += fmt::format("  event at tick {}: {}{}{}\n", event.tick, event.fact,
                        event.problem.empty() ? "" : ": not done: ", event.problem);
  }
  for (const schedule::Fault& fault : run.faults) {
    const bool of_world = fault.layer == schedule::Fault::kWorld;
    text += fmt::format("  fault at tick {} in {} (plugin {}): {}: {}\n", fault.tick,
                        of_world ? "the world" : "layer " + run.layer_names[fault.layer],
                        fault.plugin, schedule::Name(fault.kind), fault.message);
  }
  return text;
}

std::string LayerTable(const schedule::RunResult& result) {
  std::string table = fmt::format(
      "{:<12} {:<16} {:>9} | {:>8} {:>8} {:>8} {:>8} {:>8} | {:>8} {:>7} | {:>6} {:>6} {:>9} {:>7} "
      "{:>6}\n",
      "layer", "reasoner", "decisions", "mean us", "sd", "p50", "p99", "max", "inf.", "sd",
      "budget", "bound", "retracted", "refused", "faults");
  for (const schedule::LayerStatistics& layer : result.layers) {
    const schedule::Spread& time = layer.time_us;
    table += fmt::format(
        "{:<12} {:<16} {:>9} | {:>8.1f} {:>8.1f} {:>8.1f} {:>8.1f} {:>8.1f} | {:>8.1f} {:>7.1f} | "
        "{:>6} {:>6} {:>9} {:>7} {:>6}\n",
        layer.name, layer.reasoner, layer.decisions, time.mean, time.sd, time.p50, time.p99,
        time.max, layer.inferences.mean, layer.inferences.sd, layer.budget_hits,
        layer.assumed_by_bound, layer.retracted, layer.refused, layer.faults);
  }
  return table;
}

std::string ScenarioTable(const std::vector<FinishedRun>& runs) {
  std::string table = Header();
  for (const auto& group : ByAgent(runs)) {
    const auto begun =
        std::find_if(group.begin(), group.end(), [](const FinishedRun* run) { return run->began; });
    if (begun != group.end()) table += Rows(group, (*begun)->result.layers);
  }
  return table;
}

std::string FailureList(const std::vector<FinishedRun>& runs) {
  std::string text;
  for (const FinishedRun& run : runs) {
    if (run.exit_code == 0) continue;
    const std::string why =
        !run.began ? "did not begin"
                   : fmt::format("{}{}{}", schedule::Name(run.result.state),
                                 run.result.message.empty() ? "" : ", ", run.result.message);
    text += fmt::format("{} seed {}: {}\n  {}\n", run.request.agent_file.string(), run.request.seed,
                        why, CommandOf(run.request));
  }
  return text;
}

}  // namespace latchwork::app

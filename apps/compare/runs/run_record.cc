// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/runs/run_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

namespace latchwork::compare {
namespace {

using Json = nlohmann::ordered_json;
using End = process::ChildResult::End;

constexpr int kInternalError = 5;  // The exit code of a run that met one.

constexpr std::array<std::pair<Outcome, std::string_view>, 7> kNames = {{
    {Outcome::kReached, "reached"},
    {Outcome::kCollision, "collision"},
    {Outcome::kNotReached, "not reached"},
    {Outcome::kFailed, "failed"},
    {Outcome::kTimedOut, "timed out"},
    {Outcome::kCrashed, "crashed"},
    {Outcome::kInvalid, "invalid"},
}};

double Measure(const Json& summary, const char* name) {
  const auto measures = summary.find("measures");
  if (measures == summary.end()) return 0;
  const auto measure = measures->find(name);
  return measure != measures->end() && measure->is_number() ? measure->get<double>() : 0;
}

/// As the world measures it; else all the time in which it was there.
double Time(const Json& summary) {
  if (summary.contains("/measures/time_s"_json_pointer)) return Measure(summary, "time_s");
  return static_cast<double>(summary.value("ticks", std::uint64_t{0})) *
         summary.value("tick_s", 0.0);
}

LayerRecord ReadLayer(const Json& layer) {
  LayerRecord record;
  record.name = layer.value("name", "");
  record.reasoner = layer.value("reasoner", "");
  record.decisions = layer.value("decisions", std::uint64_t{0});
  record.budget_hits = layer.value("budget_hits", std::uint64_t{0});
  record.assumed_by_bound = layer.value("assumed_by_bound", std::uint64_t{0});
  record.faults = layer.value("faults", std::uint64_t{0});
  record.inferences = layer.value("/inferences/mean"_json_pointer, 0.0);
  record.mean_us = layer.value("/time_us/mean"_json_pointer, 0.0);
  record.p50_us = layer.value("/time_us/p50"_json_pointer, 0.0);
  record.p99_us = layer.value("/time_us/p99"_json_pointer, 0.0);
  return record;
}

Outcome OutcomeIn(const Json& summary, std::uint64_t collisions) {
  if (collisions > 0) return Outcome::kCollision;
  const std::string said = summary.value("outcome", "");
  if (said == "reached") return Outcome::kReached;
  return said == "failed" ? Outcome::kFailed : Outcome::kNotReached;
}

void ReadSummary(const Json& summary, RunRecord& record) {
  record.collisions = summary.value("collisions", std::uint64_t{0});
  record.outcome = OutcomeIn(summary, record.collisions);
  record.message = summary.value("message", "");
  record.duration_s = summary.value("duration_s", 0.0);
  record.time_s = Time(summary);
  record.distance_m = Measure(summary, "distance_m");
  record.trajectory = summary.value("trajectory", "");
  if (const auto layers = summary.find("layers"); layers != summary.end()) {
    for (const Json& layer : *layers) record.layers.push_back(ReadLayer(layer));
  }
}

std::string FirstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

RunRecord Begun(const PlannedRun& run, const process::ChildResult& child) {
  RunRecord record;
  record.key = run.key;
  record.command = CommandOf(run);
  record.wall_s = child.wall_seconds;
  record.cpu_s = child.cpu_seconds;
  return record;
}

/// An error inside the run counts, as a signal does; one in what it was given does not.
Outcome OutcomeWithoutSummary(const process::ChildResult& child) {
  const bool crashed = child.end == End::kSignalled ||
                       (child.end == End::kExited && child.code == kInternalError) ||
                       child.errors.find("bad_alloc") != std::string::npos;
  return crashed ? Outcome::kCrashed : Outcome::kInvalid;
}

void ReadOutput(const process::ChildResult& child, RunRecord& record) {
  const Json summary = Json::parse(child.output, nullptr, false);
  const bool has_summary =
      summary.is_object() && summary.value("outcome", "did not begin") != "did not begin";
  if (child.end == End::kExited && has_summary) {
    ReadSummary(summary, record);
    return;
  }
  record.outcome = OutcomeWithoutSummary(child);
  record.message =
      child.end == End::kSignalled
          ? fmt::format("ended by signal {}", child.code)
          : FirstLine(summary.is_object() ? summary.value("errors", child.errors) : child.errors);
}

}  // namespace

std::string_view Name(Outcome outcome) {
  return std::ranges::find(kNames, outcome, [](const auto& each) { return each.first; })->second;
}

std::optional<Outcome> OutcomeOf(std::string_view name) {
  const auto* const found =
      std::ranges::find(kNames, name, [](const auto& each) { return each.second; });
  if (found == kNames.end()) return std::nullopt;
  return found->first;
}

RunRecord Judge(const PlannedRun& run, const process::ChildResult& child) {
  RunRecord record = Begun(run, child);
  if (child.end == End::kTimedOut) {
    record.outcome = Outcome::kTimedOut;
    record.message = "ended: it took longer than the experiment allows";
    return record;
  }
  try {
    ReadOutput(child, record);
  } catch (const Json::exception& error) {
    record = Begun(run, child);
    record.outcome = Outcome::kCrashed;
    record.message = fmt::format("printed no summary of a run: {}", error.what());
  }
  return record;
}

std::string RepeatOf(const RunRecord& record, const RunLimits& limits) {
  if (record.outcome != Outcome::kTimedOut && record.outcome != Outcome::kCrashed) {
    return record.command;
  }
  return fmt::format("(ulimit -v {}; timeout {:g} {})", limits.memory_mb * 1024,
                     limits.wall_seconds, record.command);
}

std::string ToLine(const RunRecord& record) {
  Json layers = Json::array();
  for (const LayerRecord& layer : record.layers) {
    layers.push_back(
        {{"name", layer.name},
         {"reasoner", layer.reasoner},
         {"decisions", layer.decisions},
         {"budget_hits", layer.budget_hits},
         {"assumed_by_bound", layer.assumed_by_bound},
         {"faults", layer.faults},
         {"inferences", {{"mean", layer.inferences}}},
         {"time_us", {{"mean", layer.mean_us}, {"p50", layer.p50_us}, {"p99", layer.p99_us}}}});
  }
  const Json line = {{"scenario", record.key.scenario},
                     {"agent", record.key.contender},
                     {"seed", record.key.seed},
                     {"outcome", Name(record.outcome)},
                     {"message", record.message},
                     {"command", record.command},
                     {"duration_s", record.duration_s},
                     {"measures", {{"time_s", record.time_s}, {"distance_m", record.distance_m}}},
                     {"collisions", record.collisions},
                     {"layers", layers},
                     {"trajectory", record.trajectory},
                     {"wall_s", record.wall_s},
                     {"cpu_s", record.cpu_s}};
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<RunRecord> FromLine(std::string_view text) {
  const Json line = Json::parse(text, nullptr, false);
  if (!line.is_object()) return std::nullopt;
  try {
    RunRecord record;
    ReadSummary(line, record);
    record.key = {line.at("scenario"), line.at("agent"), line.at("seed")};
    const auto outcome = OutcomeOf(line.at("outcome").get<std::string>());
    if (!outcome) return std::nullopt;
    record.outcome = *outcome;
    record.command = line.at("command");
    record.wall_s = line.at("wall_s");
    record.cpu_s = line.at("cpu_s");
    return record;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace latchwork::compare

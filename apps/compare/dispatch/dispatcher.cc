// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/dispatch/dispatcher.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace latchwork::compare {

Dispatcher::Dispatcher(std::vector<PlannedRun> runs, Options options, double now)
    : options_(std::move(options)) {
  for (PlannedRun& run : runs) {
    places_[run.key] = runs_.size();
    runs_.push_back({std::move(run)});
  }
  for (int number = 1; number <= options_.workers; ++number) workers_[number].heard = now;
}

std::string Dispatcher::Answer(int worker_number, std::string_view said, double now) {
  Worker& worker = workers_[worker_number];
  if (worker.lost) options_.on_loss(fmt::format("worker {} speaks again", worker_number));
  worker.lost = false;
  worker.heard = now;
  if (said == kBusy) {
    const bool needed = worker.run && runs_[*worker.run].standing != Standing::kDone;
    return std::string(needed && !is_ending() ? kGoOn : kDrop);
  }
  if (const auto record = FromLine(said)) Take(worker, *record);
  Release(worker);
  return is_ending() ? Farewell(worker) : Next(worker);
}

/// Its run was given to another, and may be done, when a worker was thought lost.
void Dispatcher::Take(Worker& worker, const RunRecord& record) {
  const auto place = places_.find(record.key);
  if (place == places_.end() || ended_) return;
  Entry& entry = runs_[place->second];
  if (entry.standing == Standing::kDone || CommandOf(entry.run) != record.command) return;
  if (worker.run == place->second) worker.run.reset();
  entry.standing = Standing::kDone;
  ++done_;
  if (!options_.on_done(record)) ended_ = true;
}

void Dispatcher::Release(Worker& worker) {
  const std::optional<std::size_t> run = std::exchange(worker.run, std::nullopt);
  if (!run || runs_[*run].standing == Standing::kDone) return;
  const bool elsewhere = std::ranges::any_of(
      workers_, [&](const auto& other) { return !other.second.lost && other.second.run == run; });
  if (elsewhere) return;
  runs_[*run].standing = Standing::kWaiting;
  next_ = std::min(next_, *run);
}

std::string Dispatcher::Next(Worker& worker) {
  while (next_ < runs_.size() && runs_[next_].standing != Standing::kWaiting) ++next_;
  if (next_ == runs_.size()) return std::string(kWait);
  worker.run = next_;
  runs_[next_].standing = Standing::kGiven;
  return ToText({runs_[next_].run, options_.limits});
}

/// Nobody is sent away before everybody is there or lost: those who leave wait for each other only
/// if all of them come.
std::string Dispatcher::Farewell(Worker& worker) {
  worker.at_end = true;
  const bool all_there = std::ranges::all_of(
      workers_, [](const auto& each) { return each.second.at_end || each.second.lost; });
  if (!all_there) return std::string(kWait);
  if (farewell_.empty()) farewell_ = lost_any() ? kLeave : kStop;
  worker.told = true;
  return std::string(farewell_);
}

void Dispatcher::Look(double now) {
  for (auto& [number, worker] : workers_) {
    if (worker.lost || worker.told || now - worker.heard <= options_.patience_seconds) continue;
    worker.lost = true;
    options_.on_loss(worker.run ? fmt::format("worker {} is silent; another one makes its run: {}",
                                              number, CommandOf(runs_[*worker.run].run))
                                : fmt::format("worker {} is silent; it had no run", number));
    const std::optional<std::size_t> run = worker.run;
    Release(worker);
    worker.run = run;
  }
  ended_ = ended_ || std::ranges::all_of(workers_, [&](const auto& each) {
             return each.second.lost && now - each.second.heard > options_.endurance_seconds;
           });
}

bool Dispatcher::finished() const {
  return is_ending() && std::ranges::all_of(workers_, [](const auto& each) {
           return each.second.told || each.second.lost;
         });
}

bool Dispatcher::lost_any() const {
  return std::ranges::any_of(workers_, [](const auto& each) { return each.second.lost; });
}

}  // namespace latchwork::compare

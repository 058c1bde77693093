// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/strategies/prover.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "reasoners/pttp/strategies/prover_problem.h"
#include "reasoners/pttp/strategies/schedule.h"
#include "reasoners/pttp/strategies/strategy_run.h"

namespace latchwork::pttp {
namespace {

Szs StatusOf(StrategyEnd end, const ProverProblem& problem, const ProverOptions& options,
             const ProverResult& result) {
  switch (end) {
    case StrategyEnd::kRefuted:
      return problem.has_conjecture ? Szs::kTheorem : Szs::kUnsatisfiable;
    case StrategyEnd::kModel:
      return problem.has_conjecture ? Szs::kCounterSatisfiable : Szs::kSatisfiable;
    case StrategyEnd::kStopped:
      return result.statistics.inferences >= options.budget.inferences ? Szs::kResourceOut
                                                                       : Szs::kTimeout;
    case StrategyEnd::kMemory:
      return Szs::kResourceOut;
    case StrategyEnd::kSlice:
      return Szs::kTimeout;
    case StrategyEnd::kGaveUp:
      break;
  }
  return Szs::kGaveUp;
}

std::vector<Slice> SlicesFor(const ProverProblem& problem, const ProverOptions& options) {
  std::vector<Slice> slices;
  if (const NamedStrategy* chosen = FindStrategy(options.strategy); chosen != nullptr) {
    slices.push_back({chosen, 1});
  } else {
    slices = ScheduleFor(problem);
  }
  if ((options.answers || !options.saturation) && slices.size() > 1) {
    std::erase_if(slices, [](const Slice& slice) {
      return slice.strategy->method == NamedStrategy::Method::kSaturation;
    });
  }
  return slices;
}

/// The strategies of an attempt, on as many threads as were asked for: each thread takes the next
/// one of the schedule, until one decides.
class Race {
 public:
  Race(const ProverTask& task, std::vector<Slice> slices, double cpu_seconds)
      : task_(task), slices_(std::move(slices)), seconds_left_(cpu_seconds) {
    for (const Slice& slice : slices_) shares_left_ += slice.share;
  }

  void Run() {
    const std::size_t threads =
        std::clamp<std::size_t>(task_.options.threads, 1, std::max<std::size_t>(slices_.size(), 1));
    memory_bytes_ = task_.options.memory_bytes / threads;
    {
      std::vector<std::jthread> others;
      for (std::size_t i = 1; i < threads; ++i) others.emplace_back([this] { Work(); });
      Work();
    }
    if (failure_) std::rethrow_exception(failure_);
  }

  StrategyEnd end() const { return end_; }
  ProverResult& result() { return result_; }

 private:
  /// A strategy, and what it may spend.
  struct Turn {
    const NamedStrategy* strategy;
    double seconds;
    std::uint64_t inferences;
  };

  void Work() {
    try {
      while (const std::optional<Turn> turn = Take()) {
        const double start = ThreadSeconds();
        ProverResult result;
        const StrategyEnd end =
            RunStrategy(*turn->strategy, task_,
                        {turn->seconds, turn->inferences, memory_bytes_, decided_}, result);
        Give(end, std::move(result), turn->seconds - (ThreadSeconds() - start));
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!decided_.exchange(true)) failure_ = std::current_exception();
    }
  }

  std::optional<Turn> Take() {
    const std::lock_guard lock(mutex_);
    if (decided_ || next_ == slices_.size()) return std::nullopt;
    const Slice& slice = slices_[next_++];
    const double seconds = seconds_left_ * slice.share / shares_left_;
    seconds_left_ -= seconds;
    shares_left_ -= slice.share;
    const std::uint64_t most = task_.options.budget.inferences;
    return Turn{slice.strategy, seconds, most - std::min(most, inferences_)};
  }

  void Give(StrategyEnd end, ProverResult result, double seconds_unused) {
    const std::lock_guard lock(mutex_);
    seconds_left_ += seconds_unused;
    inferences_ += result.statistics.inferences;
    if (decided_) {
      result_.statistics.inferences = inferences_;
      return;
    }
    result_ = std::move(result);
    result_.statistics.inferences = inferences_;
    // A model of the clauses need not respect what numbers and distinct objects mean.
    if (end == StrategyEnd::kModel && task_.problem.has_fixed_meaning) return;
    if (end != StrategyEnd::kGaveUp) end_ = end;
    decided_ =
        end == StrategyEnd::kRefuted || end == StrategyEnd::kModel || end == StrategyEnd::kStopped;
  }

  const ProverTask& task_;
  const std::vector<Slice> slices_;
  std::size_t memory_bytes_ = 0;
  std::atomic<bool> decided_ = false;
  std::mutex mutex_;  // Guards everything below.
  std::size_t next_ = 0;
  double seconds_left_;
  double shares_left_ = 0;
  std::uint64_t inferences_ = 0;
  StrategyEnd end_ = StrategyEnd::kGaveUp;
  ProverResult result_;
  std::exception_ptr failure_;
};

}  // namespace

std::string_view Name(Szs status) {
  switch (status) {
    case Szs::kTheorem:
      return "Theorem";
    case Szs::kUnsatisfiable:
      return "Unsatisfiable";
    case Szs::kCounterSatisfiable:
      return "CounterSatisfiable";
    case Szs::kSatisfiable:
      return "Satisfiable";
    case Szs::kGaveUp:
      return "GaveUp";
    case Szs::kTimeout:
      return "Timeout";
    case Szs::kResourceOut:
      return "ResourceOut";
  }
  return "Unknown";
}

ProverResult Prove(const std::vector<logic::AnnotatedFormula>& formulas,
                   logic::SymbolTable& symbols, std::string_view file,
                   const ProverOptions& options) {
  const double start = ThreadSeconds();
  ProverProblem problem(formulas, symbols, options.proof);
  const ProverTask task{
      problem, symbols, {formulas, problem.origins, file, options.texts}, options};
  Race race(task, SlicesFor(problem, options), options.cpu_seconds - (ThreadSeconds() - start));
  race.Run();
  ProverResult result = std::move(race.result());
  result.status = StatusOf(race.end(), problem, options, result);
  result.clauses = problem.clauses.size();
  if (options.explain && race.end() != StrategyEnd::kRefuted) {
    problem.clauses.resize(problem.input_size);
    result.theory = std::move(problem.clauses);
  }
  return result;
}

}  // namespace latchwork::pttp

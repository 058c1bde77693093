// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/strategies/strategy_run.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>
#include <utility>
#include <vector>

#include "reasoners/pttp/proofs/engine_proof.h"
#include "reasoners/pttp/search/engine.h"
#include "reasoners/pttp/tableau/tableau.h"

namespace latchwork::pttp {
namespace {

class RefutationSink final : public ProofSink {
 public:
  RefutationSink(Engine& engine, ProofPrinter* printer) : engine_(engine), printer_(printer) {}

  bool Accept(const Proof& proof) override {
    depth = proof.depth;
    if (printer_ != nullptr) AddProof(proof, engine_, *printer_);
    return true;
  }

  std::uint32_t depth = 0;

 private:
  Engine& engine_;
  ProofPrinter* printer_;
};

/// Clauses of the negated conjecture first, then every other clause without a positive literal:
/// some minimal refutation starts at one of the latter (Loveland 1968).
std::vector<const Contrapositive*> StartClauses(const Program& program) {
  std::vector<const Contrapositive*> starts;
  for (const Contrapositive& start : program.conjectures()) starts.push_back(&start);
  for (const Contrapositive& start : program.negatives()) {
    if (program.clauses()[start.clause].role != logic::Role::kNegatedConjecture) {
      starts.push_back(&start);
    }
  }
  return starts;
}

class StrategyRun {
 public:
  StrategyRun(const ProverTask& task, const StrategyLimits& limits, ProverResult& result)
      : problem_(task.problem),
        symbols_(task.symbols),
        sources_(task.sources),
        options_(task.options),
        limits_(limits),
        slice_end_(ThreadSeconds() + limits.cpu_seconds),
        result_(result) {}

  StrategyEnd Run(const NamedStrategy& strategy) {
    switch (strategy.method) {
      case NamedStrategy::Method::kTableau:
        return RunTableau(strategy.tableau);
      case NamedStrategy::Method::kSaturation:
        return RunSaturation(strategy.saturation);
      case NamedStrategy::Method::kEngine:
        return RunEngine();
    }
    return StrategyEnd::kGaveUp;
  }

 private:
  bool MustEnd() const {
    const sdk::Budget& budget = options_.budget;
    return limits_.decided.load(std::memory_order_relaxed) ||
           (budget.cancelled != nullptr && budget.cancelled->load(std::memory_order_relaxed)) ||
           (budget.deadline && std::chrono::steady_clock::now() >= *budget.deadline);
  }
  bool SliceIsOver() const { return MustEnd() || ThreadSeconds() >= slice_end_; }

  StrategyEnd RunTableau(Strategy strategy) {
    strategy.deepest = options_.budget.depth;
    strategy.inferences = limits_.inferences;
    Matrix matrix(problem_.clauses, strategy);
    Tableau tableau(matrix, strategy, limits_.memory_bytes, [this] { return SliceIsOver(); });
    const TableauEnd end = tableau.Search();
    result_.statistics.inferences = tableau.inferences();
    result_.statistics.depth = tableau.depth();
    switch (end) {
      case TableauEnd::kClosed:
        if (options_.proof) Print(tableau.Refutation());
        return StrategyEnd::kRefuted;
      case TableauEnd::kSaturated:
        return StrategyEnd::kModel;
      case TableauEnd::kGaveUp:
        return StrategyEnd::kGaveUp;
      case TableauEnd::kStopped:
        return tableau.inferences() >= limits_.inferences || MustEnd() ? StrategyEnd::kStopped
                                                                       : StrategyEnd::kSlice;
      case TableauEnd::kMemory:
        break;
    }
    return StrategyEnd::kMemory;
  }

  StrategyEnd RunSaturation(saturation::Options strategy) {
    strategy.max_inferences = limits_.inferences;
    const std::function<bool()> stop = [this] { return SliceIsOver(); };
    const saturation::Outcome outcome =
        saturation::Saturate({problem_.input(), symbols_}, strategy, {limits_.memory_bytes, stop});
    result_.statistics.inferences = outcome.statistics.inferences;
    switch (outcome.status) {
      case saturation::Status::kRefuted:
        if (options_.proof) {
          ProofPrinter printer(problem_.input(), sources_);
          printer.Print(outcome.proof);
          Keep(printer);
          if (options_.explain) {
            result_.explanation = ExplainProof(problem_.input(), outcome.proof, sources_);
          }
        }
        return StrategyEnd::kRefuted;
      case saturation::Status::kSaturated:
        return StrategyEnd::kModel;
      case saturation::Status::kGaveUp:
        return StrategyEnd::kGaveUp;
      case saturation::Status::kStopped:
        return MustEnd() ? StrategyEnd::kStopped : StrategyEnd::kSlice;
      case saturation::Status::kInferences:
        return StrategyEnd::kStopped;
      case saturation::Status::kMemory:
        break;
    }
    return StrategyEnd::kMemory;
  }

  StrategyEnd RunEngine() {
    EngineOptions engine_options;
    engine_options.reals = problem_.reals;
    engine_options.tables = engine_options.states = problem_.reals == Reals::kRounded;
    Engine engine(symbols_, engine_options);
    const auto clauses = problem_.for_engine();
    engine.SetTheory({clauses.begin(), clauses.end()}, {});
    sdk::Budget budget = options_.budget;
    budget.inferences = limits_.inferences;
    engine.Begin(budget);
    SearchRequest request;
    request.starts = StartClauses(engine.program());
    request.reach = &engine.ReachFor(request.starts, false);
    request.depth = options_.budget.depth;
    request.record = options_.proof;
    ProofPrinter printer(engine.program().clauses(), sources_);
    RefutationSink sink(engine, options_.proof ? &printer : nullptr);
    const SearchEnd end = engine.Search(request, sink);
    result_.statistics.inferences = engine.meter().inferences();
    result_.statistics.depth = sink.depth;
    result_.message = engine.obstacle();
    if (end == SearchEnd::kAccepted) {
      if (options_.proof) {
        printer.Finish();
        Keep(printer);
      }
      return StrategyEnd::kRefuted;
    }
    if (end == SearchEnd::kStopped) return StrategyEnd::kStopped;
    return end == SearchEnd::kExhausted ? StrategyEnd::kModel : StrategyEnd::kGaveUp;
  }

  void Print(const std::vector<ClauseInstance>& instances) {
    ProofPrinter printer(problem_.clauses, sources_);
    for (const ClauseInstance& instance : instances) printer.Add(instance);
    printer.Finish();
    Keep(printer);
  }
  void Keep(ProofPrinter& printer) {
    result_.proof = std::move(printer.lines);
    result_.answers = std::move(printer.answers);
    result_.uses_conjecture = printer.uses_conjecture();
    if (options_.explain && !printer.premises.empty()) {
      result_.explanation = ExplainProof(printer.clauses(), printer.premises, sources_);
    }
  }

  const ProverProblem& problem_;
  logic::SymbolTable& symbols_;
  ProofSources sources_;
  const ProverOptions& options_;
  const StrategyLimits& limits_;
  double slice_end_;
  ProverResult& result_;
};

}  // namespace

double ThreadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

StrategyEnd RunStrategy(const NamedStrategy& strategy, const ProverTask& task,
                        const StrategyLimits& limits, ProverResult& result) {
  result.strategy = strategy.name;
  return StrategyRun(task, limits, result).Run(strategy);
}

}  // namespace latchwork::pttp

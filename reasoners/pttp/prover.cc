// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/prover.h"

#include <algorithm>
#include <ctime>
#include <functional>
#include <utility>

#include "reasoners/pttp/engine.h"
#include "reasoners/pttp/engine_proof.h"
#include "reasoners/pttp/proof_printer.h"
#include "reasoners/pttp/prover_problem.h"
#include "reasoners/pttp/schedule.h"
#include "reasoners/pttp/tableau/tableau.h"

namespace latchwork::pttp {
namespace {

double CpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What a strategy came to.
enum class End : std::uint8_t {
  kRefuted,
  kModel,    ///< There is no refutation.
  kGaveUp,   ///< It was at its end and knows nothing.
  kSlice,    ///< Its time was over.
  kStopped,  ///< The whole attempt must end.
  kMemory,
};

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

/// One attempt: the problem, what may be spent, and what came out.
class Attempt {
 public:
  Attempt(const ProverProblem& problem, logic::SymbolTable& symbols, const ProofSources& sources,
          const ProverOptions& options)
      : problem_(problem), symbols_(symbols), sources_(sources), options_(options) {}

  End Run(const NamedStrategy& strategy, double seconds) {
    slice_end_ = CpuSeconds() + seconds;
    result.strategy = strategy.name;
    switch (strategy.method) {
      case NamedStrategy::Method::kTableau:
        return RunTableau(strategy.tableau);
      case NamedStrategy::Method::kSaturation:
        return RunSaturation(strategy.saturation);
      case NamedStrategy::Method::kEngine:
        return RunEngine();
    }
    return End::kGaveUp;
  }

  ProverResult result;

 private:
  bool MustEnd() const {
    const sdk::Budget& budget = options_.budget;
    return (budget.cancelled != nullptr && budget.cancelled->load(std::memory_order_relaxed)) ||
           (budget.deadline && std::chrono::steady_clock::now() >= *budget.deadline);
  }
  bool SliceIsOver() const { return MustEnd() || CpuSeconds() >= slice_end_; }

  std::uint64_t InferencesLeft() const {
    return options_.budget.inferences -
           std::min(options_.budget.inferences, result.statistics.inferences);
  }

  End RunTableau(Strategy strategy) {
    strategy.deepest = options_.budget.depth;
    strategy.inferences = InferencesLeft();
    Matrix matrix(problem_.clauses, strategy);
    Tableau tableau(matrix, strategy, options_.memory_bytes, [this] { return SliceIsOver(); });
    const TableauEnd end = tableau.Search();
    result.statistics.inferences += tableau.inferences();
    result.statistics.depth = tableau.depth();
    switch (end) {
      case TableauEnd::kClosed:
        if (options_.proof) Print(tableau.Refutation());
        return End::kRefuted;
      case TableauEnd::kSaturated:
        return End::kModel;
      case TableauEnd::kGaveUp:
        return End::kGaveUp;
      case TableauEnd::kStopped:
        return InferencesLeft() == 0 || MustEnd() ? End::kStopped : End::kSlice;
      case TableauEnd::kMemory:
        break;
    }
    return End::kMemory;
  }

  End RunSaturation(saturation::Options strategy) {
    strategy.max_inferences = InferencesLeft();
    const std::function<bool()> stop = [this] { return SliceIsOver(); };
    const saturation::Outcome outcome =
        saturation::Saturate({problem_.input(), symbols_}, strategy, {options_.memory_bytes, stop});
    result.statistics.inferences += outcome.statistics.inferences;
    switch (outcome.status) {
      case saturation::Status::kRefuted:
        if (options_.proof) {
          ProofPrinter printer(problem_.input(), sources_);
          printer.Print(outcome.proof);
          Keep(printer);
          if (options_.explain) {
            result.explanation = ExplainProof(problem_.input(), outcome.proof, sources_);
          }
        }
        return End::kRefuted;
      case saturation::Status::kSaturated:
        return End::kModel;
      case saturation::Status::kGaveUp:
        return End::kGaveUp;
      case saturation::Status::kStopped:
        return MustEnd() ? End::kStopped : End::kSlice;
      case saturation::Status::kInferences:
        return End::kStopped;
      case saturation::Status::kMemory:
        break;
    }
    return End::kMemory;
  }

  End RunEngine() {
    Engine engine(symbols_, {});
    const auto clauses = problem_.for_engine();
    engine.SetTheory({clauses.begin(), clauses.end()}, {});
    engine.Begin(options_.budget);
    SearchRequest request;
    request.starts = StartClauses(engine.program());
    request.reach = &engine.ReachFor(request.starts, false);
    request.depth = options_.budget.depth;
    request.record = options_.proof;
    ProofPrinter printer(engine.program().clauses(), sources_);
    RefutationSink sink(engine, options_.proof ? &printer : nullptr);
    const SearchEnd end = engine.Search(request, sink);
    result.statistics.inferences += engine.meter().inferences();
    result.statistics.depth = sink.depth;
    result.message = engine.obstacle();
    if (end == SearchEnd::kAccepted) {
      if (options_.proof) {
        printer.Finish();
        Keep(printer);
      }
      return End::kRefuted;
    }
    if (end == SearchEnd::kStopped) return End::kStopped;
    return end == SearchEnd::kExhausted ? End::kModel : End::kGaveUp;
  }

  void Print(const std::vector<ClauseInstance>& instances) {
    ProofPrinter printer(problem_.clauses, sources_);
    for (const ClauseInstance& instance : instances) printer.Add(instance);
    printer.Finish();
    Keep(printer);
  }
  void Keep(ProofPrinter& printer) {
    result.proof = std::move(printer.lines);
    result.answers = std::move(printer.answers);
    result.uses_conjecture = printer.uses_conjecture();
    if (options_.explain && !printer.premises.empty()) {
      result.explanation = ExplainProof(printer.clauses(), printer.premises, sources_);
    }
  }

  const ProverProblem& problem_;
  logic::SymbolTable& symbols_;
  ProofSources sources_;
  const ProverOptions& options_;
  double slice_end_ = 0;
};

Szs StatusOf(End end, const ProverProblem& problem, const ProverOptions& options,
             const ProverResult& result) {
  switch (end) {
    case End::kRefuted:
      return problem.has_conjecture ? Szs::kTheorem : Szs::kUnsatisfiable;
    case End::kModel:
      return problem.has_conjecture ? Szs::kCounterSatisfiable : Szs::kSatisfiable;
    case End::kStopped:
      return result.statistics.inferences >= options.budget.inferences ? Szs::kResourceOut
                                                                       : Szs::kTimeout;
    case End::kMemory:
      return Szs::kResourceOut;
    case End::kSlice:
      return Szs::kTimeout;
    case End::kGaveUp:
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
  const double end_seconds = CpuSeconds() + options.cpu_seconds;
  ProverProblem problem(formulas, symbols, options.proof);
  Attempt attempt(problem, symbols, {formulas, problem.origins, file, options.texts}, options);
  const std::vector<Slice> slices = SlicesFor(problem, options);
  double shares = 0;
  for (const Slice& slice : slices) shares += slice.share;
  End best = End::kGaveUp;
  for (const Slice& slice : slices) {
    const double left = end_seconds - CpuSeconds();
    const End end = attempt.Run(*slice.strategy, left * slice.share / shares);
    shares -= slice.share;
    // A model of the clauses need not respect what numbers and distinct objects mean.
    if (end == End::kModel && problem.has_fixed_meaning) continue;
    if (end != End::kGaveUp) best = end;
    if (end == End::kRefuted || end == End::kModel || end == End::kStopped) break;
  }
  ProverResult result = std::move(attempt.result);
  result.status = StatusOf(best, problem, options, result);
  result.clauses = problem.clauses.size();
  if (options.explain && best != End::kRefuted) {
    problem.clauses.resize(problem.input_size);
    result.theory = std::move(problem.clauses);
  }
  return result;
}

}  // namespace latchwork::pttp

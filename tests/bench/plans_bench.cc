// SPDX-License-Identifier: BSD-3-Clause
//
// Plans in large buildings, closures of large graphs, latches that change, and how soon a decision
// heeds its cancellation.
#include <benchmark/benchmark.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "reasoners/pttp/search/engine.h"
#include "tests/bench/cpu_clock.h"
#include "tests/reasoners/pttp/ladder.h"

namespace latchwork::pttp {
namespace {

/// A plan of so many steps on a ladder of so many landmarks; the robot stands elsewhere in every
/// cycle.
void LadderPlan(benchmark::State& state) {
  const int rungs = static_cast<int>(state.range(0)) / 2;
  const int steps = static_cast<int>(state.range(1));
  AgentMind mind("ladder_plan", kItinerary);
  LoadLadder(mind, rungs);
  mind.budget.depth = 400;
  mind.budget.inferences = 100'000'000;
  int start = 0;
  for (auto _ : state) {
    start = (start + 1) % 8;
    mind.Latch(1, {"curr_landmark(a" + std::to_string(start) + ")"});
    mind.Latch(2, {"goal(a" + std::to_string(start + steps) + ")"});
    mind.Decide();
  }
  state.SetLabel(std::string(sdk::Name(mind.decision.status)));
  state.counters["inferences"] = static_cast<double>(mind.decision.statistics.inferences);
}
BENCHMARK(LadderPlan)
    ->ArgNames({"landmarks", "steps"})
    ->Args({250, 25})
    ->Args({300, 25})
    ->Args({300, 40})
    ->Args({600, 60})
    ->Unit(benchmark::kMillisecond);

/// Everything that can be reached in a cyclic graph of so many nodes.
void Reachable(benchmark::State& state) {
  AgentMind mind("reachable_bench",
                 "fof(s, axiom, ![X] : (start(X) => reachable(X)))."
                 "fof(t, axiom, ![X, Y] : ((reachable(X) & edge(X, Y)) => reachable(Y))).");
  mind.Input("start", 1);
  mind.Input("edge", 2);
  mind.Goal("reachable(X)", sdk::Goal::Answers::kAll);
  mind.Load();
  const auto nodes = static_cast<int>(state.range(0));
  std::vector<std::string> edges;
  for (int i = 0; i < nodes; ++i) {
    for (const int next : {i + 1, i * 7 + 3}) {
      edges.push_back("edge(n" + std::to_string(i) + ", n" + std::to_string(next % nodes) + ")");
    }
  }
  mind.Latch(1, edges);
  int start = 0;
  for (auto _ : state) {
    mind.Latch(0, {"start(n" + std::to_string(start++ % nodes) + ")"});
    mind.Decide();
  }
  state.SetLabel(std::string(sdk::Name(mind.decision.status)));
  state.counters["answers"] = static_cast<double>(mind.decision.conclusions.size());
}
BENCHMARK(Reachable)->Arg(500)->Arg(5000)->Unit(benchmark::kMicrosecond);

/// A hundred facts with a number each enter a latch; share: how many percent of them are new.
void LatchUpdate(benchmark::State& state) {
  logic::SymbolTable symbols;
  Engine engine(symbols, {});
  const logic::Symbol reading = symbols.Intern("sonar_reading");
  const std::size_t source = engine.AddSource("sonar");
  constexpr int kFacts = 100;
  std::vector<logic::Fact> facts;
  facts.reserve(kFacts);
  for (int i = 0; i < kFacts; ++i) {
    facts.push_back({reading, {logic::Term::Integer(i), logic::Term::Real(0.5 * i)}});
  }
  double change = 0;
  for (auto _ : state) {
    change += 0.001;
    for (std::int64_t i = 0; i < state.range(0); ++i) {
      facts[static_cast<std::size_t>(i)] = {reading,
                                            {logic::Term::Integer(i), logic::Term::Real(change)}};
    }
    engine.SetFacts(source, facts);
  }
}
BENCHMARK(LatchUpdate)
    ->ArgName("changed")
    ->Arg(0)
    ->Arg(10)
    ->Arg(100)
    ->Unit(benchmark::kMicrosecond);

/// Cancels the decision that it is called in once the search is under way.
class Canceller final : public sdk::Attachment {
 public:
  Canceller() {
    signature_.predicate = "tick";
    signature_.arguments = {{{"n", sdk::ArgumentType::kAny, ""}, sdk::Attachment::Mode::kIn}};
  }
  const Signature& signature() const override { return signature_; }
  void Call(std::span<const logic::Term> /*inputs*/, sdk::AttachmentContext& /*context*/,
            sdk::AnswerSink& outputs) override {
    outputs.Answer({});
    if (++calls_ != kUnderWay) return;
    cancelled = true;
    start = std::chrono::steady_clock::now();
  }
  void Reset() {
    calls_ = 0;
    cancelled = false;
  }

  std::atomic<bool> cancelled{false};
  std::chrono::steady_clock::time_point start;

 private:
  static constexpr int kUnderWay = 500;
  Signature signature_;
  int calls_ = 0;
};

/// From the cancellation to the end of the decision, by the wall clock; the search has no end.
void CancellationLatency(benchmark::State& state) {
  AgentMind mind("cancel_bench",
                 "cnf(b, axiom, n(a)). cnf(s, axiom, n(X) | ~ tick(X) | ~ n(s(X)))."
                 "cnf(d, axiom, n(X) | ~ n(t(X))). cnf(g, axiom, goal | ~ n(z)).");
  const auto canceller = std::make_shared<Canceller>();
  mind.body.attachments.push_back(canceller);
  mind.Goal("goal");
  mind.Load();
  mind.budget.depth = 100'000;
  mind.budget.inferences = ~std::uint64_t{0};
  mind.budget.cancelled = &canceller->cancelled;
  Sample micros;
  for (auto _ : state) {
    canceller->Reset();
    mind.Decide();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - canceller->start;
    if (mind.decision.limit != sdk::Limit::kCancelled) state.SkipWithError("it was not cancelled");
    state.SetIterationTime(taken.count());
    micros.Add(taken.count() * 1e6);
  }
  micros.Report("us", state);
}
BENCHMARK(CancellationLatency)->UseManualTime()->Iterations(200)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace latchwork::pttp

// SPDX-License-Identifier: BSD-3-Clause
// A reasoner for bodies in a language of its own, "cruise": it knows the predicates of that layer
// and compares two numbers.

#include <latchwork/sdk/plugin.h>

#include <optional>
#include <string>
#include <vector>

namespace {

namespace logic = latchwork::logic;
namespace sdk = latchwork::sdk;

/// The number that a fact of this predicate holds.
std::optional<double> NumberOf(std::span<const logic::Fact> facts, std::string_view predicate) {
  for (const logic::Fact& fact : facts) {
    if (fact.predicate().name() == predicate && fact.arity() == 1 && fact.argument(0).is_number()) {
      return fact.argument(0).number();
    }
  }
  return std::nullopt;
}

class Threshold final : public sdk::Reasoner {
 public:
  std::string_view language() const override { return "cruise"; }
  std::span<const sdk::ParameterSpec> parameters() const override { return {}; }

  logic::Diagnostics Load(const sdk::Body& body, const sdk::Parameters&,
                          logic::SymbolTable&) override {
    const auto speed = NumberOf(body.facts, "speed");
    const auto stop_distance = NumberOf(body.facts, "stop_distance");
    if (!speed || !stop_distance || body.goals.size() != 1) {
      return {{{}, "the body is not one of 'cruise'", "give speed and stop_distance", ""}};
    }
    speed_ = *speed;
    stop_distance_ = *stop_distance;
    goal_ = body.goals[0].pattern.predicate();
    return {};
  }

  void Decide(std::span<const sdk::Latch> latches, const sdk::Budget&,
              sdk::Decision& decision) override {
    decision.Clear();  // keeps its memory
    decision.status = sdk::Status::kRefuted;
    const auto gap = NumberOf(latches[0].facts, "gap");
    if (!gap || *gap <= stop_distance_) return;
    decision.status = sdk::Status::kProved;
    decision.conclusions.push_back({0, logic::Fact(goal_, {logic::Term::Real(speed_)}), {}});
    decision.statistics.inferences = 1;
  }

  /// Its bodies have no hard axioms, so there is nothing that a fact could contradict.
  void Admit(std::span<const sdk::Latch>, std::size_t, std::span<const logic::Fact>,
             const sdk::Budget&, std::vector<sdk::Refusal>&) override {}

  logic::Diagnostics Tell(std::string_view) override { return Fixed(); }
  logic::Diagnostics Retract(std::string_view) override { return Fixed(); }
  sdk::Derivation Explain(std::size_t) override { return {}; }

 private:
  static logic::Diagnostics Fixed() {
    return {{{}, "bodies of 'cruise' cannot be changed while the robot runs", "", ""}};
  }

  double speed_ = 0;
  double stop_distance_ = 0;
  logic::Symbol goal_;
};

}  // namespace

LATCHWORK_PLUGIN(Threshold, "threshold", "1.0", "compares the gap with the stop distance")

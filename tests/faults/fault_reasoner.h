// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_FAULTS_FAULT_REASONER_H_
#define LATCHWORK_TESTS_FAULTS_FAULT_REASONER_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/sdk/plugin.h"

namespace latchwork::faults {

/// The parameter that every fault has: the number of the call of Decide, counted from 0, with which
/// it begins.
inline sdk::ParameterSpec FromCall() {
  return {"from_call",
          sdk::ParameterType::kInteger,
          "5",
          0,
          1e9,
          "",
          "the first call of Decide, counted from 0, that has the fault",
          {}};
}

/// A reasoner that ignores its body. It answers something harmless, fwd(0.1) where that is a goal
/// and halt otherwise, until its fault begins; then `DecideFaultily` has its way.
class FaultReasoner : public sdk::Reasoner {
 public:
  std::string_view language() const override { return ""; }
  std::span<const sdk::ParameterSpec> parameters() const override { return table_; }

  logic::Diagnostics Load(const sdk::Body& body, const sdk::Parameters& parameters,
                          logic::SymbolTable& symbols) override {
    goals_ = body.goals;
    symbols_ = &symbols;
    from_call_ = static_cast<std::uint64_t>(parameters.Integer("from_call"));
    Configure(parameters);
    return {};
  }

  void Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
              sdk::Decision& decision) override {
    static_cast<void>(latches);
    AnswerHarmlessly(decision);
    if (calls_++ >= from_call_) DecideFaultily(budget, decision);
  }

  void Admit(std::span<const sdk::Latch> latches, std::size_t port,
             std::span<const logic::Fact> batch, const sdk::Budget& budget,
             std::vector<sdk::Refusal>& refused) override {
    static_cast<void>(latches), static_cast<void>(port), static_cast<void>(batch);
    static_cast<void>(budget), static_cast<void>(refused);
  }

  logic::Diagnostics Tell(std::string_view text) override {
    return {{{}, "this reasoner cannot be told anything", "", std::string(text)}};
  }
  logic::Diagnostics Retract(std::string_view name) override {
    return {{{}, "this reasoner has no clause '" + std::string(name) + "'", "", ""}};
  }
  sdk::Derivation Explain(std::size_t conclusion) override {
    static_cast<void>(conclusion);
    return {};
  }

 protected:
  explicit FaultReasoner(std::vector<sdk::ParameterSpec> more = {}) : table_(std::move(more)) {
    table_.insert(table_.begin(), FromCall());
  }

  /// Reads the parameters of the fault itself.
  virtual void Configure(const sdk::Parameters& parameters) { static_cast<void>(parameters); }
  /// `decision` holds the harmless answer.
  virtual void DecideFaultily(const sdk::Budget& budget, sdk::Decision& decision) = 0;

  /// The index of the goal with this predicate.
  std::optional<std::size_t> FindGoal(std::string_view predicate, std::size_t arity) const {
    const auto found = std::find_if(goals_.begin(), goals_.end(), [&](const sdk::Goal& goal) {
      return goal.pattern.predicate().name() == predicate && goal.pattern.arity() == arity;
    });
    if (found == goals_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - goals_.begin());
  }

  /// Concludes `predicate(arguments)` for a goal.
  void Conclude(std::size_t goal, std::string_view predicate,
                std::span<const logic::Term> arguments, sdk::Decision& decision) {
    decision.conclusions.push_back({goal, logic::Fact(symbols_->Intern(predicate), arguments), {}});
    decision.status = sdk::Status::kProved;
  }
  void Conclude(std::size_t goal, std::string_view predicate, const logic::Term& argument,
                sdk::Decision& decision) {
    Conclude(goal, predicate, std::span(&argument, 1), decision);
  }

  const std::vector<sdk::Goal>& goals() const { return goals_; }
  logic::SymbolTable& symbols() { return *symbols_; }

 private:
  void AnswerHarmlessly(sdk::Decision& decision) {
    decision.Clear();
    decision.status = sdk::Status::kRefuted;
    if (const auto fwd = FindGoal("fwd", 1)) {
      Conclude(*fwd, "fwd", logic::Term::Real(0.1), decision);
    } else if (const auto halt = FindGoal("halt", 0)) {
      Conclude(*halt, "halt", std::span<const logic::Term>(), decision);
    }
    decision.statistics.inferences = decision.conclusions.size();
    decision.statistics.depth = 1;
  }

  std::vector<sdk::ParameterSpec> table_;
  std::vector<sdk::Goal> goals_;
  logic::SymbolTable* symbols_ = nullptr;
  std::uint64_t from_call_ = 0;
  std::uint64_t calls_ = 0;
};

}  // namespace latchwork::faults

#endif  // LATCHWORK_TESTS_FAULTS_FAULT_REASONER_H_

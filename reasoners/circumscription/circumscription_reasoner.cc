// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/circumscription_reasoner.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace latchwork::circumscription {

logic::Diagnostics CircumscriptionReasoner::Load(const sdk::Body& body,
                                                 const sdk::Parameters& parameters,
                                                 logic::SymbolTable& symbols) {
  body_ = body;
  symbols_ = &symbols;
  mode_ = ModeOf(parameters);
  is_brave_ = IsBrave(parameters);
  reuses_ = parameters.Boolean("cache_decisions");
  decided_ = was_exact_ = false;
  if (auto diagnostics = bounded_.Load(body_, parameters, symbols); !diagnostics.empty()) {
    return diagnostics;
  }
  if (mode_ == Mode::kBounded) return {};
  theory_ = std::make_unique<pttp::Theory>(body_, symbols);
  if (auto diagnostics = theory_->ReadFiles(); !diagnostics.empty()) return diagnostics;
  return CompileExact();
}

/// What cannot be decided exactly is an error in mode `exact`, and a reason in mode `auto`.
logic::Diagnostics CircumscriptionReasoner::CompileExact() {
  decided_ = was_exact_ = false;
  why_bounded_.clear();
  exact_ = std::make_unique<ExactDecider>(body_, *symbols_, is_brave_);
  logic::Diagnostics diagnostics = exact_->Compile(theory_->Clauses(false));
  if (diagnostics.empty()) return {};
  exact_.reset();
  if (mode_ == Mode::kExact) return diagnostics;
  why_bounded_ = diagnostics.front().message;
  return {};
}

logic::Diagnostics CircumscriptionReasoner::Change(
    const std::function<logic::Diagnostics(sdk::Reasoner&)>& bounded,
    const std::function<logic::Diagnostics(pttp::Theory&)>& exact) {
  if (!theory_) return bounded(bounded_);
  const pttp::Theory before = *theory_;
  if (auto diagnostics = exact(*theory_); !diagnostics.empty()) return diagnostics;
  auto diagnostics = CompileExact();
  if (!diagnostics.empty()) {
    *theory_ = before;
    CompileExact();
    return diagnostics;
  }
  return bounded(bounded_);
}

logic::Diagnostics CircumscriptionReasoner::Tell(std::string_view text) {
  return Change([&](sdk::Reasoner& bounded) { return bounded.Tell(text); },
                [&](pttp::Theory& theory) { return theory.Tell(text); });
}

logic::Diagnostics CircumscriptionReasoner::Retract(std::string_view name) {
  return Change([&](sdk::Reasoner& bounded) { return bounded.Retract(name); },
                [&](pttp::Theory& theory) { return theory.Retract(name); });
}

bool CircumscriptionReasoner::IsUnchanged(std::span<const sdk::Latch> latches,
                                          const sdk::Budget& budget) {
  bool same = decided_ && versions_.size() == latches.size() &&
              budget.inferences == last_budget_.inferences && budget.depth == last_budget_.depth;
  versions_.resize(latches.size());
  for (std::size_t i = 0; i < latches.size(); ++i) {
    same = same && versions_[i] == latches[i].version;
    versions_[i] = latches[i].version;
  }
  last_budget_ = budget;
  return same && reuses_;
}

void CircumscriptionReasoner::Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
                                     sdk::Decision& decision) {
  if (!exact_) return DecideBounded(latches, budget, decision, why_bounded_);
  if (IsUnchanged(latches, budget)) {
    decision = last_;
    decision.statistics = {};
    return;
  }
  decided_ = false;
  was_exact_ = exact_->Decide(latches, budget, decision);
  if (was_exact_) {
    last_ = decision;
    decided_ = decision.limit != sdk::Limit::kTime && decision.limit != sdk::Limit::kCancelled;
  } else if (mode_ == Mode::kAuto) {
    DecideBounded(latches, budget, decision, exact_->reason());
  } else {
    decision.Clear();
    decision.status = sdk::Status::kFailed;
    decision.message = exact_->reason();
  }
}

void CircumscriptionReasoner::DecideBounded(std::span<const sdk::Latch> latches,
                                            const sdk::Budget& budget, sdk::Decision& decision,
                                            std::string_view why) {
  bounded_.Decide(latches, budget, decision);
  was_exact_ = false;
  if (decision.message.empty() && !why.empty()) decision.message = fmt::format("bounded: {}", why);
}

void CircumscriptionReasoner::Admit(std::span<const sdk::Latch> latches, std::size_t port,
                                    std::span<const logic::Fact> batch, const sdk::Budget& budget,
                                    std::vector<sdk::Refusal>& refused) {
  bounded_.Admit(latches, port, batch, budget, refused);
}

sdk::Derivation CircumscriptionReasoner::Explain(std::size_t conclusion) {
  return was_exact_ ? exact_->Explain(last_, conclusion) : bounded_.Explain(conclusion);
}

std::optional<sdk::Explanation> CircumscriptionReasoner::ExplainAssumption(std::size_t assumption) {
  return was_exact_ ? exact_->ExplainAssumption(assumption)
                    : bounded_.ExplainAssumption(assumption);
}

std::optional<sdk::Explanation> CircumscriptionReasoner::WhyNot(const logic::Atom& pattern) {
  return was_exact_ ? exact_->WhyNot(last_, pattern) : bounded_.WhyNot(pattern);
}

}  // namespace latchwork::circumscription

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/learning/layer_learning.h"

#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

namespace latchwork::icarus {

namespace {

sdk::ParameterSpec Real(std::string name, std::string value, double most, std::string help) {
  return {.name = std::move(name),
          .type = sdk::ParameterType::kReal,
          .default_value = std::move(value),
          .minimum = 0,
          .maximum = most,
          .unit = "",
          .help = std::move(help),
          .choices = {}};
}

sdk::ParameterSpec Count(std::string name, std::string value, std::string help) {
  return {.name = std::move(name),
          .type = sdk::ParameterType::kInteger,
          .default_value = std::move(value),
          .minimum = 1,
          .maximum = 1e9,
          .unit = "",
          .help = std::move(help),
          .choices = {}};
}

/// The rewards among the facts of the latches.
double RewardOf(std::span<const sdk::Latch> latches) {
  double sum = 0;
  for (const sdk::Latch& latch : latches) {
    for (const logic::Fact& fact : latch.facts) {
      if (fact.predicate().name() != "reward" || fact.arity() != 1) continue;
      const logic::Term& reward = fact.arguments()[0];
      if (reward.is_number()) sum += reward.number();
    }
  }
  return sum;
}

}  // namespace

std::vector<sdk::ParameterSpec> LayerLearning::Parameters() {
  return {{.name = "values",
           .type = sdk::ParameterType::kFile,
           .default_value = "",
           .unit = "",
           .help = "learned values of skills, to begin with; with learn they are written there",
           .choices = {}},
          {.name = "learn",
           .type = sdk::ParameterType::kBoolean,
           .default_value = "false",
           .unit = "",
           .help = "values of skills are learned from the facts reward(R) of the latches",
           .choices = {}},
          Real("exploration", "0.1", 1, "share of the choices made at random while learning"),
          Count("hold", "1", "cycles for which a random choice stays the same"),
          Real("rate", "0.1", 1, "of what is new in a value, at least"),
          Real("discount", "0.99", 1, "of rewards, per cycle"),
          Real("trace", "0.95", 1, "0: a value rests on the next one; 1: on rewards alone"),
          Count("exploration_seed", "1", "of the random choices")};
}

LayerLearning::LayerLearning(const sdk::Parameters& parameters)
    : file_(parameters.File("values")), learning_(parameters.Boolean("learn")) {
  options_.exploration = parameters.Real("exploration");
  options_.hold = static_cast<std::size_t>(parameters.Integer("hold"));
  options_.rate = parameters.Real("rate");
  options_.discount = parameters.Real("discount");
  options_.trace = parameters.Real("trace");
  options_.seed = static_cast<std::uint64_t>(parameters.Integer("exploration_seed"));
}

LayerLearning::~LayerLearning() {
  if (!learning_ || learner_ == nullptr || file_.empty()) return;
  try {
    learner_->EndEpisode();
    const std::filesystem::path fresh = file_.string() + ".new";
    std::ofstream(fresh, std::ios::binary) << learner_->Write();
    std::error_code error;
    std::filesystem::rename(fresh, file_, error);
  } catch (...) {
    // The values of this run are lost; those of the file stay.
    return;
  }
}

logic::Diagnostics LayerLearning::Serve(const Program& program, NamePool& names,
                                        Interpreter& interpreter) {
  if (file_.empty() && !learning_) return {};
  std::string known;
  std::error_code error;
  if (learner_ != nullptr) {
    learner_->EndEpisode();
    known = learner_->Write();
  } else if (!file_.empty() && std::filesystem::exists(file_, error)) {
    std::ifstream stream(file_, std::ios::binary);
    known.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  } else if (!learning_) {
    return {{{file_.string(), 0, 0}, "there is no such file of values", "learn them first", {}}};
  }
  Findings findings;
  const bool first = learner_ == nullptr;
  learner_ = std::make_unique<ValueLearner>(program, names, options_);
  learner_->SetLearning(learning_);
  learner_->Read(std::move(known), file_.string(), findings);
  interpreter.SetValues(learner_.get());
  return first ? ErrorsOf(findings) : logic::Diagnostics();
}

void LayerLearning::Before(std::span<const sdk::Latch> latches) {
  if (learner_ == nullptr) return;
  if (learning_) learner_->Reward(RewardOf(latches));
  learner_->BeginCycle();
}

void LayerLearning::After(const CycleResult& result) {
  if (learner_ != nullptr) learner_->Choose(result.acts.empty() ? nullptr : result.acts.data());
}

}  // namespace latchwork::icarus

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_LAYER_LEARNING_H_
#define LATCHWORK_ICARUS_LAYER_LEARNING_H_

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "latchwork/logic/diagnostic.h"
#include "latchwork/sdk/contract.h"
#include "latchwork/sdk/parameters.h"
#include "latchwork/sdk/reasoner.h"
#include "reasoners/icarus/learning/value_learner.h"

namespace latchwork::icarus {

/// The values of a layer's skills: taken from a file, and learned while the agent runs from the
/// facts `reward(R)` of its latches, each the reward of the cycle before. Does nothing without the
/// parameters `values` and `learn`. Thread rule: one thread at a time.
class LayerLearning {
 public:
  /// values, learn, and those of LearningOptions.
  static std::vector<sdk::ParameterSpec> Parameters();

  explicit LayerLearning(const sdk::Parameters& parameters);
  /// Writes the values that were learned, if a file was given.
  ~LayerLearning();
  LayerLearning(const LayerLearning&) = delete;
  LayerLearning& operator=(const LayerLearning&) = delete;

  /// Gives values to the skills of a program; of a changed program with the values that its skills
  /// had before. All outlive this.
  logic::Diagnostics Serve(const Program& program, NamePool& names, Interpreter& interpreter);
  /// Around each cycle.
  void Before(std::span<const sdk::Latch> latches);
  void After(const CycleResult& result);

 private:
  LearningOptions options_;
  std::filesystem::path file_;
  bool learning_ = false;
  std::unique_ptr<ValueLearner> learner_;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_LAYER_LEARNING_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_VALUE_LEARNER_H_
#define LATCHWORK_ICARUS_VALUE_LEARNER_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "latchwork/sdk/random.h"
#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/interpreter.h"
#include "reasoners/icarus/machine/value_source.h"

namespace latchwork::icarus {

struct LearningOptions {
  double rate = 0.1;          ///< Of what is new in an estimate, at least; at first more.
  double discount = 0.99;     ///< Of rewards, per cycle.
  double trace = 0.95;        ///< 0: an estimate rests on the next one; 1: on rewards alone.
  double exploration = 0.1;   ///< Share of choices that are made at random.
  std::size_t hold = 1;       ///< Cycles for which such a choice stays the same.
  double initial = 0;         ///< Estimate of what has never been chosen.
  std::size_t window = 4096;  ///< Cycles after which the estimates are brought up to date.
  std::uint64_t seed = 1;
  /// Names of the skills whose values are learned; empty: of all. The others have none, so that
  /// among them the order of the program decides, while learning as after it.
  std::vector<std::string> skills;
};

/// Learns what it is worth to be in a skill: an estimate of the discounted rewards to come for
/// each skill and the features (feature.h) of its arguments. The reward that follows an
/// act is credited to every skill on the path that led to it. With acts = value the highest
/// estimate wins at each skill, with expand = best it decides which means are asked at all.
/// Thread rule: one thread at a time. Source: Shapiro and Langley, Separating skills from
/// preference (ICML 2002), section 4 (SHARSHA: state hierarchy, action, reward, state hierarchy,
/// action), here with returns that reach further than one cycle.
class ValueLearner : public ValueSource {
 public:
  ValueLearner(const Program& program, NamePool& names, const LearningOptions& options);

  std::optional<double> ValueOf(std::uint32_t skill, std::span<const Value> arguments) override;

  /// Before a cycle; decides whether it explores.
  void BeginCycle();
  /// After a cycle: the act that will be done; null: none.
  void Choose(const Act* act);
  /// What came of the last choice; adds up.
  void Reward(double reward);
  /// Nothing comes after the last choice.
  void EndEpisode();

  /// Stops exploring and learning, or begins again.
  void SetLearning(bool learning) { learning_ = learning; }
  /// Another course of exploration, from its first cycle.
  void SetSeed(std::uint64_t seed);

  /// Estimates kept.
  std::size_t size() const { return estimates_.size(); }
  /// One line `(value (Skill argument ...) estimate times)` for each estimate, in their order as
  /// text.
  std::string Write() const;
  /// Takes what Write gave. What is wrong, and skills that the program lacks, are findings.
  void Read(std::string text, std::string file, Findings& findings);

 private:
  struct Estimate {
    std::uint32_t skill = 0;
    std::vector<Value> arguments;
    std::uint64_t hash = 0;
    double value = 0;
    std::uint64_t times = 0;
  };
  using Path = std::vector<std::size_t>;  ///< Estimates; the act's own skill first.
  struct Step {
    Path path;
    double reward = 0;
  };

  static std::uint64_t HashOf(std::uint32_t skill, std::span<const Value> arguments);
  /// The estimate; size() when there is none.
  std::size_t Find(std::uint32_t skill, std::span<const Value> arguments, std::uint64_t hash) const;
  std::size_t FindOrMake(std::uint32_t skill, std::span<const Value> arguments);
  void Learn(bool ended);
  void MoveTowards(std::size_t estimate, double target);
  std::size_t Rarest(const Path& path) const;
  bool Learns(std::uint32_t skill) const { return learns_.empty() || learns_[skill]; }
  double EstimateOf(std::size_t estimate) const;
  std::vector<double> Returns(const Step& step, const Path& next_path,
                              const std::vector<double>& next_returns, double beyond) const;
  void CreditEntered(const Path& before, const Path& path, const std::vector<double>& returns);
  bool ReadLine(const SourceTree& tree, FormId form);
  bool ReadArgument(const SourceTree& tree, FormId form, Value& argument);

  const Program& program_;
  NamePool& names_;
  LearningOptions options_;
  std::vector<bool> learns_;  ///< By skill; empty: all.
  sdk::RandomStream stream_;
  Arena arena_;
  std::vector<Estimate> estimates_;
  std::unordered_multimap<std::uint64_t, std::size_t> places_;  ///< By hash; only looked up in.
  std::vector<Step> steps_;
  Path before_;  ///< The path of the step before the first of them.
  std::uint64_t cycle_ = 0;
  bool learning_ = true;
  bool exploring_ = false;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_VALUE_LEARNER_H_

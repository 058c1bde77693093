// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_PTTP_RANDOM_DOMAIN_H_
#define LATCHWORK_TESTS_REASONERS_PTTP_RANDOM_DOMAIN_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/sdk/random.h"

namespace latchwork::pttp {

/// A name with arguments: constants a, b, c (0 to 2) or variables X, Y, Z (3 to 5).
struct Pattern {
  std::string name;
  std::vector<std::size_t> arguments;
};

/// A small planning domain over three constants, and what is true of it, found out by trying every
/// action in every state that actions lead to.
class RandomDomain {
 public:
  /// The same domain for the same number.
  explicit RandomDomain(std::uint64_t number);

  /// As TPTP: fluents p, q (one argument), h (none) and r (two), each with a situation;
  /// some(S) holds in all situations that follow s0.
  std::string Theory() const;
  /// What is wanted at the end of a plan, and the body of a goal that says so of S.
  std::string WantedText() const;

  /// The number of actions of a shortest plan for what is wanted.
  std::optional<std::size_t> ShortestPlan() const { return shortest_; }
  /// The actions that a shortest plan can begin with, as they are printed.
  const std::set<std::string>& FirstActions() const { return first_actions_; }
  /// The same for plans that contain this action.
  std::optional<std::size_t> ShortestPlanWith(const std::string& action) const;
  const std::vector<std::string>& Actions() const { return actions_; }
  /// Whether a rule concludes about the situation that its body is about.
  bool HasRulesWithin() const;
  /// Whether these actions, the first one first, bring about what is wanted.
  bool IsPlan(const std::vector<std::string>& actions) const;
  /// The pairs for which p and q hold together somewhere: "pair(a, b)".
  const std::set<std::string>& Pairs() const { return pairs_; }

 private:
  using State = std::set<std::string>;
  enum class Kind : std::uint8_t { kWithin, kEffect, kFrame };
  struct Rule {
    Kind kind;
    Pattern head;
    Pattern action;
    std::vector<Pattern> fluents;
    std::vector<Pattern> tests;
    std::optional<Pattern> denied;
  };
  using Values = std::vector<std::size_t>;

  void MakeFacts();
  void MakeRules();
  Rule MakeRule(Kind kind);
  Pattern RandomFluent(std::size_t variables);
  Pattern RandomAction(std::size_t variables);
  std::size_t RandomArgument(std::size_t variables);
  std::size_t Below(std::size_t limit);

  void ChooseWanted();
  void Explore();
  State After(const State& state, const std::string& action) const;
  void CloseWithin(State& state) const;
  void Apply(const Rule& rule, const State& before, State& after, const std::string* action) const;
  bool HasWanted(const State& state) const;
  void NotePairs(const State& state);

  sdk::RandomStream random_;
  std::uint64_t drawn_ = 0;
  std::set<std::string> facts_;
  State initial_;
  std::vector<Rule> rules_;
  State wanted_;
  std::vector<std::string> actions_;
  std::optional<std::size_t> shortest_;
  std::set<std::string> first_actions_;
  std::set<std::string> pairs_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_TESTS_REASONERS_PTTP_RANDOM_DOMAIN_H_

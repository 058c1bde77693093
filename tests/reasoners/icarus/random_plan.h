// SPDX-License-Identifier: BSD-3-Clause
//
// Random teleo-reactive trees and universal plans over a few yes-or-no sensors: as text, and what
// they should do, found without the reader and the translator.
#ifndef LATCHWORK_TESTS_REASONERS_ICARUS_RANDOM_PLAN_H_
#define LATCHWORK_TESTS_REASONERS_ICARUS_RANDOM_PLAN_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace latchwork::icarus::testing {

/// What the sensors say: bit i is the answer of {s i}.
using SensorState = std::uint32_t;

struct Literal {
  std::size_t sensor = 0;
  bool positive = true;
};

class RandomPlan {
 public:
  RandomPlan(std::uint64_t seed, std::size_t sensors) : state_(seed * 2 + 1), sensors_(sensors) {}

 protected:
  std::size_t Roll(std::size_t sides) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>(state_ >> 33U) % sides;
  }
  std::vector<Literal> Literals(std::size_t least, std::size_t most) {
    std::vector<Literal> literals(least + Roll(most - least + 1));
    for (Literal& literal : literals) literal = {Roll(sensors_), Roll(4) != 0};
    return literals;
  }
  std::string NewAct() {
    ++acts_;
    return Roll(3) == 0 ? "{a ?x " + std::to_string(acts_) + "}"
                        : "{act" + std::to_string(acts_) + "}";
  }
  static std::string Text(const std::vector<Literal>& literals) {
    std::string text;
    for (const Literal& literal : literals) {
      const std::string call = "{s " + std::to_string(literal.sensor) + " ?x}";
      text += ' ' + (literal.positive ? call : "(not " + call + ")");
    }
    return text;
  }
  static bool Holds(const std::vector<Literal>& literals, SensorState state) {
    for (const Literal& literal : literals) {
      if (((state >> literal.sensor & 1U) != 0) != literal.positive) return false;
    }
    return true;
  }

 private:
  std::uint64_t state_;
  std::size_t sensors_;
  std::size_t acts_ = 0;
};

/// A tree Main, some of whose rules call a second one.
class RandomTree : public RandomPlan {
 public:
  RandomTree(std::uint64_t seed, std::size_t sensors) : RandomPlan(seed, sensors) {
    helper_ = Make(0, false);
    main_ = Make(0, true);
  }

  std::string Text() const {
    return "(teleo-reactive Main (?x)" + Body(main_) + ")\n(teleo-reactive Helper (?x)" +
           Body(helper_) + ")\n";
  }
  /// The act, as it is written; empty: none.
  std::string Act(SensorState state) const { return ActOf(main_, state); }

 private:
  struct Node {
    std::vector<Literal> conditions;
    std::string act;  ///< Empty: none.
    bool calls_helper = false;
    std::vector<Node> children;
  };

  Node Make(std::size_t depth, bool may_call) {
    Node node;
    node.conditions = Literals(1, 3);
    if (Roll(8) != 0) node.act = NewAct();
    node.calls_helper = may_call && depth > 0 && Roll(5) == 0;
    const std::size_t children = depth == 0 ? 1 + Roll(3) : depth < 3 ? Roll(3) : 0;
    for (std::size_t i = 0; i < children; ++i) node.children.push_back(Make(depth + 1, may_call));
    return node;
  }

  static std::string Body(const Node& root) {
    std::string text = "\n (goal" + RandomPlan::Text(root.conditions) + ")";
    for (const Node& child : root.children) text += Rule(child);
    return text;
  }
  static std::string Rule(const Node& node) {
    std::string text = "\n (when" + RandomPlan::Text(node.conditions) + " do ";
    text += node.calls_helper ? "(Helper ?x)" : node.act;
    for (const Node& child : node.children) text += Rule(child);
    return text + ")";
  }

  /// The shallowest rule whose conditions hold, the goal first of all.
  std::string ActOf(const Node& root, SensorState state) const {
    if (Holds(root.conditions, state)) return "";
    std::deque<const Node*> waiting;
    for (const Node& child : root.children) waiting.push_back(&child);
    for (; !waiting.empty(); waiting.pop_front()) {
      const Node& node = *waiting.front();
      if (Holds(node.conditions, state)) {
        return node.calls_helper ? ActOf(helper_, state) : node.act;
      }
      for (const Node& child : node.children) waiting.push_back(&child);
    }
    return "";
  }

  Node main_;
  Node helper_;
};

/// A universal plan Main.
class RandomUniversalPlan : public RandomPlan {
 public:
  RandomUniversalPlan(std::uint64_t seed, std::size_t sensors) : RandomPlan(seed, sensors) {
    root_ = Make(0);
  }

  std::string Text() const { return "(universal-plan Main (?x)" + TextOf(root_) + ")\n"; }
  /// The act, "true" where the goal holds, empty where the plan has no answer.
  std::string Act(SensorState state) const { return ActOf(root_, state); }

 private:
  struct Goal;
  struct Way {
    std::string act;
    std::vector<Literal> conditions;
    std::vector<Goal> goals;
  };
  struct Goal {
    std::vector<Literal> literals;
    std::vector<Way> ways;
  };

  Goal Make(std::size_t depth) {
    Goal goal;
    goal.literals = Literals(1, 2);
    const std::size_t ways = depth == 0 ? 1 + Roll(2) : Roll(3);
    for (std::size_t i = 0; i < ways; ++i) {
      Way way;
      way.act = NewAct();
      way.conditions = Literals(0, 1);
      const std::size_t goals = depth < 3 ? Roll(3) : 0;
      for (std::size_t j = 0; j < goals; ++j) way.goals.push_back(Make(depth + 1));
      goal.ways.push_back(std::move(way));
    }
    return goal;
  }

  static std::string TextOf(const Goal& goal) {
    std::string text = "\n (achieve" + RandomPlan::Text(goal.literals);
    for (const Way& way : goal.ways) {
      text += "\n (by " + way.act;
      if (!way.conditions.empty()) text += " (if" + RandomPlan::Text(way.conditions) + ")";
      for (const Goal& subgoal : way.goals) text += TextOf(subgoal);
      text += ")";
    }
    return text + ")";
  }

  static std::string ActOf(const Goal& goal, SensorState state) {
    if (Holds(goal.literals, state)) return "true";
    for (const Way& way : goal.ways) {
      const std::string act = ActOf(way, state);
      if (!act.empty()) return act;
    }
    return "";
  }
  static std::string ActOf(const Way& way, SensorState state) {
    if (!Holds(way.conditions, state)) return "";
    for (const Goal& goal : way.goals) {
      const std::string act = ActOf(goal, state);
      if (act != "true") return act;
    }
    return way.act;
  }

  Goal root_;
};

}  // namespace latchwork::icarus::testing

#endif  // LATCHWORK_TESTS_REASONERS_ICARUS_RANDOM_PLAN_H_

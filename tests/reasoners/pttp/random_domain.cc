// SPDX-License-Identifier: BSD-3-Clause
#include "tests/reasoners/pttp/random_domain.h"

#include <algorithm>
#include <array>

namespace latchwork::pttp {
namespace {

constexpr std::size_t kConstants = 3;
constexpr std::size_t kVariables = 3;
constexpr std::array<const char*, kConstants + kVariables> kNames{"a", "b", "c", "X", "Y", "Z"};
constexpr std::array<std::pair<const char*, std::size_t>, 4> kFluents{
    {{"p", 1}, {"q", 1}, {"h", 0}, {"r", 2}}};
constexpr std::array<std::pair<const char*, std::size_t>, 3> kActions{
    {{"move", 2}, {"press", 1}, {"wait", 0}}};
constexpr std::array<std::pair<const char*, std::size_t>, 2> kTests{{{"e", 2}, {"m", 1}}};

/// "p(a, X)"; `last` is one argument more.
std::string Print(const Pattern& pattern, const std::vector<std::size_t>& values,
                  const std::string& last = "") {
  std::string arguments;
  const auto add = [&](const std::string& text) {
    arguments += arguments.empty() ? text : ", " + text;
  };
  for (const std::size_t argument : pattern.arguments) {
    const bool is_bound = argument >= kConstants && !values.empty();
    add(kNames[is_bound ? values[argument - kConstants] : argument]);
  }
  if (!last.empty()) add(last);
  return arguments.empty() ? pattern.name : pattern.name + "(" + arguments + ")";
}

/// A fluent as an atom with its situation.
std::string In(const std::string& fluent, const std::string& situation) {
  if (fluent.back() != ')') return fluent + "(" + situation + ")";
  return fluent.substr(0, fluent.size() - 1) + ", " + situation + ")";
}

/// Calls it with every way to give the variables values.
template <typename Visit>
void ForEachValues(Visit&& visit) {
  std::vector<std::size_t> values(kVariables, 0);
  for (std::size_t i = 0; i < kConstants * kConstants * kConstants; ++i) {
    values = {i % kConstants, i / kConstants % kConstants, i / kConstants / kConstants};
    visit(values);
  }
}

}  // namespace

RandomDomain::RandomDomain(std::uint64_t number) : random_(number, "domain") {
  MakeFacts();
  MakeRules();
  const std::set<std::string> names = [] {
    std::set<std::string> all;
    for (const auto& [name, arity] : kActions) {
      ForEachValues([&, name = name, arity = arity](const Values& values) {
        Pattern action{name, {}};
        for (std::size_t i = 0; i < arity; ++i) action.arguments.push_back(kConstants + i);
        all.insert(Print(action, values));
      });
    }
    return all;
  }();
  actions_.assign(names.begin(), names.end());
  CloseWithin(initial_);
  ChooseWanted();
  Explore();
}

std::size_t RandomDomain::Below(std::size_t limit) {
  return static_cast<std::size_t>(random_.Index(limit, ++drawn_));
}

std::size_t RandomDomain::RandomArgument(std::size_t variables) {
  return variables == 0 || Below(4) == 0 ? Below(kConstants) : kConstants + Below(variables);
}

Pattern RandomDomain::RandomFluent(std::size_t variables) {
  const auto& [name, arity] = kFluents[Below(kFluents.size())];
  Pattern fluent{name, {}};
  for (std::size_t i = 0; i < arity; ++i) fluent.arguments.push_back(RandomArgument(variables));
  return fluent;
}

Pattern RandomDomain::RandomAction(std::size_t variables) {
  const auto& [name, arity] = kActions[Below(kActions.size())];
  Pattern action{name, {}};
  for (std::size_t i = 0; i < arity; ++i) action.arguments.push_back(RandomArgument(variables));
  return action;
}

void RandomDomain::MakeFacts() {
  auto tests = std::vector(kTests.begin(), kTests.end());
  tests.emplace_back("n", 1);
  for (const auto& [name, arity] : tests) {
    ForEachValues([&, name = name, arity = arity](const Values& values) {
      if (Below(arity == 1 ? 3 : 9) > 1) return;
      Pattern fact{name, {kConstants}};
      if (arity == 2) fact.arguments.push_back(kConstants + 1);
      facts_.insert(Print(fact, values));
    });
  }
  for (int i = 0; i < 2; ++i) initial_.insert(Print(RandomFluent(0), {}));
}

void RandomDomain::MakeRules() {
  const std::size_t effects = 5 + Below(5);
  const std::size_t frames = 4 + Below(8);
  for (std::size_t i = 0; i < effects; ++i) rules_.push_back(MakeRule(Kind::kEffect));
  for (std::size_t i = 0; i < frames; ++i) rules_.push_back(MakeRule(Kind::kFrame));
  if (Below(3) == 0) rules_.push_back(MakeRule(Kind::kWithin));
}

RandomDomain::Rule RandomDomain::MakeRule(Kind kind) {
  Rule rule{kind, {}, {}, {}, {}, std::nullopt};
  const bool needs_none = kind == Kind::kEffect && Below(16) == 0;
  const std::size_t fluents = needs_none ? 0 : 1 + Below(3) / 2;
  for (std::size_t i = 0; i < fluents; ++i) rule.fluents.push_back(RandomFluent(2));
  for (std::size_t i = Below(2); i > 0; --i) {
    const auto& [name, arity] = kTests[Below(kTests.size())];
    Pattern test{name, {}};
    for (std::size_t j = 0; j < arity; ++j) test.arguments.push_back(RandomArgument(2));
    rule.tests.push_back(test);
  }
  // What the body binds may be used elsewhere; of the action of a frame rule, anything.
  std::vector<std::size_t> bound = {0, 1, 2};
  for (const auto* patterns : {&rule.fluents, &rule.tests}) {
    for (const Pattern& pattern : *patterns) {
      bound.insert(bound.end(), pattern.arguments.begin(), pattern.arguments.end());
    }
  }
  const auto bind = [&](Pattern& pattern) {
    for (std::size_t& argument : pattern.arguments) argument = bound[Below(bound.size())];
  };
  rule.action = RandomAction(3);
  rule.head = RandomFluent(2);
  bind(rule.head);
  if (kind == Kind::kFrame) {
    rule.head = rule.fluents[0];
  } else {
    bind(rule.action);
  }
  if (Below(4) == 0) {
    rule.denied = Pattern{"n", {kConstants}};
    bind(*rule.denied);
  }
  return rule;
}

std::string RandomDomain::Theory() const {
  std::string text = "cnf(start, axiom, some(s0)). cnf(some, axiom, some(do(A, S)) | ~ some(S)).\n";
  for (const std::string& fact : facts_) text += "cnf(fact, axiom, " + fact + ").\n";
  const auto at = [](const Pattern& pattern, const std::string& situation) {
    return Print(pattern, {}, situation);
  };
  for (const std::string& fluent : initial_) {
    text += "cnf(initially, axiom, " + In(fluent, "s0") + ").\n";
  }
  for (const Rule& rule : rules_) {
    const std::string after =
        rule.kind == Kind::kWithin ? "S" : "do(" + Print(rule.action, {}) + ", S)";
    text += "cnf(rule, axiom, " + at(rule.head, after);
    for (const Pattern& fluent : rule.fluents) text += " | ~ " + at(fluent, "S");
    for (const Pattern& test : rule.tests) text += " | ~ " + Print(test, {});
    if (rule.denied) text += " | " + Print(*rule.denied, {});
    text += ").\n";
  }
  return text;
}

std::string RandomDomain::WantedText() const {
  std::string text = "some(S)";
  for (const std::string& fluent : wanted_) text += " & " + In(fluent, "S");
  return text;
}

bool RandomDomain::HasWanted(const State& state) const {
  return std::includes(state.begin(), state.end(), wanted_.begin(), wanted_.end());
}

void RandomDomain::Apply(const Rule& rule, const State& before, State& after,
                         const std::string* action) const {
  ForEachValues([&](const Values& values) {
    if (action != nullptr && Print(rule.action, values) != *action) return;
    for (const Pattern& fluent : rule.fluents) {
      if (before.count(Print(fluent, values)) == 0) return;
    }
    for (const Pattern& test : rule.tests) {
      if (facts_.count(Print(test, values)) == 0) return;
    }
    if (rule.denied && facts_.count(Print(*rule.denied, values)) != 0) return;
    after.insert(Print(rule.head, values));
  });
}

void RandomDomain::CloseWithin(State& state) const {
  for (std::size_t size = 0; size != state.size();) {
    size = state.size();
    for (const Rule& rule : rules_) {
      if (rule.kind == Kind::kWithin) Apply(rule, State(state), state, nullptr);
    }
  }
}

RandomDomain::State RandomDomain::After(const State& state, const std::string& action) const {
  State after;
  for (const Rule& rule : rules_) {
    if (rule.kind != Kind::kWithin) Apply(rule, state, after, &action);
  }
  CloseWithin(after);
  return after;
}

void RandomDomain::NotePairs(const State& state) {
  for (const char* p : {"a", "b", "c"}) {
    for (const char* q : {"a", "b", "c"}) {
      if (state.count(std::string("p(") + p + ")") == 0) continue;
      if (state.count(std::string("q(") + q + ")") == 0) continue;
      pairs_.insert(std::string("pair(") + p + ", " + q + ")");
    }
  }
}

/// One of the pairs of fluents that take the most actions to bring about, or any pair.
void RandomDomain::ChooseWanted() {
  std::map<State, std::size_t> lengths = {{initial_, 0}};
  std::vector<State> states = {initial_};
  std::map<State, std::size_t> pairs;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const State state = states[i];
    const std::size_t length = lengths[state];
    for (const std::string& first : state) {
      for (const std::string& second : state) pairs.try_emplace({first, second}, length);
    }
    for (const std::string& action : actions_) {
      const State after = After(state, action);
      if (lengths.try_emplace(after, length + 1).second) states.push_back(after);
    }
  }
  std::size_t farthest = 0;
  for (const auto& [pair, length] : pairs) farthest = std::max(farthest, length);
  std::vector<State> far;
  for (const auto& [pair, length] : pairs) {
    if (length == farthest) far.push_back(pair);
  }
  wanted_ = {Print(RandomFluent(0), {}), Print(RandomFluent(0), {})};
  if (!far.empty() && Below(8) != 0) wanted_ = far[Below(far.size())];
}

/// Level by level, with the first actions of all shortest ways to a state.
void RandomDomain::Explore() {
  std::set<State> seen;
  std::map<State, std::set<std::string>> level = {{initial_, {}}};
  for (std::size_t length = 0; !level.empty(); ++length) {
    std::map<State, std::set<std::string>> next;
    for (const auto& entry : level) seen.insert(entry.first);
    const bool found = shortest_.has_value();
    for (const auto& [state, first] : level) {
      NotePairs(state);
      if (!found && HasWanted(state)) {
        shortest_ = length;
        first_actions_.insert(first.begin(), first.end());
      }
      for (const std::string& action : actions_) {
        State after = After(state, action);
        if (seen.count(after) != 0) continue;
        auto& ways = next[std::move(after)];
        if (length == 0) {
          ways.insert(action);
        } else {
          ways.insert(first.begin(), first.end());
        }
      }
    }
    level = std::move(next);
  }
}

std::optional<std::size_t> RandomDomain::ShortestPlanWith(const std::string& action) const {
  using Way = std::pair<State, bool>;
  std::map<Way, std::size_t> lengths = {{{initial_, false}, 0}};
  std::vector<Way> ways = {{initial_, false}};
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const Way way = ways[i];
    const std::size_t length = lengths[way];
    if (way.second && HasWanted(way.first)) return length;
    for (const std::string& next : actions_) {
      const Way after = {After(way.first, next), way.second || next == action};
      if (lengths.try_emplace(after, length + 1).second) ways.push_back(after);
    }
  }
  return std::nullopt;
}

bool RandomDomain::HasRulesWithin() const {
  return std::any_of(rules_.begin(), rules_.end(),
                     [](const Rule& rule) { return rule.kind == Kind::kWithin; });
}

bool RandomDomain::IsPlan(const std::vector<std::string>& actions) const {
  State state = initial_;
  for (const std::string& action : actions) state = After(state, action);
  return HasWanted(state);
}

}  // namespace latchwork::pttp

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_PTTP_LADDER_H_
#define LATCHWORK_TESTS_REASONERS_PTTP_LADDER_H_

#include <string>
#include <string_view>
#include <vector>

#include "tests/reasoners/pttp/agent_mind.h"

namespace latchwork::pttp {

/// Situation calculus over a graph of landmarks.
inline constexpr std::string_view kItinerary = R"(
fof(here, axiom, ![L] : (curr_landmark(L) => robot_at(L, s0))).
fof(go, axiom, ![L, M, S] : ((robot_at(L, S) & adjacent(L, M)) => robot_at(M, do(go(M), S)))).
fof(first, axiom, ![L] : first(do(go(L), s0), L)).
fof(later, axiom, ![A, S, L] : (first(S, L) => first(do(A, S), L))).
fof(target, axiom, ![G, S, L] : ((goal(G) & robot_at(G, S) & first(S, L)) => target_landmark(L))).
)";

/// A ladder of two rails of `length` landmarks each: long shortest paths, and many others.
inline std::vector<std::string> Ladder(int length) {
  std::vector<std::string> facts;
  const auto edge = [&](const std::string& a, const std::string& b) {
    facts.push_back("adjacent(" + a + "," + b + ")");
    facts.push_back("adjacent(" + b + "," + a + ")");
  };
  const auto name = [](char rail, int i) { return std::string(1, rail) + std::to_string(i); };
  for (int i = 0; i < length; ++i) {
    edge(name('a', i), name('b', i));
    if (i + 1 == length) break;
    edge(name('a', i), name('a', i + 1));
    edge(name('b', i), name('b', i + 1));
  }
  return facts;
}

inline void LoadLadder(AgentMind& mind, int length) {
  for (const char* name : {"curr_landmark", "goal"}) mind.Input(name, 1);
  mind.Input("adjacent", 2);
  mind.Goal("target_landmark(L)");
  mind.Load();
  mind.Latch(0, Ladder(length));
}

}  // namespace latchwork::pttp

#endif  // LATCHWORK_TESTS_REASONERS_PTTP_LADDER_H_

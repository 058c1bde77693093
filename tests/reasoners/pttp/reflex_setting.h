// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_PTTP_REFLEX_SETTING_H_
#define LATCHWORK_TESTS_REASONERS_PTTP_REFLEX_SETTING_H_

namespace latchwork::pttp {

/// A robot goes on unless something stands in its gap, or its bumper is touched.
inline constexpr const char* kReflex =
    "fof(ahead, axiom, ! [O, D, G] : ((object(O) & distance(O, D) & gap(G) & $less(D, G))\n"
    "    => halt_robot)).\n"
    "fof(touched, axiom, bumper => halt_robot).\n"
    "fof(go, axiom, ! [V] : ((~ halt_robot & speed(V)) => fwd(V))).\n";

/// Declares what the theory speaks of and loads it, with nothing in the way.
template <typename Mind>
void PrepareReflex(Mind& mind) {
  for (const char* name : {"object", "gap", "speed"}) mind.Input(name, 1);
  mind.Input("distance", 2);
  mind.Input("bumper", 0);
  mind.Minimize("halt_robot", 0);
  mind.Goal("fwd(V)");
  mind.Load();
  mind.Latch(0, {"speed(0.3)", "gap(0.5)"});
}

}  // namespace latchwork::pttp

#endif  // LATCHWORK_TESTS_REASONERS_PTTP_REFLEX_SETTING_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_LAYERED_LAYERED_THEORY_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_LAYERED_LAYERED_THEORY_H_

#include <cstddef>
#include <string>
#include <vector>

#include "reasoners/circumscription/theory/ground_theory.h"

namespace latchwork::circumscription {

/// One goal instance of the layer above, and what it is called here.
struct Bridge {
  Atom goal = 0;   ///< Of the layer above.
  Atom latch = 0;  ///< Of this layer.
  friend bool operator==(const Bridge&, const Bridge&) = default;
};

/// Atoms are numbered per layer: those of different layers are different, whatever their names.
struct TheoryLayer {
  std::string name;  ///< For people; may be empty.
  GroundTheory theory;
  std::vector<Literal> facts;   ///< What the sensors say in this cycle.
  std::vector<Bridge> bridges;  ///< From the next layer above.
};

/// Layers of ground theories, the lowest first (Amir and Maynard-Reid, IJCAI-99). A model of it
/// (Definition 1) is a model of every layer's circumscription
///     CIRC[T + { goal and not ab -> latch : bridges };  ab > minimized;  what varies]
/// in which the atoms of all other layers are fixed. There is one ab for each bridge.
struct LayeredTheory {
  std::vector<TheoryLayer> layers;
};

/// "layer 2", or with its name "layer 2 (seek)"; `index` counts from 0.
std::string LayerName(const LayeredTheory& theory, std::size_t index);
/// "push5 of layer 2 -> vobj5 of layer 1".
std::string BridgeName(const LayeredTheory& theory, std::size_t layer, const Bridge& bridge);

/// A layer with its bridges written out: atoms of the layer first, then one fixed atom for each
/// goal that a bridge comes from, then one ab for each bridge, minimized before everything else.
struct BridgedTheory {
  GroundTheory theory;
  std::vector<Literal> latches;       ///< Facts over fixed atoms; the others are clauses.
  std::vector<Atom> goals;            ///< Of the layer above, each once.
  std::vector<Atom> premises;         ///< What stands for `goals` here.
  std::vector<Atom> abnormal;         ///< One for each bridge.
  std::size_t first_bridge = 0;       ///< The clauses of bridges come from here on,
  std::size_t first_fact_clause = 0;  ///< and those of facts from here on.
};

BridgedTheory WithBridges(const LayeredTheory& theory, std::size_t layer);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_LAYERED_LAYERED_THEORY_H_

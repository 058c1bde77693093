// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/certificate/certificate.h"

#include <algorithm>

namespace latchwork::circumscription {

bool Certificate::Close(std::span<const Literal> latches) {
  propagator_.Reset();
  chosen_ = false;
  for (const Literal latch : latches) {
    if (!propagator_.Assign(latch)) return false;
  }
  if (!propagator_.Propagate() || !KnowsFixed()) return false;
  for (const std::vector<Atom>& level : theory_.levels()) {
    if (!CloseLevel(level)) return false;
  }
  return ChooseVarying();
}

bool Certificate::KnowsFixed() const {
  return std::all_of(theory_.fixed().begin(), theory_.fixed().end(),
                     [&](Atom atom) { return propagator_.Value(atom) != 0; });
}

bool Certificate::CloseLevel(const std::vector<Atom>& atoms) {
  for (const Atom atom : atoms) {
    if (propagator_.Value(atom) == 0) propagator_.Assign(-atom);
  }
  return propagator_.Propagate();
}

bool Certificate::ChooseVarying() {
  forced_ = propagator_.trail().size();
  for (const Atom atom : theory_.varying()) {
    if (propagator_.Value(atom) != 0) continue;
    chosen_ = true;
    propagator_.Assign(-atom);
    if (!propagator_.Propagate()) return false;
  }
  return true;
}

bool Certificate::WasForced(Literal literal) const {
  const std::span<const Literal> forced = propagator_.trail().first(forced_);
  return std::any_of(forced.begin(), forced.end(),
                     [&](Literal other) { return AtomOf(other) == AtomOf(literal); });
}

std::optional<bool> Certificate::SatisfiesAll(std::span<const Literal> clause) const {
  bool holds = false;
  for (const Literal literal : clause) {
    if (!Holds(literal)) continue;
    if (IsDetermined(literal)) return true;
    holds = true;
  }
  if (!holds) return false;
  return std::nullopt;
}

Model Certificate::ToModel() const {
  Model model(theory_.atom_count());
  for (const Literal literal : propagator_.trail()) model.Make(literal);
  return model;
}

}  // namespace latchwork::circumscription

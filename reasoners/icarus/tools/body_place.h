// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_BODY_PLACE_H_
#define LATCHWORK_ICARUS_BODY_PLACE_H_

#include <algorithm>
#include <cstddef>

#include "reasoners/icarus/language/program.h"

namespace latchwork::icarus {

/// Where a clause stands in its skill: slots are asked in their order, clauses in theirs.
struct BodyPlace {
  bool found = false;
  Slot slot = Slot::kObjective;
  std::size_t index = 0;

  friend bool operator<(const BodyPlace& a, const BodyPlace& b) {
    return a.slot != b.slot ? a.slot < b.slot : a.index < b.index;
  }
};

/// Whether the clause is at `form`, or negates one that is.
inline bool Holds(const Clause& clause, FormId form) {
  return clause.form == form ||
         std::any_of(clause.inner.begin(), clause.inner.end(),
                     [&](const Clause& inner) { return Holds(inner, form); });
}

inline BodyPlace FindInBody(const Skill& skill, FormId form) {
  for (std::size_t s = 0; s < kSlots; ++s) {
    const auto* const clauses = skill.slot(static_cast<Slot>(s));
    if (clauses == nullptr) continue;
    for (std::size_t i = 0; i < clauses->size(); ++i) {
      if (Holds((*clauses)[i], form)) return {true, static_cast<Slot>(s), i};
    }
  }
  return {};
}

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_BODY_PLACE_H_

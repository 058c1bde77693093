// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_WHY_H_
#define LATCHWORK_ICARUS_WHY_H_

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/interpreter.h"
#include "reasoners/icarus/machine/value.h"
#include "reasoners/icarus/tools/trace_entry.h"

namespace latchwork::icarus {

/// How an act came about: the skills from the top to the action, each with the conditions that
/// held. To be asked before the next cycle.
std::string Why(const Act& act, const Program& program, const NamePool& names);

/// A skill, and what its arguments should be; a word that begins with '?' stands for anything.
struct CallPattern {
  std::uint32_t skill = kNoSkill;
  std::vector<std::string> arguments;
};

/// What is known of a cycle that has ended.
struct CycleRecord {
  std::span<const TraceEntry> entries;  ///< All, in order.
  std::vector<std::string> memory;      ///< The facts at its end.
};

/// What became of a skill in a cycle: that it was called and is True or acted; or which clause of
/// it failed, deepest first asked for, and on what; or where the way to it was cut off.
std::string WhyNot(const CallPattern& pattern, const CycleRecord& cycle, const Program& program);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_WHY_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_ANSWER_TABLE_H_
#define LATCHWORK_ICARUS_ANSWER_TABLE_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "reasoners/icarus/machine/value.h"

namespace latchwork::icarus {

/// What the world answers from a cycle on. An argument that is none stands for anything.
struct ScriptAnswer {
  std::size_t function = 0;
  std::vector<Value> arguments;
  Value answer;
  std::optional<std::string> failure = {};  ///< The call fails, and says this.
};

/// Which answer holds for a call: that which was set last among those that fit it. Answers outlive
/// the table.
class AnswerTable {
 public:
  void Set(const ScriptAnswer& answer);
  /// Null: there is none.
  const ScriptAnswer* Find(std::size_t function, std::span<const Value> arguments) const;

 private:
  struct Entry {
    const ScriptAnswer* answer = nullptr;
    std::uint64_t number = 0;  ///< Of those that were set.
  };

  std::unordered_multimap<std::uint64_t, Entry> calls_;  ///< By the hash of the call.
  std::vector<Entry> patterns_;  ///< Those that stand for several calls, in the order of numbers.
  std::uint64_t set_ = 0;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_ANSWER_TABLE_H_

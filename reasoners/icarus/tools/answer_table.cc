// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/tools/answer_table.h"

#include <algorithm>

namespace latchwork::icarus {

namespace {

std::uint64_t HashOf(std::size_t function, std::span<const Value> arguments) {
  std::uint64_t hash = MixHash(function, arguments.size());
  for (const Value& argument : arguments) hash = MixHash(hash, Hash(argument));
  return hash;
}

template <typename Same>
bool IsCall(const ScriptAnswer& answer, std::size_t function, std::span<const Value> arguments,
            const Same& same) {
  return answer.function == function && std::equal(answer.arguments.begin(), answer.arguments.end(),
                                                   arguments.begin(), arguments.end(), same);
}

}  // namespace

void AnswerTable::Set(const ScriptAnswer& answer) {
  const Entry entry{&answer, ++set_};
  if (!std::all_of(answer.arguments.begin(), answer.arguments.end(), IsGround)) {
    std::erase_if(patterns_, [&](const Entry& old) {
      return IsCall(*old.answer, answer.function, answer.arguments, Equal);
    });
    patterns_.push_back(entry);
    return;
  }
  const std::uint64_t hash = HashOf(answer.function, answer.arguments);
  const auto [begin, end] = calls_.equal_range(hash);
  const auto known = std::find_if(begin, end, [&](const auto& each) {
    return IsCall(*each.second.answer, answer.function, answer.arguments, Equal);
  });
  if (known != end) {
    known->second = entry;
  } else {
    calls_.emplace(hash, entry);
  }
}

const ScriptAnswer* AnswerTable::Find(std::size_t function,
                                      std::span<const Value> arguments) const {
  const auto [begin, end] = calls_.equal_range(HashOf(function, arguments));
  const auto known = std::find_if(begin, end, [&](const auto& each) {
    return IsCall(*each.second.answer, function, arguments, Equal);
  });
  const auto last = std::find_if(patterns_.rbegin(), patterns_.rend(), [&](const Entry& each) {
    return IsCall(*each.answer, function, arguments, Fits);
  });
  if (known == end) return last == patterns_.rend() ? nullptr : last->answer;
  const bool later = last != patterns_.rend() && last->number > known->second.number;
  return later ? last->answer : known->second.answer;
}

}  // namespace latchwork::icarus

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SCHEDULE_CONTAIN_H_
#define LATCHWORK_SCHEDULE_CONTAIN_H_

#include <exception>
#include <optional>
#include <string>
#include <utility>

namespace latchwork::schedule {

/// Calls foreign code. What it threw, in words; nothing when it returned.
template <typename Call>
std::optional<std::string> Contain(Call&& call) {
  try {
    std::forward<Call>(call)();
    return std::nullopt;
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "threw something that is not a std::exception";
  }
}

}  // namespace latchwork::schedule

#endif  // LATCHWORK_SCHEDULE_CONTAIN_H_

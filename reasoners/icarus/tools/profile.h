// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_PROFILE_H_
#define LATCHWORK_ICARUS_PROFILE_H_

#include <cstdint>
#include <string>
#include <vector>

#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/event.h"

namespace latchwork::icarus {

/// Counts what each skill of a program does.
class SkillProfile : public EventSink {
 public:
  struct Counts {
    std::uint64_t calls = 0;
    std::uint64_t falses = 0;   ///< Calls that came to nothing; those cut short are not counted.
    std::uint64_t clauses = 0;  ///< Evaluated in its own body.
    std::uint64_t host = 0;     ///< Times the host was asked in it.
    std::uint64_t acts = 0;     ///< Found, of an :action.
    std::uint64_t chosen = 0;
  };

  explicit SkillProfile(const Program& program)
      : program_(program), counts_(program.skills.size()) {}

  void OnEvent(const Event& event) override;
  const std::vector<Counts>& counts() const { return counts_; }
  /// A line for each skill, that with the most clauses first.
  std::string Table() const;

 private:
  const Program& program_;
  std::vector<Counts> counts_;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_PROFILE_H_

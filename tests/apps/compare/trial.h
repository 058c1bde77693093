// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_APPS_COMPARE_TRIAL_H_
#define LATCHWORK_TESTS_APPS_COMPARE_TRIAL_H_

#include <cstdint>
#include <map>
#include <string>

#include "apps/compare/report/html.h"

namespace latchwork::compare {

/// An experiment as if it had been made: in one scenario, good and twin always arrive, at the same
/// times; slow 20 s later; bad fails with every seed. Its building has one floor.
class Trial {
 public:
  explicit Trial(std::uint64_t seeds = 12);

  ReportInput Input() const;
  std::string Page() const { return ToHtml(Input()); }

  Experiment experiment;
  Records records;
  Findings findings;
  std::map<std::string, Building> buildings;
};

}  // namespace latchwork::compare

#endif  // LATCHWORK_TESTS_APPS_COMPARE_TRIAL_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_REPORT_VERDICTS_H_
#define LATCHWORK_APPS_COMPARE_REPORT_VERDICTS_H_

#include <string>
#include <string_view>
#include <vector>

#include "apps/compare/report/findings.h"

namespace latchwork::compare {

/// A difference that is shown.
struct Difference {
  std::string scenario;
  std::string what;     ///< "is slower", "is faster", "reaches fewer goals", "reaches more goals".
  std::string figures;  ///< How much, the interval, the effect, p.
};

/// What was found of one agent against the first.
struct AgentVerdict {
  std::string contender;
  std::vector<Difference> differences;
  std::vector<std::string> not_shown;  ///< "goals reached: floor (…), far (…)"; the same of time.
  bool compared = false;               ///< With some seed, both have a run.
};

/// In the order of the experiment.
std::vector<AgentVerdict> Verdicts(const Experiment& experiment, const Findings& findings);

/// Of an agent that is not compared yet.
inline constexpr std::string_view kNotCompared =
    "nothing to compare yet: no seed that both have run";

/// "no runs yet", or how many of them reached their goal: "3 of 5".
std::string ReachedOf(const Tally& tally);

/// The whole in words: who is better than the first at what, and where; of whom no difference is
/// shown; whether there are seeds enough to show any.
std::string Overview(const Experiment& experiment, const Findings& findings);

/// "p = 0.0123", "p < 0.001".
std::string PValue(double p);
/// The same without "p = ".
std::string PFigure(double p);
/// With its sign, but for noughts: "+1.5", "-1.5", "0.0".
std::string Signed(double value, int digits);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_REPORT_VERDICTS_H_

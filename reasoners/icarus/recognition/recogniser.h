// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_RECOGNISER_H_
#define LATCHWORK_ICARUS_RECOGNISER_H_

#include <cstddef>
#include <string>
#include <vector>

#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/program.h"

namespace latchwork::icarus {

/// How well a plan accounts for what an agent was seen to do.
struct Evidence {
  std::size_t cycles = 0;     ///< In which something was observed.
  std::size_t explained = 0;  ///< In which the plan offers what was done.
  double precision = 0;       ///< Mean over those cycles of 1 / acts offered; 0 where not offered.
  double log_likelihood = 0;
  std::vector<std::string> unanswered;  ///< Sensors of the plan that the recording does not have.
};

/// Runs the plan `top` of a program without errors on a recording, a world script whose `expect`
/// says what was done in each cycle. All acts that the plan offers are equally likely, and a small
/// share of what agents do is something else. A sensor that the recording lacks is False. Mistakes
/// of the script and of the top call are findings.
/// Source: the plan recognition that Shapiro and Langley (Agents'99, section 6) name as future
/// work.
Evidence WeighPlan(const Program& program, const std::string& top, const std::string& recording,
                   const std::string& file, Findings& findings);

/// The probabilities of several plans, all as likely before anything was seen.
std::vector<double> Posterior(const std::vector<Evidence>& evidence);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_RECOGNISER_H_

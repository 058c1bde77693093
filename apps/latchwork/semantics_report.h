// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_SEMANTICS_REPORT_H_
#define LATCHWORK_APPS_LATCHWORK_SEMANTICS_REPORT_H_

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "apps/latchwork/semantics_findings.h"
#include "apps/latchwork/semantics_problem.h"

namespace latchwork::app {

/// Conditions, comparison and counter-example, for people.
std::string Describe(const SemanticsProblem& problem, const SemanticsFindings& findings);
/// A line for each query: `ID VERDICT` of the only transfer, or, where there are several,
/// `LETTER ID VERDICT`, the letters being s, o, r, and = for Definition 1, which comes last.
std::string AnswerLines(const SemanticsProblem& problem, const SemanticsFindings& findings);
/// All of it as data.
nlohmann::ordered_json ToJson(const SemanticsProblem& problem, const SemanticsFindings& findings);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_SEMANTICS_REPORT_H_

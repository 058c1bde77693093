// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_ENTAIL_PROBLEM_H_
#define LATCHWORK_APPS_LATCHWORK_ENTAIL_PROBLEM_H_

#include <string>
#include <vector>

#include "apps/latchwork/tptp_input.h"
#include "latchwork/logic/diagnostic.h"
#include "reasoners/circumscription/formats/circ_file.h"
#include "reasoners/circumscription/theory/ground_theory.h"

namespace latchwork::app {

/// What the command line says about the theory and what is asked.
struct EntailInput {
  TptpInput input;
  std::vector<std::string> minimize;  ///< Lists `p/1,q/2`, one for each priority level.
  std::vector<std::string> vary;
  std::vector<std::string> fix;
  std::vector<std::string> queries;  ///< Formulas.
  bool brave = false;                ///< Of queries to a TPTP problem.
};

/// What is asked of which theory.
struct EntailProblem {
  circumscription::GroundTheory theory;
  std::vector<circumscription::Literal> latches;
  std::vector<circumscription::Query> queries;
  logic::Diagnostics diagnostics;  ///< Where there are any, the rest must not be used.
};

EntailProblem ReadEntailProblem(const EntailInput& input);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_ENTAIL_PROBLEM_H_

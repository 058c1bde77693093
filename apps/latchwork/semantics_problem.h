// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_SEMANTICS_PROBLEM_H_
#define LATCHWORK_APPS_LATCHWORK_SEMANTICS_PROBLEM_H_

#include <string>
#include <vector>

#include "latchwork/logic/diagnostic.h"
#include "reasoners/circumscription/formats/lay_file.h"
#include "reasoners/circumscription/layered/layered_theory.h"

namespace latchwork::app {

/// A layered theory, and what is asked of its lowest layer.
struct SemanticsProblem {
  circumscription::LayeredTheory theory;
  std::vector<circumscription::Query> queries;
  logic::Diagnostics diagnostics;  ///< Where there are any, the rest must not be used.
  bool plugin_failure = false;     ///< Of an agent: a part cannot be loaded.
};

/// Reads a .lay file; "-" is standard input.
SemanticsProblem ReadLayProblem(const std::string& name);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_SEMANTICS_PROBLEM_H_

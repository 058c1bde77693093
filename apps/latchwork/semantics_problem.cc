// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/semantics_problem.h"

#include <optional>
#include <utility>

#include "apps/latchwork/input_text.h"

namespace latchwork::app {

SemanticsProblem ReadLayProblem(const std::string& name) {
  SemanticsProblem problem;
  const std::optional<std::string> text = ReadInputText(name, problem.diagnostics);
  if (!text) return problem;
  circumscription::LayFile file = circumscription::ReadLay(*text, name);
  problem.theory = std::move(file.theory);
  problem.queries = std::move(file.queries);
  problem.diagnostics = std::move(file.diagnostics);
  return problem;
}

}  // namespace latchwork::app

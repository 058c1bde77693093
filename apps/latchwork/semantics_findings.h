// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_SEMANTICS_FINDINGS_H_
#define LATCHWORK_APPS_LATCHWORK_SEMANTICS_FINDINGS_H_

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "apps/latchwork/semantics_problem.h"
#include "reasoners/circumscription/layered/conditions.h"
#include "reasoners/circumscription/layered/difference.h"
#include "reasoners/circumscription/layered/procedure.h"

namespace latchwork::app {

/// What one way of transfer came to.
struct TransferFindings {
  circumscription::Transfer transfer = circumscription::Transfer::kSingle;
  std::vector<circumscription::LayerOutcome> layers;  ///< The lowest first.
  std::vector<circumscription::Verdict> verdicts;     ///< One for each query.
};

/// The first difference, cut down to a theory of which no part can be left out.
struct SmallestDifference {
  circumscription::Transfer transfer = circumscription::Transfer::kSingle;
  circumscription::Fault fault = circumscription::Fault::kUnsound;
  std::size_t query = 0;
  circumscription::CounterExample example;
  /// Per layer the atoms that hold in a layered model of the example which falsifies the query.
  std::optional<std::vector<std::vector<std::string>>> model;
};

struct SemanticsFindings {
  circumscription::Conditions conditions;
  std::vector<circumscription::Verdict> definition;  ///< One for each query.
  std::vector<TransferFindings> transfers;
  std::optional<SmallestDifference> difference;

  std::size_t Count(const TransferFindings& transfer, circumscription::Fault fault) const;
  /// Queries that the transfer or Definition 1 leaves open.
  std::size_t CountUndecided(const TransferFindings& transfer) const;
  bool AllDecided() const;
};

/// Evaluates Definition 1 and the procedure, with each of `transfers`.
SemanticsFindings Evaluate(const SemanticsProblem& problem,
                           const std::vector<circumscription::Transfer>& transfers,
                           const circumscription::ProcedureOptions& options);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_SEMANTICS_FINDINGS_H_

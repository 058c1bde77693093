// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/semantics_findings.h"

#include <algorithm>
#include <utility>

#include "reasoners/circumscription/layered/layered_models.h"

namespace latchwork::app {
namespace {

namespace circ = latchwork::circumscription;

/// Unsound answers first: they are the ones that do harm.
std::optional<SmallestDifference> FirstDifference(const SemanticsFindings& findings) {
  for (const circ::Fault fault : {circ::Fault::kUnsound, circ::Fault::kIncomplete}) {
    for (const TransferFindings& transfer : findings.transfers) {
      for (std::size_t i = 0; i < transfer.verdicts.size(); ++i) {
        if (circ::Compare(transfer.verdicts[i], findings.definition[i]) != fault) continue;
        return SmallestDifference{transfer.transfer, fault, i, {}, std::nullopt};
      }
    }
  }
  return std::nullopt;
}

std::vector<std::vector<std::string>> TrueAtoms(const circ::LayeredTheory& theory,
                                                const circ::LayeredModels& models,
                                                const circ::Model& model) {
  std::vector<std::vector<std::string>> names(theory.layers.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const circ::GroundTheory& layer = theory.layers[i].theory;
    for (circ::Atom atom = 1; atom <= static_cast<circ::Atom>(layer.atoms.size()); ++atom) {
      if (model.Holds(models.Joint(i, atom))) names[i].push_back(ToString(layer, atom));
    }
  }
  return names;
}

void Reduce(const SemanticsProblem& problem, const circ::ProcedureOptions& options,
            SmallestDifference& difference) {
  difference.example = circ::Shrink({problem.theory, problem.queries[difference.query].literals},
                                    difference.transfer, difference.fault, options);
  circ::LayeredModels models(difference.example.theory, options.engine);
  std::vector<circ::Literal> negation;
  for (const circ::Literal literal : difference.example.clause) {
    negation.push_back(-models.Joint(0, literal));
  }
  circ::Model model;
  if (models.Find(negation, model) != circ::SatResult::kSatisfiable) return;
  difference.model = TrueAtoms(difference.example.theory, models, model);
}

}  // namespace

std::size_t SemanticsFindings::Count(const TransferFindings& transfer, circ::Fault fault) const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < definition.size(); ++i) {
    if (circ::Compare(transfer.verdicts[i], definition[i]) == fault) ++count;
  }
  return count;
}

std::size_t SemanticsFindings::CountUndecided(const TransferFindings& transfer) const {
  constexpr auto kUnknown = circumscription::Verdict::kUnknown;
  std::size_t count = 0;
  for (std::size_t i = 0; i < definition.size(); ++i) {
    if (transfer.verdicts[i] == kUnknown || definition[i] == kUnknown) ++count;
  }
  return count;
}

bool SemanticsFindings::AllDecided() const {
  const auto decided = [](const std::vector<circ::Verdict>& verdicts) {
    return std::count(verdicts.begin(), verdicts.end(), circ::Verdict::kUnknown) == 0;
  };
  return decided(definition) && decided(conditions.layers_have_models) &&
         std::all_of(transfers.begin(), transfers.end(),
                     [&](const TransferFindings& transfer) { return decided(transfer.verdicts); });
}

SemanticsFindings Evaluate(const SemanticsProblem& problem,
                           const std::vector<circ::Transfer>& transfers,
                           const circ::ProcedureOptions& options) {
  SemanticsFindings findings;
  findings.conditions = circ::CheckConditions(problem.theory, options.engine);
  circ::LayeredModels models(problem.theory, options.engine);
  for (const circ::Query& query : problem.queries) {
    findings.definition.push_back(models.Entails(query.literals).verdict);
  }
  for (const circ::Transfer transfer : transfers) {
    circ::Procedure procedure(problem.theory, transfer, options);
    TransferFindings found{transfer, procedure.outcomes(), {}};
    for (const circ::Query& query : problem.queries) {
      found.verdicts.push_back(procedure.Entails(query.literals).verdict);
    }
    findings.transfers.push_back(std::move(found));
  }
  findings.difference = FirstDifference(findings);
  if (findings.difference) Reduce(problem, options, *findings.difference);
  return findings;
}

}  // namespace latchwork::app

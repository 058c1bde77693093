// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/derivation.h"

#include <string>

namespace latchwork::pttp {
namespace {

using Kind = sdk::DerivationStep::Kind;

void Describe(const Step& step, const Engine& engine, sdk::DerivationStep& result) {
  const std::string_view predicate =
      engine.predicates()[step.node->literal->predicate].name.symbol.name();
  switch (step.kind) {
    case Step::Kind::kRule: {
      const logic::Clause& clause = engine.program().clauses()[step.rule->clause];
      result.source = clause.name;
      result.place = clause.place;
      break;
    }
    case Step::Kind::kFact:
      result.kind = step.source->is_latch ? Kind::kLatch : Kind::kClause;
      result.source = step.source->name();
      break;
    case Step::Kind::kReduction:
      result.kind = Kind::kReduction;
      break;
    case Step::Kind::kEquality:
    case Step::Kind::kArithmetic:
      result.kind = Kind::kArithmetic;
      result.source = predicate;
      break;
    case Step::Kind::kAttachment:
      result.kind = Kind::kAttachment;
      result.source = predicate;
      break;
    case Step::Kind::kAssumption:
      result.kind = Kind::kAssumption;
      result.source = predicate;
      break;
  }
}

}  // namespace

sdk::Derivation MakeDerivation(const Proof& proof, const Engine& engine) {
  sdk::Derivation derivation;
  std::vector<const Node*> nodes;
  // The newest step comes first, so children are met before their parents.
  for (const Step* step = proof.steps; step != nullptr; step = step->previous) {
    sdk::DerivationStep result;
    result.conclusion =
        ToString(logic::Literal{step->node->literal->positive, engine.Instance(*step->node)});
    Describe(*step, engine, result);
    for (std::size_t i = nodes.size(); i > 0; --i) {
      if (nodes[i - 1]->parent == step->node) result.premises.push_back(i - 1);
    }
    nodes.push_back(step->node);
    derivation.steps.push_back(std::move(result));
  }
  return derivation;
}

}  // namespace latchwork::pttp

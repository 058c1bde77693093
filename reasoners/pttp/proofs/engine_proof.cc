// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/engine_proof.h"

#include <algorithm>
#include <vector>

namespace latchwork::pttp {
namespace {

class Collector {
 public:
  Collector(Engine& engine, ProofPrinter& printer) : engine_(engine), printer_(printer) {}

  void AddRule(const Contrapositive& rule, const Word* slots) {
    ClauseInstance instance{rule.clause, {}, {}};
    if (rule.has_head) {
      instance.literals.push_back(
          {rule.head.positive, engine_.Instance(rule.head, slots, variables_)});
    }
    for (const CompiledLiteral& literal : rule.body) {
      instance.literals.push_back(
          {!literal.positive, engine_.Instance(literal, slots, variables_)});
    }
    const std::size_t variables = printer_.clauses()[rule.clause].variable_names.size();
    for (std::size_t i = 0; i < variables; ++i) {
      instance.values.push_back(engine_.Value(slots[i], variables_));
    }
    printer_.Add(instance);
  }

  void AddStep(const Step& step) {
    const logic::Literal literal{step.node->literal->positive,
                                 engine_.Instance(*step.node, variables_)};
    switch (step.kind) {
      case Step::Kind::kRule:
        AddRule(*step.rule, step.slots);
        break;
      case Step::Kind::kFact:
        AddFact(literal);
        break;
      case Step::Kind::kEquality:
        printer_.AddTheoryFact(literal, "equality");
        break;
      case Step::Kind::kArithmetic:
      case Step::Kind::kAttachment:
      case Step::Kind::kAssumption:
        printer_.AddTheoryFact(literal, "arithmetic");
        break;
      case Step::Kind::kReduction:
        break;
    }
  }

 private:
  void AddFact(const logic::Literal& fact) {
    const auto clauses = printer_.clauses();
    const auto place = std::find_if(clauses.begin(), clauses.end(), [&](const auto& clause) {
      return clause.literals.size() == 1 && clause.literals[0] == fact;
    });
    if (place == clauses.end()) return;
    printer_.Add({static_cast<std::uint32_t>(place - clauses.begin()), {fact}, {}});
  }

  Engine& engine_;
  ProofPrinter& printer_;
  std::vector<Word> variables_;
};

}  // namespace

void AddProof(const Proof& proof, Engine& engine, ProofPrinter& printer) {
  Collector collector(engine, printer);
  collector.AddRule(*proof.start, proof.slots);
  std::vector<const Step*> steps;
  for (const Step* step = proof.steps; step != nullptr; step = step->previous) {
    steps.push_back(step);
  }
  std::reverse(steps.begin(), steps.end());
  for (const Step* step : steps) collector.AddStep(*step);
}

}  // namespace latchwork::pttp

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/engine_proof.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace latchwork::pttp {
namespace {

class Collector {
 public:
  Collector(Engine& engine, ProofPrinter& printer) : engine_(engine), printer_(printer) {}

  void AddRule(const Contrapositive& rule, const Word* slots) {
    ClauseInstance instance{rule.clause, {}, {}};
    if (rule.has_head) {
      instance.literals.push_back({rule.head.positive, HeadAsWritten(rule, slots)});
    }
    for (const CompiledLiteral& literal : OwnBody(rule)) {
      instance.literals.push_back(
          {!literal.positive, engine_.Instance(literal, slots, variables_)});
    }
    const std::size_t variables = printer_.clauses()[rule.clause].variable_names.size();
    for (std::size_t i = 0; i < variables; ++i) {
      instance.values.push_back(engine_.Value(slots[i], variables_));
    }
    printer_.Add(instance);
    for (const logic::Literal& literal : instance.literals) AddValues(literal);
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
        printer_.AddTheoryFact({literal}, "equality");
        break;
      case Step::Kind::kArithmetic:
      case Step::Kind::kAttachment:
      case Step::Kind::kAssumption:
        printer_.AddTheoryFact({literal}, "arithmetic");
        break;
      case Step::Kind::kReduction:
        break;
    }
  }

 private:
  /// Without the equations that stand for what a conclusion computes.
  std::span<const CompiledLiteral> OwnBody(const Contrapositive& rule) const {
    const std::size_t own =
        printer_.clauses()[rule.clause].literals.size() - (rule.has_head ? 1 : 0);
    return std::span(rule.body).first(std::min(own, rule.body.size()));
  }

  /// With the terms in it that were put into equations.
  logic::Atom HeadAsWritten(const Contrapositive& rule, const Word* slots) {
    const logic::Atom head = engine_.Instance(rule.head, slots, variables_);
    std::vector<logic::Term> arguments(head.arguments().begin(), head.arguments().end());
    for (std::size_t i = OwnBody(rule).size(); i < rule.body.size(); ++i) {
      const CompiledLiteral& equation = rule.body[i];
      const Word* const end = rule.head.arguments + rule.head.arity;
      const Word* const place = std::find(rule.head.arguments, end, equation.arguments[0]);
      if (place == end) continue;
      const logic::Atom computed = engine_.Instance(equation, slots, variables_);
      arguments[static_cast<std::size_t>(place - rule.head.arguments)] = computed.arguments()[1];
    }
    return {head.predicate(), std::move(arguments)};
  }

  /// The literal is used with its terms computed: why it may be.
  void AddValues(const logic::Literal& literal) {
    std::vector<logic::Term> arguments(literal.atom.arguments().begin(),
                                       literal.atom.arguments().end());
    for (logic::Term& argument : arguments) {
      if (auto value = engine_.arithmetic().Normalize(argument)) argument = *std::move(value);
    }
    logic::Literal computed{literal.positive,
                            logic::Atom(literal.atom.predicate(), std::move(arguments))};
    if (computed == literal) return;
    printer_.AddTheoryFact({{!literal.positive, literal.atom}, std::move(computed)}, "arithmetic");
  }

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

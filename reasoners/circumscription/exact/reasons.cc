// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/exact/reasons.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace latchwork::circumscription {

std::optional<Core> ReasonsFor(const GroundTheory& theory, std::span<const Literal> latches,
                               std::span<const Literal> assumed, Literal conclusion,
                               Spending* spending) {
  std::vector<Literal> given(latches.begin(), latches.end());
  given.insert(given.end(), assumed.begin(), assumed.end());
  given.push_back(-conclusion);
  return MinimalCore(theory, given, -1, spending);
}

logic::Fact FactOf(const GroundStore& store, const ValueBank& bank, const Relations& relations,
                   Atom atom) {
  std::vector<logic::Term> terms;
  for (const Value& cell : store.Cells(atom)) terms.push_back(bank.ToTerm(cell));
  return {relations[store.place(atom).relation].name.symbol, terms};
}

namespace {

/// The clauses of a body that a core needs, each once, in order.
std::vector<std::size_t> SourcesOf(const GroundStore& store, const Core& core) {
  std::vector<std::size_t> sources;
  for (const std::size_t clause : core.clauses) {
    if (store.source(clause) != kNoIndex) sources.push_back(store.source(clause));
  }
  std::sort(sources.begin(), sources.end());
  sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
  return sources;
}

}  // namespace

std::string Describe(const GroundStore& store, const Evaluator& evaluator,
                     const std::optional<Core>& core) {
  std::string text = "body and latches contradict each other";
  if (!core) return text;
  const auto sources = SourcesOf(store, *core);
  std::string_view separator = sources.size() > 1 ? ": clauses " : ": clause ";
  for (const std::size_t source : sources) {
    text += fmt::format("{}'{}'", separator, evaluator.program().clauses()[source].name);
    separator = ", ";
  }
  separator = " with ";
  for (const Literal literal : core->latches) {
    const logic::Fact fact =
        FactOf(store, evaluator.bank(), evaluator.program().relations(), AtomOf(literal));
    text += fmt::format("{}{}", separator, ToString(logic::Literal{literal > 0, fact}));
    separator = ", ";
  }
  return text;
}

namespace {

using Kind = sdk::DerivationStep::Kind;

/// What is given comes from a latch, an attachment or the body; all else is assumed.
sdk::DerivationStep StepOf(const GroundStore& store, const Evaluator& evaluator,
                           std::span<const std::string> ports, Literal literal) {
  const Atom atom = AtomOf(literal);
  const std::size_t relation = store.place(atom).relation;
  const logic::Fact fact = FactOf(store, evaluator.bank(), evaluator.program().relations(), atom);
  sdk::DerivationStep step;
  step.kind = Kind::kAssumption;
  step.conclusion = ToString(logic::Literal{literal > 0, fact});
  step.source = fact.predicate().name();
  if (store.theory().at(atom).role != Role::kFixed) return step;
  step.kind = Kind::kLatch;
  const std::uint32_t row = evaluator.table(relation).Find(store.Cells(atom));
  if (row == FactTable::kNone) return step;
  const FactInfo& info = evaluator.table(relation).info(row);
  if (info.origin == FactInfo::Origin::kLatch) step.source = ports[info.source];
  if (info.origin == FactInfo::Origin::kAttachment) step.kind = Kind::kAttachment;
  return step;
}

}  // namespace

sdk::Derivation DeriveFromCore(const GroundStore& store, const Evaluator& evaluator,
                               std::span<const std::string> ports, const std::optional<Core>& core,
                               const logic::Fact& fact) {
  sdk::Derivation derivation;
  if (core) {
    const std::string contrary = ToString(logic::Literal{false, fact});
    for (const Literal literal : core->latches) {
      sdk::DerivationStep step = StepOf(store, evaluator, ports, literal);
      if (step.kind == Kind::kAssumption && step.conclusion == contrary) continue;
      derivation.steps.push_back(std::move(step));
    }
    for (const std::size_t source : SourcesOf(store, *core)) {
      const logic::Clause& clause = evaluator.program().clauses()[source];
      derivation.steps.push_back({Kind::kClause, ToString(clause), clause.name, clause.place, {}});
    }
  }
  sdk::DerivationStep last;
  last.kind = Kind::kReduction;
  last.conclusion = ToString(fact);
  last.source = "minimal models";
  last.premises.resize(derivation.steps.size());
  std::iota(last.premises.begin(), last.premises.end(), std::size_t{0});
  derivation.steps.push_back(std::move(last));
  return derivation;
}

}  // namespace latchwork::circumscription

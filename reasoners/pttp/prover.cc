// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/prover.h"

#include <algorithm>

#include "latchwork/logic/clausify.h"
#include "reasoners/pttp/engine.h"
#include "reasoners/pttp/equality_axioms.h"
#include "reasoners/pttp/proof_printer.h"

namespace latchwork::pttp {
namespace {

using logic::Clause;
using logic::Term;

/// Whether a term means something by itself: a number, a distinct object, an interpreted function.
bool HasFixedMeaning(const Term& term) {
  std::vector<const Term*> visits{&term};
  while (!visits.empty()) {
    const Term& current = *visits.back();
    visits.pop_back();
    if (current.is_number()) return true;
    if (current.is_variable()) continue;
    const logic::Symbol symbol = current.symbol();
    if (symbol.kind() == logic::SymbolKind::kDistinctObject || symbol.name().starts_with('$')) {
      return true;
    }
    for (const Term& argument : current.arguments()) visits.push_back(&argument);
  }
  return false;
}

bool HasFixedMeaning(const Clause& clause) {
  return std::any_of(clause.literals.begin(), clause.literals.end(), [](const auto& literal) {
    const auto arguments = literal.atom.arguments();
    return literal.atom.predicate().name().starts_with('$') ||
           std::any_of(arguments.begin(), arguments.end(),
                       [](const Term& term) { return HasFixedMeaning(term); });
  });
}

class RefutationSink final : public ProofSink {
 public:
  RefutationSink(Engine& engine, const ProofSources& sources, ProverResult& result)
      : engine_(engine), sources_(sources), result_(result) {}

  bool Accept(const Proof& proof) override {
    result_.statistics.depth = proof.depth;
    ProofPrinter printer(engine_, sources_);
    printer.Print(proof);
    result_.proof = std::move(printer.lines);
    result_.uses_conjecture = printer.uses_conjecture();
    result_.answers = std::move(printer.answers);
    return true;
  }

 private:
  Engine& engine_;
  ProofSources sources_;
  ProverResult& result_;
};

Szs StatusOf(SearchEnd end, const Meter& meter, bool conjecture, bool decidable) {
  switch (end) {
    case SearchEnd::kAccepted:
      return conjecture ? Szs::kTheorem : Szs::kUnsatisfiable;
    case SearchEnd::kExhausted:
      if (!decidable) return Szs::kGaveUp;
      return conjecture ? Szs::kCounterSatisfiable : Szs::kSatisfiable;
    case SearchEnd::kStopped:
      return meter.limit() == sdk::Limit::kInferences ? Szs::kResourceOut : Szs::kTimeout;
    case SearchEnd::kDepth:
    case SearchEnd::kUndetermined:
      break;
  }
  return Szs::kGaveUp;
}

/// Clauses of the negated conjecture first, then every other clause without a positive literal:
/// some minimal refutation starts at one of the latter (Loveland 1968).
std::vector<const Contrapositive*> StartClauses(const Program& program) {
  std::vector<const Contrapositive*> starts;
  for (const Contrapositive& start : program.conjectures()) starts.push_back(&start);
  for (const Contrapositive& start : program.negatives()) {
    if (program.clauses()[start.clause].role != logic::Role::kNegatedConjecture) {
      starts.push_back(&start);
    }
  }
  return starts;
}

}  // namespace

std::string_view Name(Szs status) {
  switch (status) {
    case Szs::kTheorem:
      return "Theorem";
    case Szs::kUnsatisfiable:
      return "Unsatisfiable";
    case Szs::kCounterSatisfiable:
      return "CounterSatisfiable";
    case Szs::kSatisfiable:
      return "Satisfiable";
    case Szs::kGaveUp:
      return "GaveUp";
    case Szs::kTimeout:
      return "Timeout";
    case Szs::kResourceOut:
      return "ResourceOut";
  }
  return "Unknown";
}

ProverResult Prove(const std::vector<logic::AnnotatedFormula>& formulas,
                   logic::SymbolTable& symbols, std::string_view file,
                   const ProverOptions& options) {
  ProverResult result;
  logic::ClauseOrigins origins;
  std::vector<Clause> clauses =
      logic::Clausify(formulas, symbols, {}, nullptr, options.proof ? &origins : nullptr);
  const bool decidable = std::none_of(clauses.begin(), clauses.end(),
                                      [](const Clause& clause) { return HasFixedMeaning(clause); });
  for (Clause& axiom : EqualityAxioms(clauses, {}, symbols)) clauses.push_back(std::move(axiom));
  result.clauses = clauses.size();
  Engine engine(symbols, {});
  engine.SetTheory(std::move(clauses), {});
  engine.Begin(options.budget);
  SearchRequest request;
  request.starts = StartClauses(engine.program());
  request.reach = &engine.ReachFor(request.starts, false);
  request.depth = options.budget.depth;
  request.record = options.proof;
  RefutationSink sink(engine, {formulas, origins, file}, result);
  const SearchEnd end = engine.Search(request, sink);
  const bool conjecture = std::any_of(formulas.begin(), formulas.end(), [](const auto& formula) {
    return formula.role == logic::Role::kConjecture;
  });
  result.status = StatusOf(end, engine.meter(), conjecture, decidable);
  result.statistics.inferences = engine.meter().inferences();
  result.message = engine.obstacle();
  return result;
}

}  // namespace latchwork::pttp

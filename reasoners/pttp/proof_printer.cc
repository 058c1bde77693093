// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proof_printer.h"

#include <fmt/format.h>

#include <algorithm>

namespace latchwork::pttp {
namespace {

using logic::Clause;
using logic::Formula;
using logic::Symbol;
using logic::Term;

void CollectSymbols(const logic::Atom& atom, std::set<Symbol>& symbols) {
  symbols.insert(atom.predicate());
  std::vector<const Term*> visits;
  for (const Term& term : atom.arguments()) visits.push_back(&term);
  while (!visits.empty()) {
    const Term& term = *visits.back();
    visits.pop_back();
    if (term.is_variable() || term.is_number()) continue;
    symbols.insert(term.symbol());
    for (const Term& argument : term.arguments()) visits.push_back(&argument);
  }
}

std::set<Symbol> SymbolsOf(const Formula& formula) {
  std::set<Symbol> symbols;
  std::vector<const Formula*> visits{&formula};
  while (!visits.empty()) {
    const Formula& current = *visits.back();
    visits.pop_back();
    if (current.kind() == Formula::Kind::kAtom) CollectSymbols(current.atom(), symbols);
    for (const Formula& child : current.children()) visits.push_back(&child);
  }
  return symbols;
}

/// Symbols that clausification brought in, as TSTP lists them.
std::string NewSymbols(const Clause& clause, const std::set<Symbol>& known) {
  std::set<Symbol> symbols;
  for (const auto& literal : clause.literals) CollectSymbols(literal.atom, symbols);
  std::string result;
  for (const Symbol symbol : symbols) {
    if (known.contains(symbol)) continue;
    if (!result.empty()) result += ",";
    result += logic::QuoteWord(symbol.name());
  }
  return result;
}

}  // namespace

std::string ProofPrinter::Leaf(const logic::AnnotatedFormula& formula) {
  auto& name = leaves_[formula.name];
  if (!name.empty()) return name;
  name = logic::QuoteWord(formula.name);
  const std::string_view role = formula.role == logic::Role::kConjecture ? "conjecture"
                                : formula.role == logic::Role::kNegatedConjecture
                                    ? "negated_conjecture"
                                    : "axiom";
  lines.push_back(fmt::format("{}({}, {}, {}, file({}, {})).", formula.is_clause ? "cnf" : "fof",
                              name, role, ToString(formula.formula, formula.variable_names),
                              logic::QuoteWord(file_), name));
  return name;
}

std::string ProofPrinter::NegatedConjecture(const logic::AnnotatedFormula* formula) {
  auto& name = leaves_["~"];
  if (!name.empty()) return name;
  std::vector<std::string> parents;
  std::string conjunction;
  for (const auto& candidate : formulas_) {
    if (candidate.role != logic::Role::kConjecture) continue;
    if (formula == nullptr) formula = &candidate;
    parents.push_back(Leaf(candidate));
    if (!conjunction.empty()) conjunction += " & ";
    conjunction += fmt::format("({})", ToString(candidate.formula, candidate.variable_names));
  }
  name = "negated_conjecture_0";
  lines.push_back(
      fmt::format("fof({}, negated_conjecture, ~ ({}), inference(negate,[status(cth)],[{}])).",
                  name, conjunction, fmt::join(parents, ",")));
  return name;
}

std::string ProofPrinter::Parent(const Clause& clause) {
  for (const auto& formula : formulas_) {
    if (formula.name != clause.name) continue;
    return formula.role == logic::Role::kConjecture ? NegatedConjecture(&formula) : Leaf(formula);
  }
  return clause.role == logic::Role::kNegatedConjecture ? NegatedConjecture(nullptr)
                                                        : std::string();
}

std::string ProofPrinter::ClauseLine(std::uint32_t index) {
  auto& name = clauses_[index];
  if (!name.empty()) return name;
  const Clause& clause = engine_.program().clauses()[index];
  const std::string parent = Parent(clause);
  std::set<Symbol> known;
  for (const auto& formula : formulas_) {
    for (const Symbol symbol : SymbolsOf(formula.formula)) known.insert(symbol);
  }
  const std::string fresh = NewSymbols(clause, known);
  const std::string source =
      parent.empty() ? fmt::format("introduced(theory,[{}])", "equality")
      : fresh.empty()
          ? fmt::format("inference(clausify,[status(thm)],[{}])", parent)
          : fmt::format("inference(clausify,[status(esa),new_symbols(skolem,[{}])],[{}])", fresh,
                        parent);
  name = fmt::format("clause_{}", index);
  lines.push_back(fmt::format("cnf({}, plain, {}, {}).", name, ToString(clause), source));
  return name;
}

void ProofPrinter::AddInstance(std::string_view literals, std::string_view source) {
  if (!known_instances_.insert(std::string(literals)).second) return;
  instances_.push_back(fmt::format("step_{}", instances_.size() + 1));
  lines.push_back(fmt::format("cnf({}, plain, {}, {}).", instances_.back(), literals, source));
}

void ProofPrinter::Instance(std::uint32_t index, const Contrapositive& rule, const Word* slots) {
  const std::string parent = ClauseLine(index);
  std::vector<std::string> literals;
  if (rule.has_head) {
    literals.push_back(ToString(
        logic::Literal{rule.head.positive, engine_.Instance(rule.head, slots, variables_)}));
  }
  for (const CompiledLiteral& literal : rule.body) {
    literals.push_back(
        ToString(logic::Literal{!literal.positive, engine_.Instance(literal, slots, variables_)}));
  }
  const std::string text =
      literals.empty() ? "$false" : fmt::format("{}", fmt::join(literals, " | "));
  AddInstance(text, fmt::format("inference(instantiate,[status(thm)],[{}])", parent));
  const Clause& clause = engine_.program().clauses()[index];
  if (clause.role == logic::Role::kNegatedConjecture) AddAnswer(clause, slots);
}

void ProofPrinter::AddAnswer(const Clause& clause, const Word* slots) {
  const auto conjecture = std::find_if(formulas_.begin(), formulas_.end(), [](const auto& formula) {
    return formula.role == logic::Role::kConjecture &&
           formula.formula.kind() == Formula::Kind::kExists;
  });
  if (conjecture == formulas_.end()) return;
  std::vector<std::string> tuple;
  for (const logic::Variable variable : conjecture->formula.variables()) {
    const auto& names = clause.variable_names;
    const auto place = std::find(names.begin(), names.end(), conjecture->variable_names[variable]);
    if (place == names.end()) return;
    tuple.push_back(ToString(engine_.Value(slots[place - names.begin()], variables_)));
  }
  if (std::find(answers.begin(), answers.end(), tuple) == answers.end()) {
    answers.push_back(std::move(tuple));
  }
}

void ProofPrinter::AddFact(const logic::Atom& fact) {
  const auto& clauses = engine_.program().clauses();
  for (std::uint32_t i = 0; i < clauses.size(); ++i) {
    const auto& literals = clauses[i].literals;
    if (literals.size() != 1 || !literals[0].positive || literals[0].atom != fact) continue;
    const std::string parent = ClauseLine(i);
    AddInstance(ToString(fact), fmt::format("inference(instantiate,[status(thm)],[{}])", parent));
    return;
  }
}

void ProofPrinter::AddStep(const Step& step) {
  const logic::Literal literal{step.node->literal->positive,
                               engine_.Instance(*step.node, variables_)};
  switch (step.kind) {
    case Step::Kind::kRule:
      Instance(step.rule->clause, *step.rule, step.slots);
      break;
    case Step::Kind::kFact:
      AddFact(literal.atom);
      break;
    case Step::Kind::kEquality:
      AddInstance(ToString(literal), "introduced(theory,[equality])");
      break;
    case Step::Kind::kArithmetic:
    case Step::Kind::kAttachment:
    case Step::Kind::kAssumption:
      AddInstance(ToString(literal), "introduced(theory,[arithmetic])");
      break;
    case Step::Kind::kReduction:
      break;
  }
}

void ProofPrinter::Print(const Proof& proof) {
  Instance(proof.start->clause, *proof.start, proof.slots);
  std::vector<const Step*> steps;
  for (const Step* step = proof.steps; step != nullptr; step = step->previous) {
    steps.push_back(step);
  }
  std::reverse(steps.begin(), steps.end());
  for (const Step* step : steps) AddStep(*step);
  lines.push_back(
      fmt::format("cnf(refutation, plain, $false, inference(resolution,[status(thm)],[{}])).",
                  fmt::join(instances_, ",")));
}

}  // namespace latchwork::pttp

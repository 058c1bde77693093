// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "latchwork/logic/tptp.h"
#include "reasoners/pttp/proofs/deep_normal_form.h"
#include "reasoners/pttp/proofs/tstp_printer.h"

namespace latchwork::pttp {
namespace {

using logic::Atom;
using logic::Formula;
using logic::Role;
using logic::Symbol;
using logic::Term;

void CollectWords(const Formula& formula, std::set<std::string_view>& words) {
  std::vector<const Formula*> formulas{&formula};
  std::vector<const Term*> terms;
  while (!formulas.empty()) {
    const Formula& current = *formulas.back();
    formulas.pop_back();
    for (const Formula& child : current.children()) formulas.push_back(&child);
    if (current.kind() != Formula::Kind::kAtom) continue;
    words.insert(current.atom().predicate().name());
    for (const Term& term : current.atom().arguments()) terms.push_back(&term);
    while (!terms.empty()) {
      const Term& term = *terms.back();
      terms.pop_back();
      if (term.is_variable() || term.is_number()) continue;
      words.insert(term.symbol().name());
      for (const Term& argument : term.arguments()) terms.push_back(&argument);
    }
  }
}

}  // namespace

BodyOf TstpPrinter::Bodies() const {
  return [this](const Atom& atom) -> const Formula* {
    const auto place = definition_of_.find(atom.predicate());
    if (place == definition_of_.end()) return nullptr;
    const Formula& formula = sources_.origins.definitions[place->second].formula;
    const bool is_closed = formula.kind() == Formula::Kind::kForall;
    return &(is_closed ? formula.children()[0] : formula).children()[1];
  };
}

void TstpPrinter::FindDeepForm(std::size_t index) {
  const auto& form = sources_.origins.normal_forms[index];
  if (form.formula == logic::ClauseOrigins::kNone) return;
  const logic::AnnotatedFormula& formula = sources_.formulas[form.formula];
  auto pairs =
      PairFormulas(formula.formula, formula.role != Role::kConjecture, form.normal, Bodies());
  if (!pairs || !DeepNormalForm::IsDeep(*pairs)) return;
  Symbols predicates;
  for (const FormulaPair& each : *pairs) {
    if (each.is_name) predicates.insert(each.normal->atom().predicate());
  }
  for (const std::size_t each : DefinitionsOf(predicates)) {
    kept_names_.emplace(each, &formula.variable_names);
  }
  deep_forms_.emplace(index, *std::move(pairs));
}

std::string TstpPrinter::DeepForm(std::size_t index) {
  const std::size_t formula = sources_.origins.normal_forms[index].formula;
  const Names& names = sources_.formulas[formula].variable_names;
  const DeepNormalForm::Lines lines{
      [&](const Formula& normal, const Names& parents) {
        return Line(
            "fof", "normal_form", "plain", ToString(normal, names),
            fmt::format("inference(normalize,[status(thm)],[{}])", fmt::join(parents, ",")));
      },
      [&](const Formula& part) { return NamePart(part, names); },
      [&](const Atom& atom) { return Definition(definition_of_.at(atom.predicate())); }};
  return DeepNormalForm(deep_forms_.at(index), Bodies(), lines).Write(FormulaParent(formula));
}

std::pair<Atom, std::string> TstpPrinter::NamePart(const Formula& part, const Names& names) {
  std::set<std::string_view> words;
  for (const auto& each : sources_.formulas) CollectWords(each.formula, words);
  Symbol symbol = part_symbols_.Fresh("part_");
  while (words.contains(symbol.name())) symbol = part_symbols_.Fresh("part_");
  std::vector<Term> arguments;
  for (const logic::Variable each : FreeVariables(part)) arguments.push_back(Term::Var(each));
  const Atom name(symbol, arguments);
  std::string line =
      Line("fof", "definition", "definition",
           ToString(Closed(Formula::Equivalent(Formula::Of(name), part)), names),
           fmt::format("introduced(definition,[new_symbols(definition,[{}])],[])", symbol.name()));
  return {name, std::move(line)};
}

}  // namespace latchwork::pttp

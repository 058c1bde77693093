// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/tstp_printer.h"

#include <fmt/format.h>

#include <algorithm>

#include "latchwork/logic/tptp.h"

namespace latchwork::pttp {
namespace {

using logic::AnnotatedFormula;
using logic::Clause;
using logic::ClauseOrigins;
using logic::Formula;
using logic::Role;
using logic::Symbol;

constexpr std::size_t kAllConjectures = ClauseOrigins::kNone;
/// That one step to a normal form brings in, where it can be done in steps; and how many steps.
constexpr std::size_t kMostNames = 8;
constexpr std::size_t kMostStages = 16;

std::set<Symbol> PredicatesOf(const Formula& formula) {
  std::set<Symbol> predicates;
  std::vector<const Formula*> visits{&formula};
  while (!visits.empty()) {
    const Formula& current = *visits.back();
    visits.pop_back();
    if (current.kind() == Formula::Kind::kAtom) predicates.insert(current.atom().predicate());
    for (const Formula& child : current.children()) visits.push_back(&child);
  }
  return predicates;
}

/// As it is written in a derivation: clauses without their quantifier.
std::string Text(const AnnotatedFormula& annotated) {
  const Formula& formula = annotated.formula;
  const bool is_closed = annotated.is_clause && formula.kind() == Formula::Kind::kForall;
  return ToString(is_closed ? formula.children()[0] : formula, annotated.variable_names);
}

/// On one line, blanks around the ends of lines being one; nothing for a text with comments.
std::string OnOneLine(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n\v\f";
  if (text.find('%') != std::string_view::npos || text.find("/*") != std::string_view::npos) {
    return {};
  }
  std::string line;
  while (!text.empty()) {
    const std::size_t blanks = text.find_first_of(kBlanks);
    line += text.substr(0, blanks);
    if (blanks == std::string_view::npos) break;
    const std::size_t next = std::min(text.find_first_not_of(kBlanks, blanks), text.size());
    const std::string_view gap = text.substr(blanks, next - blanks);
    const bool breaks = gap.find_first_not_of(" \t") != std::string_view::npos;
    if (next < text.size()) line += breaks ? " " : gap;
    text.remove_prefix(next);
  }
  return line;
}

std::string Inference(std::string_view rule, std::string_view status,
                      std::span<const std::string> parents) {
  return fmt::format("inference({},[status({})],[{}])", rule, status, fmt::join(parents, ","));
}

}  // namespace

TstpPrinter::TstpPrinter(const ProofSources& sources) : sources_(sources) {
  for (const AnnotatedFormula& formula : sources.formulas) names_.insert(formula.name);
  const ClauseOrigins& origins = sources.origins;
  for (std::size_t i = 0; i < origins.definitions.size(); ++i) {
    definition_of_.emplace(origins.definitions[i].name, i);
  }
  for (std::size_t i = 0; i < origins.normal_forms.size(); ++i) {
    for (const Clause& clause : origins.normal_forms[i].clauses) {
      form_of_.emplace(ToString(clause), i);
    }
    FindDeepForm(i);
  }
}

std::string TstpPrinter::NewName(std::string_view stem) {
  std::size_t& number = next_number_[std::string(stem)];
  while (true) {
    std::string name = fmt::format("{}_{}", stem, ++number);
    if (names_.insert(name).second) return name;
  }
}

std::string TstpPrinter::Line(std::string_view language, std::string_view stem,
                              std::string_view role, std::string_view formula,
                              std::string_view source) {
  std::string name = NewName(stem);
  lines_.push_back(fmt::format("{}({}, {}, {}, {}).", language, name, role, formula, source));
  return name;
}

std::string TstpPrinter::TextOf(std::size_t index) const {
  std::string text = index < sources_.texts.size() ? OnOneLine(sources_.texts[index]) : "";
  return text.empty() ? Text(sources_.formulas[index]) : text;
}

std::string TstpPrinter::ClosedText(std::size_t index) const {
  const AnnotatedFormula& formula = sources_.formulas[index];
  return fmt::format("({})", formula.is_clause ? ToString(formula.formula, formula.variable_names)
                                               : TextOf(index));
}

std::string TstpPrinter::Leaf(std::size_t index) {
  std::string& name = leaves_[index];
  if (!name.empty()) return name;
  const AnnotatedFormula& formula = sources_.formulas[index];
  const bool is_first = leaf_names_.insert(formula.name).second;
  name = logic::QuoteName(is_first ? formula.name : NewName(formula.name));
  lines_.push_back(fmt::format("{}({}, {}, {}, file({}, {})).", formula.is_clause ? "cnf" : "fof",
                               name, logic::RoleName(formula.role), TextOf(index),
                               logic::QuoteWord(sources_.file), logic::QuoteName(formula.name)));
  return name;
}

std::string TstpPrinter::Conjectures() {
  std::vector<std::string> parents;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < sources_.formulas.size(); ++i) {
    if (sources_.formulas[i].role != Role::kConjecture) continue;
    parents.push_back(Leaf(i));
    texts.push_back(ClosedText(i));
  }
  if (parents.size() == 1) return parents.front();
  return Line("fof", "conjectures", "conjecture", fmt::format("{}", fmt::join(texts, " & ")),
              Inference("conjunction", "thm", parents));
}

std::string TstpPrinter::NegatedConjecture(std::size_t index) {
  std::string& name = negated_[index];
  if (!name.empty()) return name;
  const std::vector<std::string> parents{index == kAllConjectures ? Conjectures() : Leaf(index)};
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < sources_.formulas.size(); ++i) {
    const bool is_conjecture = sources_.formulas[i].role == Role::kConjecture;
    if (!is_conjecture || (index != kAllConjectures && i != index)) continue;
    texts.push_back(ClosedText(i));
  }
  const std::string text =
      texts.size() == 1 ? "~ " + texts.front() : fmt::format("~ ({})", fmt::join(texts, " & "));
  name = Line("fof", "negated_conjecture", "negated_conjecture", text,
              Inference("negate", "cth", parents));
  return name;
}

std::string TstpPrinter::FormulaParent(std::size_t index) {
  if (index == ClauseOrigins::kNone) return NegatedConjecture(kAllConjectures);
  return sources_.formulas[index].role == Role::kConjecture ? NegatedConjecture(index)
                                                            : Leaf(index);
}

std::string TstpPrinter::Definition(std::size_t index) {
  std::string& name = definitions_[index];
  if (!name.empty()) return name;
  const ClauseOrigins::Definition& definition = sources_.origins.definitions[index];
  name = Line("fof", "definition", "definition",
              ToString(definition.formula, kept_names_.contains(index) ? *kept_names_.at(index)
                                                                       : definition.variable_names),
              fmt::format("introduced(definition,[new_symbols(definition,[{}])],[])",
                          logic::QuoteWord(definition.name.name())));
  return name;
}

std::set<std::size_t> TstpPrinter::DefinitionsOf(const Symbols& predicates) const {
  std::set<std::size_t> found;
  std::vector<Symbol> visits(predicates.begin(), predicates.end());
  while (!visits.empty()) {
    const auto place = definition_of_.find(visits.back());
    visits.pop_back();
    if (place == definition_of_.end() || !found.insert(place->second).second) continue;
    const Symbols inner = PredicatesOf(sources_.origins.definitions[place->second].formula);
    visits.insert(visits.end(), inner.begin(), inner.end());
  }
  return found;
}

std::string TstpPrinter::NormalForm(std::size_t index) {
  std::string& name = normal_forms_[index];
  if (!name.empty()) return name;
  if (deep_forms_.contains(index)) name = DeepForm(index);
  if (!name.empty()) return name;
  const ClauseOrigins::NormalForm& form = sources_.origins.normal_forms[index];
  const auto kept = kept_names_.find(form.definition);
  const Names& variables = kept == kept_names_.end() ? form.normal_names : *kept->second;
  std::vector<std::string> parents{form.definition == ClauseOrigins::kNone
                                       ? FormulaParent(form.formula)
                                       : Definition(form.definition)};
  if (form.definition == ClauseOrigins::kNone) AddNames(form, parents);
  name = Line("fof", "normal_form", "plain", ToString(form.normal, variables),
              Inference("normalize", "thm", parents));
  return name;
}

void TstpPrinter::AddNames(const ClauseOrigins::NormalForm& form,
                           std::vector<std::string>& parents) {
  std::vector<std::string> all;
  AddDefinitionsOf(PredicatesOf(form.normal), all);
  const auto stages = all.size() > kMostNames ? StagesOf(form) : std::nullopt;
  if (!stages) {
    parents.insert(parents.end(), all.begin(), all.end());
    return;
  }
  const std::size_t most = std::max(kMostNames, all.size() / kMostStages);
  Symbols predicates;
  for (std::size_t i = stages->parts().size(); i-- > 0;) {
    Symbols next = predicates;
    next.merge(PredicatesOf(stages->parts()[i]));
    if (!predicates.empty() && DefinitionsOf(next).size() > most) {
      AddDefinitionsOf(predicates, parents);
      parents = {Line("fof", "normal_form", "plain",
                      ToString(stages->Stage(i + 1), form.normal_names),
                      Inference("normalize", "thm", parents))};
      next = PredicatesOf(stages->parts()[i]);
    }
    predicates = std::move(next);
  }
  AddDefinitionsOf(predicates, parents);
}

void TstpPrinter::AddDefinitionsOf(const Symbols& predicates, std::vector<std::string>& parents) {
  for (const std::size_t each : DefinitionsOf(predicates)) parents.push_back(Definition(each));
}

std::optional<NamingStages> TstpPrinter::StagesOf(const ClauseOrigins::NormalForm& form) const {
  if (form.formula == ClauseOrigins::kNone) return std::nullopt;
  const AnnotatedFormula& formula = sources_.formulas[form.formula];
  return NamingStages::Of(formula.formula, formula.role != Role::kConjecture, form.normal);
}

std::vector<std::string> TstpPrinter::ParentsOf(const Clause& clause, std::size_t index) {
  const ClauseOrigins::NormalForm& form = sources_.origins.normal_forms[index];
  Symbols names;
  for (const logic::Literal& literal : clause.literals) names.insert(literal.atom.predicate());
  const std::set<std::size_t> definitions = DefinitionsOf(names);
  const bool is_direct = form.skolem_functions.empty() && form.definition == ClauseOrigins::kNone &&
                         definitions.size() < DefinitionsOf(PredicatesOf(form.normal)).size();
  if (!is_direct) return {Skolemized(index)};
  std::vector<std::string> parents{FormulaParent(form.formula)};
  for (const std::size_t each : definitions) parents.push_back(Definition(each));
  return parents;
}

std::string TstpPrinter::Skolemized(std::size_t index) {
  const ClauseOrigins::NormalForm& form = sources_.origins.normal_forms[index];
  if (form.skolem_functions.empty()) return NormalForm(index);
  std::string& name = skolemized_[index];
  if (!name.empty()) return name;
  std::vector<std::string> functions;
  for (const Symbol function : form.skolem_functions) {
    functions.push_back(logic::QuoteWord(function.name()));
  }
  const std::string parent = NormalForm(index);
  name = Line("fof", "skolemized", "plain", ToString(form.skolemized, form.skolemized_names),
              fmt::format("inference(skolemize,[status(esa),new_symbols(skolem,[{}])],[{}])",
                          fmt::join(functions, ","), parent));
  return name;
}

std::size_t TstpPrinter::FormulaOf(const Clause& clause) const {
  const auto& formulas = sources_.formulas;
  const auto found = std::find_if(formulas.begin(), formulas.end(), [&](const auto& formula) {
    return formula.name == clause.name && formula.place.line == clause.place.line &&
           formula.place.column == clause.place.column && formula.place.file == clause.place.file;
  });
  return found == formulas.end() ? ClauseOrigins::kNone
                                 : static_cast<std::size_t>(found - formulas.begin());
}

std::string TstpPrinter::Input(const Clause& clause) {
  const std::string text = ToString(clause);
  std::string& name = inputs_[text];
  if (!name.empty()) return name;
  std::vector<std::string> parents;
  const std::size_t formula = FormulaOf(clause);
  if (const auto form = form_of_.find(text); form != form_of_.end()) {
    parents = ParentsOf(clause, form->second);
  } else if (formula == ClauseOrigins::kNone) {
    name = Tautology(text);
    return name;
  } else if (sources_.formulas[formula].is_clause &&
             sources_.formulas[formula].role != Role::kConjecture) {
    parents.push_back(Leaf(formula));
    if (text == Text(sources_.formulas[formula])) {
      name = parents.front();
      return name;
    }
  } else {
    const auto& forms = sources_.origins.normal_forms;
    for (std::size_t i = 0; i < forms.size(); ++i) {
      if (!forms[i].clauses.empty() && FormulaOf(forms[i].clauses.front()) == formula) {
        parents.push_back(Skolemized(i));
      }
    }
  }
  name = Derived("clause", text, "clausify", parents);
  return name;
}

std::string TstpPrinter::Derived(std::string_view stem, std::string_view clause,
                                 std::string_view rule, std::span<const std::string> parents) {
  return Line("cnf", stem, "plain", clause, Inference(rule, "thm", parents));
}

std::string TstpPrinter::Tautology(std::string_view clause) {
  return Line("cnf", "equality", "plain", clause, "introduced(tautology,[theory(equality)],[])");
}

std::string TstpPrinter::TheoryFact(std::string_view clause, std::string_view theory) {
  return Line("cnf", "theory", "plain", clause,
              fmt::format("introduced(theory,[theory({})],[])", theory));
}

}  // namespace latchwork::pttp

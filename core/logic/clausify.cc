// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/clausify.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/logic/clause_maker.h"
#include "core/logic/miniscope.h"
#include "core/logic/name_subformulas.h"
#include "core/logic/normal_tree.h"

namespace latchwork::logic {

namespace {

class Clausifier {
 public:
  Clausifier(SymbolTable& symbols, const ClausifyOptions& options)
      : symbols_(symbols), options_(options), work_(options.max_symbols) {}

  /// False when the work is spent.
  bool Add(const AnnotatedFormula& formula) {
    Clause pattern = PatternOf(formula);
    Translate(formula, formula.formula, pattern, nullptr);
    return !work_.is_spent();
  }

  /// All of them must be proved: one of their negations is false.
  bool AddConjectures(const std::vector<const AnnotatedFormula*>& conjectures) {
    Clause choice = PatternOf(*conjectures.front());
    const auto first = static_cast<std::ptrdiff_t>(clauses_.size());
    for (const AnnotatedFormula* each : conjectures) {
      if (conjectures.size() == 1) {
        Translate(*each, each->formula, choice, nullptr);
        continue;
      }
      const Atom refuted(symbols_.Fresh("def_"));
      choice.literals.push_back({true, refuted});
      Translate(*each, each->formula, PatternOf(*each), &refuted);
    }
    if (!choice.literals.empty()) {
      clauses_.insert(clauses_.begin() + first, std::move(choice));
    }
    return !work_.is_spent();
  }

  std::vector<Clause> Take() { return std::move(clauses_); }

 private:
  static Clause PatternOf(const AnnotatedFormula& formula) {
    Clause clause;
    clause.name = formula.name;
    clause.place = formula.place;
    clause.role = formula.role == Role::kConjecture ? Role::kNegatedConjecture : formula.role;
    return clause;
  }

  /// With a condition, the clauses hold only where it is true.
  void Translate(const AnnotatedFormula& annotated, const Formula& formula, const Clause& pattern,
                 const Atom* condition) {
    NormalTree tree = NormalTree::Of(formula, annotated.role != Role::kConjecture);
    auto free = Miniscope(tree);
    FreeVariableTable* table = free ? &*free : nullptr;
    std::vector<ClauseMaker::Signed> disjunction;
    if (condition != nullptr) {
      disjunction.push_back({tree.AddLiteral(*condition, false), true});
      if (table != nullptr) table->emplace_back();
    }
    disjunction.push_back({tree.root, true});
    const auto names = NameSubformulas(tree, table, options_.distribution_limit, symbols_);
    ClauseMaker maker(tree, table, annotated.variable_names, symbols_, work_);
    maker.Make(disjunction, {}, pattern, clauses_);
    for (const SubformulaName& each : names) Define(tree, each, pattern, maker);
  }

  void Define(const NormalTree& tree, const SubformulaName& name, const Clause& pattern,
              ClauseMaker& maker) {
    std::vector<Variable> variables;
    CollectVariables(*tree.nodes[name.name].atom, variables);
    maker.Make({{name.name, false}, {name.body, true}}, variables, pattern, clauses_);
    if (!name.in_both_polarities) return;
    maker.Make({{name.name, true}, {name.body, false}}, variables, pattern, clauses_);
  }

  SymbolTable& symbols_;
  const ClausifyOptions& options_;
  WorkMeter work_;
  std::vector<Clause> clauses_;
};

}  // namespace

std::vector<Clause> Clausify(const std::vector<AnnotatedFormula>& formulas, SymbolTable& symbols,
                             const ClausifyOptions& options, Diagnostics* diagnostics) {
  Clausifier clausifier(symbols, options);
  std::vector<const AnnotatedFormula*> conjectures;
  for (const AnnotatedFormula& each : formulas) {
    if (each.role == Role::kConjecture) conjectures.push_back(&each);
  }
  for (const AnnotatedFormula& each : formulas) {
    if (each.role == Role::kConjecture && &each != conjectures.front()) continue;
    if (each.role == Role::kConjecture ? clausifier.AddConjectures(conjectures)
                                       : clausifier.Add(each)) {
      continue;
    }
    const std::string message = "clauses take more than " + std::to_string(options.max_symbols) +
                                " symbols from this formula on";
    if (diagnostics == nullptr) throw std::length_error(message);
    diagnostics->push_back({each.place, message, "split the theory, or raise the limit", {}});
    return {};
  }
  return clausifier.Take();
}

}  // namespace latchwork::logic

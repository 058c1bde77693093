// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/clausify.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/logic/clause_maker.h"
#include "core/logic/clause_recorder.h"
#include "core/logic/miniscope.h"
#include "core/logic/name_subformulas.h"
#include "core/logic/normal_tree.h"
#include "core/logic/print.h"

namespace latchwork::logic {

namespace {

/// `~ conjecture`, under the name of its denial.
ClauseOrigins::Definition Denial(const Atom& name, const AnnotatedFormula& conjecture) {
  return {name.predicate(),
          Formula::Equivalent(Formula::Of(name), Formula::Not(conjecture.formula)),
          DistinctNames(conjecture.variable_names)};
}

/// Where the clauses of a normal form come from.
struct Source {
  std::size_t formula = ClauseOrigins::kNone;
  std::size_t definition = ClauseOrigins::kNone;
};

/// A conjunct of a formula, with the universal quantifiers around it that bind something in it.
struct Conjunct {
  ClauseMaker::Item item;
  std::vector<Variable> variables;
};

/// What a formula says below its universal quantifiers, piece by piece: pieces are easier to follow
/// and to check.
std::vector<Conjunct> ConjunctsOf(const NormalTree& tree) {
  using Kind = NormalTree::Kind;
  using Half = ClauseMaker::Half;
  std::vector<Variable> prefix;
  NormalTree::Id body = tree.root;
  for (; tree.nodes[body].kind == Kind::kForall; body = tree.nodes[body].children[0]) {
    const std::vector<Variable>& bound = tree.nodes[body].variables;
    prefix.insert(prefix.end(), bound.begin(), bound.end());
  }
  std::vector<ClauseMaker::Item> items;
  if (tree.nodes[body].kind == Kind::kEquivalent) {
    items = {{body, true, Half::kFirst}, {body, true, Half::kSecond}};
  } else if (tree.nodes[body].kind == Kind::kAnd) {
    for (const NormalTree::Id child : tree.nodes[body].children) items.push_back({child, true});
  } else {
    return {{{tree.root, true}, {}}};
  }
  std::vector<Conjunct> conjuncts;
  for (const ClauseMaker::Item& item : items) {
    Conjunct& conjunct = conjuncts.emplace_back(Conjunct{item, {}});
    if (prefix.empty()) continue;
    const std::vector<Variable> free = tree.FreeVariables(item.id);
    std::copy_if(prefix.begin(), prefix.end(), std::back_inserter(conjunct.variables),
                 [&](Variable each) { return std::binary_search(free.begin(), free.end(), each); });
  }
  return conjuncts;
}

class Clausifier {
 public:
  Clausifier(SymbolTable& symbols, const ClausifyOptions& options,
             const std::vector<AnnotatedFormula>& formulas, ClauseOrigins* origins)
      : symbols_(symbols),
        options_(options),
        formulas_(formulas),
        origins_(origins),
        work_(options.max_symbols) {}

  /// False when the work is spent.
  bool Add(const AnnotatedFormula& formula) {
    Clause pattern = PatternOf(formula);
    Translate(formula, pattern, nullptr, SourceOf(formula));
    return !work_.is_spent();
  }

  /// All of them must be proved: one of their negations is false.
  bool AddConjectures(const std::vector<const AnnotatedFormula*>& conjectures) {
    if (conjectures.size() == 1) return Add(*conjectures.front());
    Clause choice = PatternOf(*conjectures.front());
    const auto first = static_cast<std::ptrdiff_t>(clauses_.size());
    for (const AnnotatedFormula* each : conjectures) {
      const Atom denied(symbols_.Fresh("def_"));
      choice.literals.push_back({true, denied});
      Source source;
      if (origins_ != nullptr) source.definition = Define(Denial(denied, *each));
      Translate(*each, PatternOf(*each), &denied, source);
    }
    if (origins_ != nullptr) RecordChoice(choice);
    clauses_.insert(clauses_.begin() + first, std::move(choice));
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

  Source SourceOf(const AnnotatedFormula& formula) const {
    return {static_cast<std::size_t>(&formula - formulas_.data()), ClauseOrigins::kNone};
  }

  /// With a condition, the clauses hold only where it is true.
  void Translate(const AnnotatedFormula& annotated, const Clause& pattern, const Atom* condition,
                 const Source& source) {
    NormalTree tree = NormalTree::Of(annotated.formula, annotated.role != Role::kConjecture);
    const bool is_clause = annotated.is_clause && annotated.role != Role::kConjecture;
    // A clause has no quantifiers to be moved, and may have a hundred thousand variables.
    auto free = is_clause ? std::nullopt : Miniscope(tree);
    FreeVariableTable* table = free ? &*free : nullptr;
    std::optional<ClauseMaker::Item> denied;
    if (condition != nullptr) {
      denied = {tree.AddLiteral(*condition, false), true};
      if (table != nullptr) table->emplace_back();
    }
    const auto names = NameSubformulas(tree, table, options_.distribution_limit, symbols_);
    const bool records = origins_ != nullptr && !is_clause;
    ClauseRecorder recorder(annotated.variable_names);
    ClauseMaker maker(tree, table, annotated.variable_names, symbols_, work_,
                      records ? &recorder : nullptr);
    const auto make = [&](const std::vector<ClauseMaker::Item>& parts,
                          const std::vector<Variable>& variables, const Source& from) {
      const std::size_t first = clauses_.size();
      maker.Make(parts, variables, pattern, clauses_);
      if (records && !work_.is_spent()) Record(recorder.Take(maker.sources()), from, first);
    };
    if (denied) {
      make({*denied, {tree.root, true}}, {}, source);
    } else {
      for (const Conjunct& each : ConjunctsOf(tree)) make({each.item}, each.variables, source);
    }
    for (const SubformulaName& each : names) {
      std::vector<Variable> variables;
      CollectVariables(*tree.nodes[each.name].atom, variables);
      Source definition;
      if (records) definition.definition = Define(NameOf(tree, each, annotated));
      make({{each.name, false}, {each.body, true}}, variables, definition);
      if (each.in_both_polarities) {
        make({{each.name, true}, {each.body, false}}, variables, definition);
      }
    }
  }

  static ClauseOrigins::Definition NameOf(const NormalTree& tree, const SubformulaName& name,
                                          const AnnotatedFormula& annotated) {
    const Atom& atom = *tree.nodes[name.name].atom;
    Formula formula = Formula::Equivalent(Formula::Of(atom), ToFormula(tree, name.body));
    std::vector<Variable> variables;
    CollectVariables(atom, variables);
    if (!variables.empty()) formula = Formula::Forall(std::move(variables), std::move(formula));
    return {atom.predicate(), std::move(formula), DistinctNames(annotated.variable_names)};
  }

  std::size_t Define(ClauseOrigins::Definition definition) {
    origins_->definitions.push_back(std::move(definition));
    return origins_->definitions.size() - 1;
  }

  void Record(ClauseOrigins::NormalForm form, const Source& source, std::size_t first_clause) {
    form.formula = source.formula;
    form.definition = source.definition;
    form.clauses.assign(clauses_.begin() + static_cast<std::ptrdiff_t>(first_clause),
                        clauses_.end());
    origins_->normal_forms.push_back(std::move(form));
  }

  void RecordChoice(const Clause& choice) {
    ClauseOrigins::NormalForm form;
    std::vector<Formula> denied;
    for (const Literal& literal : choice.literals) denied.push_back(Formula::Of(literal.atom));
    form.normal = Formula::Or(std::move(denied));
    form.skolemized = form.normal;
    form.clauses.push_back(choice);
    origins_->normal_forms.push_back(std::move(form));
  }

  SymbolTable& symbols_;
  const ClausifyOptions& options_;
  const std::vector<AnnotatedFormula>& formulas_;
  ClauseOrigins* origins_;
  WorkMeter work_;
  std::vector<Clause> clauses_;
};

}  // namespace

std::vector<Clause> Clausify(const std::vector<AnnotatedFormula>& formulas, SymbolTable& symbols,
                             const ClausifyOptions& options, Diagnostics* diagnostics,
                             ClauseOrigins* origins) {
  Clausifier clausifier(symbols, options, formulas, origins);
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

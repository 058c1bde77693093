// SPDX-License-Identifier: BSD-3-Clause
#include "apps/check_proof/proof_checker.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "apps/check_proof/entailment.h"
#include "apps/check_proof/ground_arithmetic.h"
#include "apps/check_proof/normal_form.h"
#include "apps/check_proof/skolem_check.h"
#include "apps/check_proof/source_term.h"

namespace latchwork::check_proof {
namespace {

using logic::AnnotatedFormula;
using logic::Formula;
using logic::Role;
using logic::Symbol;
using logic::Term;

struct Finding {
  StepState state = StepState::kVerified;
  std::string reason;
};
Finding Rejected(std::string reason) { return {StepState::kRejected, std::move(reason)}; }
Finding Unchecked(std::string reason) { return {StepState::kUnchecked, std::move(reason)}; }

struct Step {
  const AnnotatedFormula* formula = nullptr;
  bool assumes_conjecture = false;  ///< It is a conjecture, or follows from one.
  bool is_instance = false;         ///< Of a clause, or true by itself, or resolved from such.
  bool is_lemma = false;            ///< Says of a formula what its normal form is; true by itself.
  std::optional<std::pair<logic::PredicateName, Definition>> definition;
  /// Names that stand for what they name: of lemmas, of halves of definitions, and of what follows
  /// from these.
  Definitions unfolded;
};

/// What an inference(...) says.
struct Inference {
  std::string rule;
  std::set<std::string> statuses;
  std::set<std::string> new_symbols;
  std::vector<const Step*> parents;
  std::string fault;
};

void CollectSymbols(const Formula& formula, std::set<Symbol>& symbols) {
  std::vector<const Formula*> formulas{&formula};
  while (!formulas.empty()) {
    const Formula& current = *formulas.back();
    formulas.pop_back();
    for (const Formula& child : current.children()) formulas.push_back(&child);
    if (current.kind() != Formula::Kind::kAtom) continue;
    symbols.insert(current.atom().predicate());
    std::vector<const Term*> terms;
    for (const Term& term : current.atom().arguments()) terms.push_back(&term);
    while (!terms.empty()) {
      const Term& term = *terms.back();
      terms.pop_back();
      if (term.is_variable() || term.is_number()) continue;
      symbols.insert(term.symbol());
      for (const Term& argument : term.arguments()) terms.push_back(&argument);
    }
  }
}

/// Whether two formulas are the same up to the names of variables; nothing when they are too large.
std::optional<bool> IsSame(const AnnotatedFormula& a, const AnnotatedFormula& b) {
  if (ToString(a.formula, a.variable_names) == ToString(b.formula, b.variable_names)) return true;
  const Definitions none;
  const auto left = Normalizer(none).Normalize(a.formula, true);
  const auto right = Normalizer(none).Normalize(b.formula, true);
  if (!left || !right) return std::nullopt;
  return IsVariant(*left, *right);
}

std::optional<Tree> Canonical(const Formula& formula, const Definitions& definitions) {
  auto tree = Normalizer(definitions).Normalize(formula, true);
  if (tree) MoveQuantifiersInwards(*tree);
  return tree;
}

class Checker {
 public:
  Checker(const logic::TptpFile& problem, logic::SymbolTable& symbols)
      : symbols_(symbols), mark_(symbols.Fresh("checked_")) {
    for (const AnnotatedFormula& formula : problem.formulas) {
      named_.emplace(formula.name, &formula);
      CollectSymbols(formula.formula, known_);
      if (formula.role == Role::kConjecture) conjectures_.push_back(&formula);
    }
  }

  Finding Check(const AnnotatedFormula& formula, const std::string& source_text) {
    Step step;
    step.formula = &formula;
    Finding finding = steps_.contains(formula.name) ? Rejected("another step has this name")
                                                    : CheckSource(step, ReadSource(source_text));
    CollectSymbols(formula.formula, known_);
    if (finding.state == StepState::kVerified && step.assumes_conjecture &&
        formula.formula.kind() == Formula::Kind::kFalse) {
      finding = Rejected("it takes a conjecture for granted");
    }
    steps_.emplace(formula.name, std::move(step));
    return finding;
  }

 private:
  Finding CheckSource(Step& step, const std::optional<SourceTerm>& source) {
    if (!source) return Rejected("it does not say where it comes from");
    if (source->name == "file") return CheckLeaf(step, *source);
    if (source->name == "introduced") return CheckIntroduced(step, *source);
    Inference inference;
    if (source->name == "inference") {
      ReadInference(*source, inference);
    } else {
      inference.rule = "copy";
      inference.statuses.insert("thm");
      AddParent(source->name, inference);
    }
    if (!inference.fault.empty()) return Rejected(inference.fault);
    return CheckInference(step, inference);
  }

  Finding CheckLeaf(Step& step, const SourceTerm& source) {
    const std::string& name =
        source.arguments.size() > 1 ? source.arguments[1].name : step.formula->name;
    const auto [first, last] = named_.equal_range(name);
    if (first == last) return Rejected("the problem has no formula '" + name + "'");
    Finding finding = Rejected("it differs from '" + name + "' of the problem");
    for (auto each = first; each != last; ++each) {
      const AnnotatedFormula& original = *each->second;
      const auto same = IsSame(original, *step.formula);
      if (!same) finding = Unchecked("it is too large or too deep");
      if (!same || !*same) continue;
      step.assumes_conjecture = original.role == Role::kConjecture;
      const bool said = step.formula->role == Role::kConjecture;
      return said == step.assumes_conjecture ? Finding() : Rejected("its role was changed");
    }
    return finding;
  }

  Finding CheckIntroduced(Step& step, const SourceTerm& source) {
    const std::string kind = source.arguments.empty() ? "" : source.arguments[0].name;
    if (kind == "definition") return CheckDefinition(step);
    step.is_instance = true;
    if (kind == "theory") return CheckTheory(step, source);
    if (kind != "tautology") return Unchecked("'" + kind + "' is not known here");
    return Judge(Entails({}, step.formula->formula, symbols_), "it is no tautology");
  }

  Finding CheckTheory(const Step& step, const SourceTerm& source) {
    const SourceTerm* const theories = source.List(1);
    const bool is_arithmetic = theories != nullptr && theories->arguments.size() == 1 &&
                               theories->arguments[0].name == "theory" &&
                               theories->arguments[0].arguments.size() == 1 &&
                               theories->arguments[0].arguments[0].name == "arithmetic";
    if (!is_arithmetic) return Unchecked("facts of this theory are not checked");
    return Judge(IsTrueByArithmetic(step.formula->formula), "it is not true by arithmetic");
  }

  Finding CheckDefinition(Step& step) {
    const Formula* inner = &step.formula->formula;
    std::set<logic::Variable> bound;
    if (inner->kind() == Formula::Kind::kForall) {
      bound.insert(inner->variables().begin(), inner->variables().end());
      inner = &inner->children()[0];
    }
    if (inner->kind() != Formula::Kind::kEquivalent ||
        inner->children()[0].kind() != Formula::Kind::kAtom) {
      return Rejected("a definition reads ! [X] : (name(X) <=> formula)");
    }
    const logic::Atom& name = inner->children()[0].atom();
    Definition definition{{}, inner->children()[1]};
    for (const Term& argument : name.arguments()) {
      if (!argument.is_variable() || bound.erase(argument.variable()) == 0) {
        return Rejected("the arguments of what is defined are not distinct variables");
      }
      definition.parameters.push_back(argument.variable());
    }
    if (!bound.empty()) return Rejected("a variable of the definition is no argument");
    std::set<Symbol> used = known_;
    CollectSymbols(definition.body, used);
    if (name.predicate().name() == "=" || used.contains(name.predicate())) {
      return Rejected("'" + std::string(name.predicate().name()) + "' is not new");
    }
    step.definition.emplace(NameOf(name), std::move(definition));
    return {};
  }

  void AddParent(const std::string& name, Inference& inference) {
    const auto parent = steps_.find(name);
    if (parent != steps_.end()) {
      inference.parents.push_back(&parent->second);
    } else if (inference.fault.empty()) {
      inference.fault = "its parent '" + name + "' does not stand before it";
    }
  }

  void ReadInference(const SourceTerm& source, Inference& inference) {
    if (source.arguments.size() < 3 || source.List(1) == nullptr || source.List(2) == nullptr) {
      inference.fault = "an inference reads inference(rule, [status(thm)], [parents])";
      return;
    }
    const bool is_outer = inference.rule.empty();
    inference.rule = is_outer ? source.arguments[0].name : "nested";
    for (const SourceTerm& info : source.List(1)->arguments) {
      if (info.name == "status" && !info.arguments.empty()) {
        inference.statuses.insert(info.arguments[0].name);
      }
      if (info.name != "new_symbols" || info.List(1) == nullptr) continue;
      for (const SourceTerm& symbol : info.List(1)->arguments) {
        inference.new_symbols.insert(symbol.name);
      }
    }
    for (const SourceTerm& parent : source.List(2)->arguments) {
      if (parent.name == "inference") {
        ReadInference(parent, inference);
      } else if (parent.name != "theory") {
        AddParent(parent.name, inference);
      }
    }
  }

  Finding CheckInference(Step& step, const Inference& inference) {
    if (inference.statuses == std::set<std::string>{"cth"}) return CheckNegation(step, inference);
    step.is_instance = inference.rule == "instantiate" ||
                       (inference.rule == "resolution" && FollowsFromInstances(inference));
    step.assumes_conjecture =
        std::any_of(inference.parents.begin(), inference.parents.end(),
                    [](const Step* each) { return each->assumes_conjecture; });
    if (inference.statuses == std::set<std::string>{"esa"}) {
      return CheckSkolemized(*step.formula, inference);
    }
    if (inference.statuses != std::set<std::string>{"thm"}) {
      return Unchecked("its status is neither thm, cth nor esa");
    }
    if (inference.rule == "normalize") {
      for (const Step* parent : inference.parents) {
        step.unfolded.insert(parent->unfolded.begin(), parent->unfolded.end());
      }
      const Step* const first = inference.parents.empty() ? nullptr : inference.parents.front();
      if (inference.parents.size() == 1 && first->definition) {
        step.unfolded.insert(*first->definition);
      }
      step.is_lemma = CheckLemma(step, inference);
    }
    return step.is_lemma ? Finding() : CheckConsequence(step, inference);
  }

  Finding CheckNegation(const Step& step, const Inference& inference) {
    if (inference.parents.size() != 1) return Rejected("a negation has one parent");
    const AnnotatedFormula& parent = *inference.parents[0]->formula;
    if (!inference.parents[0]->assumes_conjecture) return Rejected("its parent is no conjecture");
    if (conjectures_.size() > 1 && !IsConjunctionOfAll(parent)) {
      return Rejected("it must negate all conjectures together");
    }
    AnnotatedFormula negated = parent;
    negated.formula = Formula::Not(parent.formula);
    const auto same = IsSame(negated, *step.formula);
    if (!same) return Unchecked("it is too large or too deep");
    return *same ? Finding() : Rejected("it is not the negation of its parent");
  }

  bool IsConjunctionOfAll(const AnnotatedFormula& formula) const {
    if (formula.formula.kind() != Formula::Kind::kAnd) return false;
    const auto parts = formula.formula.children();
    return std::all_of(conjectures_.begin(), conjectures_.end(), [&](const auto* conjecture) {
      return std::any_of(parts.begin(), parts.end(), [&](const Formula& part) {
        AnnotatedFormula one = formula;
        one.formula = part;
        return IsSame(*conjecture, one).value_or(false);
      });
    });
  }

  Finding CheckSkolemized(const AnnotatedFormula& formula, const Inference& inference) {
    if (inference.parents.size() != 1) return Unchecked("an esa step with several parents");
    std::set<Symbol> symbols;
    CollectSymbols(formula.formula, symbols);
    std::set<Symbol> functions;
    for (const Symbol symbol : symbols) {
      if (!inference.new_symbols.contains(std::string(symbol.name()))) continue;
      if (known_.contains(symbol)) {
        return Rejected("'" + std::string(symbol.name()) + "' is not new");
      }
      functions.insert(symbol);
    }
    const Definitions none;
    const auto before = Normalizer(none).Normalize(inference.parents[0]->formula->formula, true);
    const auto after = Normalizer(none).Normalize(formula.formula, true);
    if (!before || !after) return Unchecked("it is too large or too deep");
    const std::string fault = CheckSkolemization(*before, *after, functions);
    return fault.empty() ? Finding() : Rejected(fault);
  }

  Finding CheckConsequence(const Step& step, const Inference& inference) {
    const AnnotatedFormula& formula = *step.formula;
    std::vector<const AnnotatedFormula*> premises;
    for (const Step* parent : inference.parents) premises.push_back(parent->formula);
    if (inference.rule == "normalize") {
      const Verdict verdict = CheckNormalForm(step, inference);
      return Judge(verdict, "it is no normal form of its parent");
    }
    if (inference.rule == "resolution" || formula.formula.kind() == Formula::Kind::kFalse) {
      const Verdict verdict = EntailsAsClauses(premises, formula);
      if (verdict == Verdict::kYes) return {};
      if (verdict == Verdict::kNo && FollowsFromInstances(inference)) {
        return Rejected("it does not follow from its parents by propositional logic");
      }
    }
    const Verdict verdict = ReadOff(formula.formula, premises);
    if (verdict == Verdict::kYes) return {};
    if (inference.rule == "instantiate") return Judge(verdict, "it is no instance of its parent");
    return Judge(Entails(premises, formula.formula, symbols_),
                 "it does not follow from its parents");
  }

  static bool FollowsFromInstances(const Inference& inference) {
    return std::all_of(inference.parents.begin(), inference.parents.end(),
                       [](const Step* each) { return each->is_instance; });
  }

  /// Whether a clause can be read off one of the premises.
  static Verdict ReadOff(const Formula& formula,
                         const std::vector<const AnnotatedFormula*>& premises) {
    std::vector<logic::Literal> clause;
    if (!ToLiterals(formula, clause)) return Verdict::kTooHard;
    const Definitions none;
    Verdict result = Verdict::kNo;
    for (const AnnotatedFormula* premise : premises) {
      const auto tree = Normalizer(none).Normalize(premise->formula, true);
      const bool shallow = std::all_of(clause.begin(), clause.end(),
                                       [](const auto& each) { return IsShallow(each.atom); });
      const Verdict verdict = tree && shallow ? MatchesClause(*tree, clause) : Verdict::kTooHard;
      if (verdict == Verdict::kYes) return verdict;
      if (verdict == Verdict::kTooHard) result = verdict;
    }
    return result;
  }

  /// Whether it reads `formula => its normal form`, where names may stand for what they name. No
  /// parents but other lemmas and definitions of the names: it is true by itself.
  bool CheckLemma(Step& step, const Inference& inference) {
    Definitions definitions = step.unfolded;
    for (const Step* parent : inference.parents) {
      if (parent->definition) definitions.insert(*parent->definition);
      if (!parent->definition && !parent->is_lemma) return false;
    }
    const Formula& formula = step.formula->formula;
    const bool is_closed = formula.kind() == Formula::Kind::kForall;
    const Formula& inner = is_closed ? formula.children()[0] : formula;
    if (inner.kind() != Formula::Kind::kImplies) return false;
    std::vector<logic::Variable> variables;
    if (is_closed) variables.assign(formula.variables().begin(), formula.variables().end());
    const auto said = Marked(inner.children()[0], variables, definitions);
    const auto normal = Marked(inner.children()[1], variables, definitions);
    if (!said || !normal || !IsVariant(*said, *normal).value_or(false)) return false;
    step.unfolded = std::move(definitions);
    return true;
  }

  /// `mark(variables) | formula` below their quantifier: two of these are variants only where the
  /// same variables stand at the same places.
  std::optional<Tree> Marked(const Formula& formula, const std::vector<logic::Variable>& variables,
                             const Definitions& definitions) {
    std::vector<Term> arguments;
    arguments.reserve(variables.size());
    for (const logic::Variable each : variables) arguments.push_back(Term::Var(each));
    const Formula mark = Formula::Of(logic::Atom(mark_, std::move(arguments)));
    const Formula marked = Formula::Or({mark, formula});
    return Canonical(variables.empty() ? marked : Formula::Forall(variables, marked), definitions);
  }

  Verdict CheckNormalForm(const Step& step, const Inference& inference) {
    const AnnotatedFormula& formula = *step.formula;
    Definitions definitions;
    std::vector<const Formula*> said;
    for (const Step* parent : inference.parents) {
      if (parent->is_lemma) continue;
      if (parent->definition && inference.parents.size() > 1) {
        definitions.insert(*parent->definition);
      } else if (parent->definition) {
        return IsHalfOf(parent->formula->formula, formula.formula);
      } else {
        said.push_back(&parent->formula->formula);
      }
    }
    if (said.empty()) return Verdict::kNo;
    const Verdict verdict = IsNormalFormOf(said, formula.formula, definitions);
    if (verdict == Verdict::kYes || step.unfolded.empty()) return verdict;
    definitions.insert(step.unfolded.begin(), step.unfolded.end());
    return IsNormalFormOf(said, formula.formula, definitions);
  }

  /// Whether `b`, or each conjunct of it, is said by one of the formulas in the same words.
  static Verdict IsNormalFormOf(const std::vector<const Formula*>& formulas, const Formula& b,
                                const Definitions& definitions) {
    const auto right = Canonical(b, definitions);
    if (!right) return Verdict::kTooHard;
    std::vector<Tree> said;
    for (const Formula* each : formulas) {
      const auto left = Canonical(*each, definitions);
      const auto same = left ? IsVariant(*left, *right) : std::nullopt;
      if (!same) return Verdict::kTooHard;
      if (*same) return Verdict::kYes;
      std::vector<Tree> conjuncts = ConjunctsOf(*left);
      std::move(conjuncts.begin(), conjuncts.end(), std::back_inserter(said));
    }
    const std::vector<Tree> conjuncts = ConjunctsOf(*right);
    if (AreSaid(conjuncts, said)) return Verdict::kYes;
    return AreSaid(AllPartsOf(conjuncts), AllPartsOf(said)) ? Verdict::kYes : Verdict::kNo;
  }

  static std::vector<Tree> AllPartsOf(const std::vector<Tree>& conjuncts) {
    std::vector<Tree> all;
    for (const Tree& conjunct : conjuncts) {
      std::vector<Tree> parts = PartsOf(conjunct);
      std::move(parts.begin(), parts.end(), std::back_inserter(all));
    }
    return all;
  }

  static bool AreSaid(const std::vector<Tree>& conjuncts, const std::vector<Tree>& said) {
    return std::all_of(conjuncts.begin(), conjuncts.end(), [&](const Tree& conjunct) {
      return std::any_of(said.begin(), said.end(), [&](const Tree& each) {
        return IsVariant(each, conjunct).value_or(false);
      });
    });
  }

  /// Whether a formula is one of the two implications of a definition.
  static Verdict IsHalfOf(const Formula& definition, const Formula& formula) {
    const bool is_closed = definition.kind() == Formula::Kind::kForall;
    const Formula& equivalence = is_closed ? definition.children()[0] : definition;
    const auto sides = equivalence.children();
    Verdict verdict = Verdict::kNo;
    for (const bool is_first : {true, false}) {
      Formula half = is_first ? Formula::Implies(sides[0], sides[1])
                              : Formula::Or({sides[0], Formula::Not(sides[1])});
      if (is_closed) {
        const auto variables = definition.variables();
        half = Formula::Forall({variables.begin(), variables.end()}, std::move(half));
      }
      const Verdict one = IsNormalFormOf({&half}, formula, {});
      if (one != Verdict::kNo) verdict = one;
      if (one == Verdict::kYes) break;
    }
    return verdict;
  }

  static Finding Judge(Verdict verdict, std::string fault) {
    switch (verdict) {
      case Verdict::kYes:
        return {};
      case Verdict::kNo:
        return Rejected(std::move(fault));
      default:
        return Unchecked("too hard to be checked here");
    }
  }

  logic::SymbolTable& symbols_;
  logic::Symbol mark_;
  std::multimap<std::string, const AnnotatedFormula*> named_;
  std::vector<const AnnotatedFormula*> conjectures_;
  std::set<Symbol> known_;
  std::map<std::string, Step> steps_;
};

}  // namespace

std::vector<CheckedStep> CheckProof(const logic::TptpFile& problem, const logic::TptpFile& proof,
                                    logic::SymbolTable& symbols) {
  Checker checker(problem, symbols);
  std::vector<CheckedStep> steps;
  for (std::size_t i = 0; i < proof.formulas.size(); ++i) {
    const AnnotatedFormula& formula = proof.formulas[i];
    Finding finding = checker.Check(formula, proof.sources[i]);
    steps.push_back({formula.name, formula.place, finding.state, std::move(finding.reason)});
  }
  if (proof.formulas.empty()) {
    steps.push_back({{}, {}, StepState::kRejected, "there is no proof"});
  } else if (proof.formulas.back().formula.kind() != Formula::Kind::kFalse) {
    steps.push_back(
        {{}, proof.formulas.back().place, StepState::kRejected, "the last step is not $false"});
  }
  return steps;
}

}  // namespace latchwork::check_proof

// SPDX-License-Identifier: BSD-3-Clause
#include "core/logic/tptp_types.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>

namespace latchwork::logic {

namespace {

/// Types are numbers: first those that have names, then those to be found out.
using Type = std::size_t;
constexpr Type kIndividual = 0;
constexpr Type kInteger = 1;
constexpr Type kReal = 2;

Type Named(TptpType type) {
  return type == TptpType::kInteger ? kInteger : type == TptpType::kReal ? kReal : kIndividual;
}

std::string Quote(std::string_view text) { return "'" + std::string(text) + "'"; }

/// Which types are the same, by union and find.
class TypeTable {
 public:
  Type Fresh(bool numeric = false) {
    parents_.push_back(parents_.size());
    numeric_.push_back(numeric);
    return parents_.size() - 1;
  }
  Type Find(Type type) {
    while (parents_[type] != type) type = parents_[type] = parents_[parents_[type]];
    return type;
  }
  bool IsNumeric(Type type) { return numeric_[Find(type)]; }
  /// False: they are two.
  bool Unify(Type a, Type b) {
    a = Find(a);
    b = Find(b);
    if (a == b) return true;
    if (a > b) std::swap(a, b);
    const bool clash = a <= kReal && (b <= kReal || (numeric_[b] && !numeric_[a]));
    if (clash) return false;
    numeric_[a] = numeric_[a] || numeric_[b];
    parents_[b] = a;
    return true;
  }
  std::string Name(Type type) {
    constexpr std::array<std::string_view, 3> kNames = {"$i", "$int", "$real"};
    type = Find(type);
    if (type <= kReal) return std::string(kNames.at(type));
    return numeric_[type] ? "a number" : "$i";
  }

 private:
  std::vector<Type> parents_ = {kIndividual, kInteger, kReal};
  std::vector<bool> numeric_ = {false, true, true};
};

struct SignatureKey {
  Symbol symbol;
  std::size_t arity = 0;
  bool is_predicate = false;
  friend auto operator<=>(const SignatureKey&, const SignatureKey&) = default;
};

struct Signature {
  std::vector<Type> arguments;
  Type result = kIndividual;
  std::string name;  ///< Of the declaration, or of an axiom about the symbol's type.
  std::string origin;
};

/// A variable of a formula.
using Place = std::pair<std::size_t, Variable>;

class TypeKeeper {
 public:
  TypeKeeper(TptpFile& file, const TptpTypes& types, SymbolTable& symbols)
      : file_(file), types_(types), symbols_(symbols), equality_(symbols.Intern("=")) {}

  void Run() {
    for (const TptpDeclaration& declaration : types_.declarations) Declare(declaration);
    for (std::size_t i = 0; i < file_.formulas.size(); ++i) {
      if (types_.variables[i]) CheckFormula(i);
    }
    if (file_.diagnostics.empty()) KeepApart();
  }

 private:
  // --- Declarations ---

  void Declare(const TptpDeclaration& declaration) {
    const SignatureKey key = {declaration.symbol, declaration.arguments.size(),
                              declaration.result == TptpType::kTruth};
    Signature signature;
    for (const TptpType type : declaration.arguments) signature.arguments.push_back(Named(type));
    signature.result = Named(declaration.result);
    signature.name = declaration.name;
    signature.origin = "declared in line " + std::to_string(declaration.place.line);
    const auto before = declared_.find(declaration.symbol);
    if (before == declared_.end()) {
      declared_.emplace(declaration.symbol, key);
      for (const Type type : signature.arguments) Use(type);
      if (!key.is_predicate) Use(signature.result);
      signatures_.emplace(key, std::move(signature));
      return;
    }
    const Signature& first = signatures_.at(before->second);
    if (before->second == key && first.arguments == signature.arguments &&
        first.result == signature.result) {
      return;
    }
    Report(declaration.place, Quote(declaration.symbol.name()) + " is declared with two types",
           "it is " + first.origin + " already");
  }

  /// That of the declaration; else a new one, of types to be found out. Null: it was declared as
  /// something else, which is reported.
  Signature* SignatureOf(const SignatureKey& key) {
    const auto known = signatures_.find(key);
    if (known != signatures_.end()) return &known->second;
    if (const auto declared = declared_.find(key.symbol); declared != declared_.end()) {
      const SignatureKey& as = declared->second;
      Report(Quote(key.symbol.name()) + " is declared as a " + Describe(as) + ", and used as a " +
                 Describe(key),
             "it is " + signatures_.at(as).origin);
      return nullptr;
    }
    Signature fresh;
    for (std::size_t i = 0; i < key.arity; ++i) fresh.arguments.push_back(table_.Fresh());
    if (!key.is_predicate) fresh.result = table_.Fresh();
    fresh.name = "type_of_" + std::string(key.symbol.name());
    fresh.origin = "first used in line " + std::to_string(formula().place.line);
    return &signatures_.emplace(key, std::move(fresh)).first->second;
  }

  static std::string Describe(const SignatureKey& key) {
    return std::string(key.is_predicate ? "predicate" : "function") + " of " +
           std::to_string(key.arity) + (key.arity == 1 ? " argument" : " arguments");
  }

  // --- Formulas ---

  const AnnotatedFormula& formula() const { return file_.formulas[index_]; }

  void CheckFormula(std::size_t index) {
    index_ = index;
    reported_ = false;
    std::vector<Type>& variables = variables_[index];
    for (const TptpType type : *types_.variables[index]) {
      variables.push_back(type == TptpType::kNone ? table_.Fresh() : Named(type));
      if (type != TptpType::kNone) Use(variables.back());
    }
    const bool denied = formula().role == Role::kConjecture;
    std::vector<Pending> pending = {{&formula().formula, !denied, denied}};
    while (!pending.empty() && !reported_) {
      const Pending next = pending.back();
      pending.pop_back();
      if (next.formula->kind() == Formula::Kind::kAtom) {
        asserted_ = next.asserted;
        CheckAtom(next.formula->atom());
      }
      AddChildren(next, pending);
    }
  }

  /// A part of a formula, and whether clauses made of the whole say it, its denial or both.
  struct Pending {
    const Formula* formula;
    bool asserted;
    bool denied;
  };

  static void AddChildren(const Pending& parent, std::vector<Pending>& pending) {
    const auto children = parent.formula->children();
    const Formula::Kind kind = parent.formula->kind();
    for (std::size_t i = children.size(); i-- > 0;) {
      Pending child = {&children[i], parent.asserted, parent.denied};
      if (kind == Formula::Kind::kEquivalent) child.asserted = child.denied = true;
      const bool premise = kind == Formula::Kind::kImplies && i == 0;
      if (kind == Formula::Kind::kNot || premise) std::swap(child.asserted, child.denied);
      pending.push_back(child);
    }
  }

  void CheckAtom(const Atom& atom) {
    std::vector<Type> arguments;
    for (const Term& term : atom.arguments()) arguments.push_back(TypeOf(term));
    Apply(atom.predicate(), atom.arguments(), arguments, true);
  }

  /// Terms may be deep: what is begun stands on a stack of its own.
  Type TypeOf(const Term& term) {
    struct Open {
      const Term* term;
      std::vector<Type> arguments;
    };
    std::vector<Open> open = {{&term, {}}};
    while (true) {
      Open& last = open.back();
      const auto arguments = IsApplied(*last.term) ? last.term->arguments() : NoTerms();
      if (last.arguments.size() < arguments.size()) {
        const Term& next = arguments[last.arguments.size()];
        open.push_back({&next, {}});
        continue;
      }
      const Type type = TypeOf(*last.term, last.arguments);
      open.pop_back();
      if (open.empty()) return type;
      open.back().arguments.push_back(type);
    }
  }

  static std::span<const Term> NoTerms() { return {}; }
  static bool IsApplied(const Term& term) { return term.kind() == Term::Kind::kCompound; }

  Type TypeOf(const Term& term, const std::vector<Type>& arguments) {
    switch (term.kind()) {
      case Term::Kind::kVariable:
        return variables_.at(index_)[term.variable()];
      case Term::Kind::kInteger:
        return Use(kInteger);
      case Term::Kind::kReal:
        return Use(kReal);
      default:
        if (term.symbol().kind() == SymbolKind::kDistinctObject) return kIndividual;
        return Apply(term.symbol(), IsApplied(term) ? term.arguments() : NoTerms(), arguments,
                     false);
    }
  }

  /// The type of what comes out.
  Type Apply(Symbol symbol, std::span<const Term> terms, const std::vector<Type>& types,
             bool is_predicate) {
    if (symbol == equality_) return Equate(terms, types);
    if (symbol.name().starts_with("$") && !symbol.name().starts_with("$$")) {
      return Interpret(symbol, terms, types, is_predicate);
    }
    const Signature* const signature = SignatureOf({symbol, terms.size(), is_predicate});
    if (signature == nullptr) return table_.Fresh();
    for (std::size_t i = 0; i < terms.size(); ++i) {
      if (table_.Unify(signature->arguments[i], types[i])) continue;
      Report("argument " + std::to_string(i + 1) + " of " + Quote(symbol.name()) + " is " +
                 table_.Name(signature->arguments[i]) + ", but " + ToString(terms[i]) + " is " +
                 table_.Name(types[i]),
             Quote(symbol.name()) + " is " + signature->origin + NumberHint(types[i]));
      break;
    }
    return signature->result;
  }

  Type Interpret(Symbol symbol, std::span<const Term> terms, const std::vector<Type>& types,
                 bool is_predicate) {
    Expose(terms, computed_);
    Type all = table_.Fresh(true);
    for (std::size_t i = 0; i < terms.size(); ++i) {
      if (table_.Unify(all, types[i])) continue;
      Report("arguments of " + Quote(symbol.name()) + " are numbers of one type, but " +
                 ToString(terms[i]) + " is " + table_.Name(types[i]),
             i == 0 ? "" : "write 1.0 for the real, $to_real(X) for the real of X");
      break;
    }
    if (is_predicate) return all;
    if (symbol.name() == "$to_int") return Use(kInteger);
    if (symbol.name() == "$to_real") return Use(kReal);
    // The quotient of two integers may be none.
    if (symbol.name() == "$quotient" && table_.Find(all) != kReal) {
      Use(kReal);
      return table_.Fresh(true);
    }
    return all;
  }

  Type Equate(std::span<const Term> terms, const std::vector<Type>& types) {
    if (asserted_) Expose(terms, equated_);
    if (!table_.Unify(types[0], types[1])) {
      Report(ToString(terms[0]) + " is " + table_.Name(types[0]) + ", and " + ToString(terms[1]) +
                 ", which it is equated with, is " + table_.Name(types[1]),
             "only what is of one type can be equal");
    }
    return types[0];
  }

  Type Use(Type type) {
    used_.insert(type);
    return type;
  }

  void Expose(std::span<const Term> terms, std::set<Place>& exposed) {
    for (const Term& term : terms) {
      if (term.is_variable()) exposed.emplace(index_, term.variable());
    }
  }

  std::string ToString(const Term& term) const {
    return Quote(logic::ToString(term, formula().variable_names));
  }

  std::string NumberHint(Type type) {
    return table_.Find(type) == kInteger ? "; reals are written as 1.0" : "";
  }

  /// Of the present formula; only the first.
  void Report(std::string message, std::string hint) {
    if (!reported_) Report(formula().place, std::move(message), std::move(hint));
    reported_ = true;
  }
  void Report(const SourcePlace& place, std::string message, std::string hint) {
    file_.diagnostics.push_back({place, std::move(message), std::move(hint), {}});
  }

  // --- Conditions ---

  bool IsIndividual(Type type) { return !table_.IsNumeric(type); }

  void KeepApart() {
    const bool integers = used_.contains(kInteger);
    const bool reals = used_.contains(kReal);
    if (integers && reals) {
      for (const Place& place : computed_) {
        if (table_.Find(TypeAt(place)) == kInteger) conditions_[place] = symbols_.Intern("$is_int");
      }
    }
    const bool equated = std::any_of(equated_.begin(), equated_.end(), [&](const Place& place) {
      return IsIndividual(TypeAt(place));
    });
    if (equated && (integers || reals)) KeepIndividuals();
    std::set<std::size_t> conditioned;
    for (const auto& [place, condition] : conditions_) conditioned.insert(place.first);
    for (const std::size_t index : conditioned) {
      index_ = index;
      file_.formulas[index].formula = WithConditions(formula().formula);
    }
  }

  Type TypeAt(const Place& place) const { return variables_.at(place.first)[place.second]; }

  void KeepIndividuals() {
    individual_ = symbols_.Intern("is an individual");
    for (const auto& [index, types] : variables_) {
      for (std::size_t i = 0; i < types.size(); ++i) {
        if (IsIndividual(types[i])) conditions_[{index, static_cast<Variable>(i)}] = individual_;
      }
    }
    AddAxiom("individuals", Formula::Exists({0}, Formula::Of(Atom(individual_, {Term::Var(0)}))),
             1);
    for (const auto& [key, signature] : signatures_) {
      if (key.is_predicate || !IsIndividual(signature.result)) continue;
      AddAxiom(signature.name, TypeAxiom(key), key.arity);
    }
  }

  /// What the function gives is an individual.
  Formula TypeAxiom(const SignatureKey& key) const {
    std::vector<Term> arguments;
    std::vector<Variable> variables;
    for (std::size_t i = 0; i < key.arity; ++i) {
      variables.push_back(static_cast<Variable>(i));
      arguments.push_back(Term::Var(variables.back()));
    }
    const Term term = arguments.empty() ? Term::Constant(key.symbol)
                                        : Term::Compound(key.symbol, std::move(arguments));
    Formula axiom = Formula::Of(Atom(individual_, {term}));
    return variables.empty() ? axiom : Formula::Forall(std::move(variables), std::move(axiom));
  }

  void AddAxiom(std::string name, Formula formula, std::size_t variables) {
    AnnotatedFormula axiom;
    axiom.name = std::move(name);
    axiom.formula = std::move(formula);
    for (std::size_t i = 0; i < variables; ++i) {
      axiom.variable_names.push_back("X" + std::to_string(i));
    }
    axiom.place = file_.formulas.front().place;
    file_.formulas.push_back(std::move(axiom));
    if (!file_.sources.empty()) file_.sources.emplace_back();
    if (!file_.texts.empty()) file_.texts.emplace_back();
  }

  /// Formulas may be deep: what is begun stands on a stack of its own.
  Formula WithConditions(const Formula& whole) const {
    struct Open {
      const Formula* formula;
      std::vector<Formula> children;
    };
    std::vector<Open> open = {{&whole, {}}};
    while (true) {
      Open& last = open.back();
      const auto children = last.formula->children();
      if (last.children.size() < children.size()) {
        const Formula& next = children[last.children.size()];
        open.push_back({&next, {}});
        continue;
      }
      Formula made = Conditioned(*last.formula, std::move(last.children));
      open.pop_back();
      if (open.empty()) return made;
      open.back().children.push_back(std::move(made));
    }
  }

  Formula Conditioned(const Formula& formula, std::vector<Formula> children) const {
    if (children.empty()) return formula;
    std::vector<Formula> conditions;
    for (const Variable variable : formula.variables()) {
      const auto found = conditions_.find({index_, variable});
      if (found == conditions_.end()) continue;
      conditions.push_back(Formula::Of(Atom(found->second, {Term::Var(variable)})));
    }
    if (conditions.empty()) return formula.With(std::move(children));
    if (formula.kind() == Formula::Kind::kExists) {
      conditions.push_back(std::move(children[0]));
      children[0] = Formula::And(std::move(conditions));
      return formula.With(std::move(children));
    }
    Formula condition =
        conditions.size() == 1 ? std::move(conditions[0]) : Formula::And(std::move(conditions));
    children[0] = Formula::Implies(std::move(condition), std::move(children[0]));
    return formula.With(std::move(children));
  }

  TptpFile& file_;
  const TptpTypes& types_;
  SymbolTable& symbols_;
  Symbol equality_;
  TypeTable table_;
  std::map<Symbol, SignatureKey> declared_;
  std::map<SignatureKey, Signature> signatures_;
  std::map<std::size_t, std::vector<Type>> variables_;  ///< Of each tff formula.
  std::size_t index_ = 0;                               ///< Of the present formula.
  bool reported_ = false;
  bool asserted_ = false;     ///< The present atom.
  std::set<Type> used_;       ///< Types that have names.
  std::set<Place> computed_;  ///< Variables compared or computed with.
  std::set<Place> equated_;
  Symbol individual_;
  std::map<Place, Symbol> conditions_;
};

}  // namespace

void KeepTypes(TptpFile& file, const TptpTypes& types, SymbolTable& symbols) {
  TypeKeeper(file, types, symbols).Run();
}

}  // namespace latchwork::logic

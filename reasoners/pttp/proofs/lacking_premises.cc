// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/lacking_premises.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace latchwork::pttp {
namespace {

using logic::Literal;
using logic::Term;

void RaiseAbove(const Term& term, std::size_t& count) {
  if (term.is_variable()) count = std::max<std::size_t>(count, term.variable() + 1);
  for (const Term& argument : term.arguments()) RaiseAbove(argument, count);
}

Term Shift(const Term& term, std::size_t by) {
  if (term.is_variable()) return Term::Var(static_cast<logic::Variable>(term.variable() + by));
  if (term.kind() != Term::Kind::kCompound) return term;
  std::vector<Term> arguments;
  for (const Term& argument : term.arguments()) arguments.push_back(Shift(argument, by));
  return Term::Compound(term.symbol(), std::move(arguments));
}

/// Takes the first proof, and how literals read under it.
class TextSink final : public ProofSink {
 public:
  TextSink(Engine& engine, const logic::Clause& clause, std::span<const CompiledLiteral> literals,
           std::vector<std::string>& texts)
      : engine_(engine), clause_(clause), literals_(literals), texts_(texts) {}

  bool Accept(const Proof& proof) override {
    std::vector<Word> variables;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < clause_.variable_names.size(); ++i) {
      const Term value = engine_.Value(Dereference(proof.slots[i]), variables);
      if (!value.is_variable()) continue;
      names.resize(std::max<std::size_t>(names.size(), value.variable() + 1));
      if (names[value.variable()].empty()) names[value.variable()] = clause_.variable_names[i];
    }
    for (std::size_t i = 0; i < literals_.size(); ++i) {
      const CompiledLiteral& literal = literals_[i];
      texts_[i] = ToString(
          Literal{literal.positive, engine_.Instance(literal, proof.slots, variables)}, names);
    }
    return true;
  }

 private:
  Engine& engine_;
  const logic::Clause& clause_;
  std::span<const CompiledLiteral> literals_;
  std::vector<std::string>& texts_;
};

/// Proves premises of one clause together, as many as there are to be proved.
class Attempt {
 public:
  /// `budget`: what is left of it.
  Attempt(const logic::Clause& clause, const logic::Atom& target, Engine& engine,
          sdk::Budget& budget)
      : clause_(clause), target_(target), engine_(engine), budget_(budget) {}

  /// Nothing: the clause concludes no instance of the target whatever holds.
  std::optional<sdk::NearMiss> Follow(const Literal& head, logic::Symbol equality) {
    const std::size_t own = clause_.variable_names.size();
    variables_ = own + VariablesOf(target_);
    for (const Literal& literal : clause_.literals) {
      if (&literal != &head) premises_.push_back({!literal.positive, literal.atom});
    }
    const std::size_t premises = premises_.size();
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < target_.arity(); ++i) {
      chosen.push_back(premises_.size());
      premises_.push_back(
          {true, {equality, {head.atom.argument(i), Shift(target_.argument(i), own)}}});
    }
    Compile();
    if (HasPremiseBeyondProof(premises)) return std::nullopt;
    const SearchEnd fits = chosen.empty() ? SearchEnd::kAccepted : Prove(chosen);
    if (fits == SearchEnd::kExhausted) return std::nullopt;
    // An argument that is computed is known when the premises are.
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < premises; ++i) open.push_back(i);
    if (fits == SearchEnd::kUndetermined) open.insert(open.end(), chosen.begin(), chosen.end());
    if (fits != SearchEnd::kAccepted) chosen.clear();
    const std::size_t all = open.size();
    while (ProveOneMore(chosen, open)) {
    }
    return sdk::NearMiss{clause_.name, clause_.place, all - open.size(), all, Lacked(open)};
  }

 private:
  std::string Lacked(const std::vector<std::size_t>& open) const {
    if (open.empty()) return "a deeper search";
    if (budget_.inferences > 0) return texts_[open.front()];
    return "more inferences to say what";
  }

  void Compile() {
    for (const Literal& premise : premises_) {
      texts_.push_back(ToString(premise, clause_.variable_names));
      Contrapositive one;
      engine_.CompileQuery({&premise, 1}, variables_, terms_, one);
      compiled_.push_back(one.body.front());
    }
  }

  /// Denials that nothing can show make a clause one that concludes other things.
  bool HasPremiseBeyondProof(std::size_t premises) {
    for (std::size_t i = 0; i < premises; ++i) {
      if (premises_[i].positive) continue;
      Query query;
      engine_.CompileQuery({&premises_[i], 1}, variables_, query.terms, query.clause);
      if (!engine_.Prepare(query)) return true;
    }
    return false;
  }

  bool ProveOneMore(std::vector<std::size_t>& chosen, std::vector<std::size_t>& open) {
    for (auto next = open.begin(); next != open.end(); ++next) {
      chosen.push_back(*next);
      if (Prove(chosen) == SearchEnd::kAccepted) {
        open.erase(next);
        return true;
      }
      chosen.pop_back();
    }
    return false;
  }

  SearchEnd Prove(const std::vector<std::size_t>& chosen) {
    if (budget_.inferences == 0) return SearchEnd::kStopped;
    std::vector<Literal> literals;
    literals.reserve(chosen.size());
    for (const std::size_t index : chosen) literals.push_back(premises_[index]);
    Query query;
    engine_.Begin(budget_);
    engine_.CompileQuery(literals, variables_, query.terms, query.clause);
    TextSink sink(engine_, clause_, compiled_, texts_);
    const SearchEnd end = engine_.SolveWithSteps(query, budget_.depth, sink);
    budget_.inferences -= std::min(budget_.inferences, engine_.meter().inferences());
    return end;
  }

  const logic::Clause& clause_;
  const logic::Atom& target_;
  Engine& engine_;
  sdk::Budget& budget_;
  std::size_t variables_ = 0;
  std::vector<Literal> premises_;  ///< Then what makes the head the target.
  Arena terms_;
  std::vector<CompiledLiteral> compiled_;
  std::vector<std::string> texts_;  ///< As far as they are known.
};

}  // namespace

std::size_t VariablesOf(const logic::Atom& atom) {
  std::size_t count = 0;
  for (const Term& argument : atom.arguments()) RaiseAbove(argument, count);
  return count;
}

std::vector<sdk::NearMiss> LackingPremises(const logic::Atom& target, const sdk::Budget& budget,
                                           Engine& engine, logic::SymbolTable& symbols) {
  const logic::Symbol equality = symbols.Intern("=");
  sdk::Budget left = budget;
  std::vector<sdk::NearMiss> misses;
  for (const logic::Clause& clause : engine.program().clauses()) {
    if (clause.literals.size() < 2) continue;
    for (const Literal& literal : clause.literals) {
      if (!literal.positive || NameOf(literal.atom) != NameOf(target)) continue;
      auto miss = Attempt(clause, target, engine, left).Follow(literal, equality);
      if (!miss) continue;
      misses.push_back(*std::move(miss));
      break;
    }
  }
  std::ranges::stable_sort(misses, {},
                           [](const sdk::NearMiss& miss) { return miss.premises - miss.met; });
  return misses;
}

}  // namespace latchwork::pttp

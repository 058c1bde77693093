// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/exact/search_reasons.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "reasoners/circumscription/exact/reasons.h"

namespace latchwork::circumscription {

SearchReasons::SearchReasons(const GroundStore& store, const Evaluator& evaluator,
                             std::span<const Literal> latches, const EngineOptions& options)
    : store_(store), evaluator_(evaluator), engine_(store.theory(), options) {
  engine_.SetLatches(latches);
}

std::string SearchReasons::TextOf(Literal literal) const {
  const logic::Fact fact =
      FactOf(store_, evaluator_.bank(), evaluator_.program().relations(), AtomOf(literal));
  return ToString(logic::Literal{literal > 0, fact});
}

bool SearchReasons::IsEverywhere(Literal literal) {
  return engine_.EntailsAlways({&literal, 1}).verdict == Verdict::kYes;
}

/// Nothing: the instance does not conclude the atom.
std::optional<sdk::NearMiss> SearchReasons::MissOf(std::size_t clause, const Model& world,
                                                   Atom atom) {
  const Clause& literals = store_.theory().clauses[clause];
  if (store_.source(clause) == kNoIndex ||
      std::find(literals.begin(), literals.end(), atom) == literals.end()) {
    return std::nullopt;
  }
  const logic::Clause& source = evaluator_.program().clauses()[store_.source(clause)];
  sdk::NearMiss miss{source.name, source.place, 0, literals.size() - 1, {}};
  Literal lacked = 0;
  for (const Literal literal : literals) {
    if (literal == atom) continue;
    if (!world.Holds(literal)) {
      ++miss.met;
    } else if (lacked == 0 || (!IsEverywhere(lacked) && IsEverywhere(literal))) {
      lacked = literal;
    }
  }
  // A premise is the contrary of its literal.
  miss.lacks = TextOf(-lacked);
  return miss;
}

/// Of each clause of the body its nearest instance, the nearest clause first.
std::vector<sdk::NearMiss> SearchReasons::MissesIn(const Model& world, Atom atom) {
  std::map<std::size_t, sdk::NearMiss> nearest;
  for (std::size_t clause = 0; clause < store_.size(); ++clause) {
    auto miss = MissOf(clause, world, atom);
    if (!miss) continue;
    const auto [place, is_new] = nearest.try_emplace(store_.source(clause), *miss);
    if (is_new) continue;
    sdk::NearMiss& known = place->second;
    if (known.premises - known.met > miss->premises - miss->met) known = *std::move(miss);
  }
  std::vector<sdk::NearMiss> misses;
  misses.reserve(nearest.size());
  for (auto& each : nearest) misses.push_back(std::move(each.second));
  std::stable_sort(misses.begin(), misses.end(), [](const auto& a, const auto& b) {
    return a.premises - a.met < b.premises - b.met;
  });
  return misses;
}

/// What not all minimal worlds share, the atom first.
sdk::Derivation SearchReasons::Describe(const Model& world, Atom atom) {
  sdk::Derivation derivation;
  const auto add = [&](Literal literal) {
    sdk::DerivationStep step;
    step.kind = sdk::DerivationStep::Kind::kReduction;
    step.conclusion = TextOf(literal);
    step.source = "minimal world";
    derivation.steps.push_back(std::move(step));
  };
  add(-atom);
  for (Atom other = 1; other <= static_cast<Atom>(world.size()); ++other) {
    if (other == atom || !world.Holds(other) || store_.place(other).is_given) continue;
    if (!IsEverywhere(other)) add(other);
  }
  return derivation;
}

std::optional<sdk::Explanation> SearchReasons::WhyFalse(Atom atom) {
  const std::optional<Model> world = engine_.CounterModel(atom);
  if (!world) return std::nullopt;
  sdk::Explanation explanation{TextOf(atom), false, MissesIn(*world, atom), {}};
  if (!IsEverywhere(-atom)) explanation.derivation = Describe(*world, atom);
  return explanation;
}

}  // namespace latchwork::circumscription

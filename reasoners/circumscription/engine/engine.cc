// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/engine/engine.h"

#include <algorithm>
#include <utility>

namespace latchwork::circumscription {

std::string_view Name(Verdict verdict) {
  if (verdict == Verdict::kYes) return "yes";
  return verdict == Verdict::kNo ? "no" : "unknown";
}

std::string_view Name(Basis basis) {
  switch (basis) {
    case Basis::kInconsistent:
      return "inconsistent";
    case Basis::kCertificate:
      return "certificate";
    case Basis::kUnique:
      return "unique";
    case Basis::kAllMinimal:
      return "all-minimal";
    case Basis::kWitness:
      return "witness";
    case Basis::kBudget:
      break;
  }
  return "budget";
}

Engine::Engine(const GroundTheory& theory, const EngineOptions& options)
    : theory_(theory),
      options_(options),
      certificate_(theory_),
      search_(std::make_unique<MinimalModels>(theory_, options.conflicts, options.spending)) {}

bool Engine::SetLatches(std::span<const Literal> latches) {
  ++statistics_.cycles;
  latches_.assign(latches.begin(), latches.end());
  minimal_.clear();
  world_ = World::kUnexplored;
  settled_ = false;
  certified_ = options_.use_certificate && certificate_.Close(latches);
  if (certified_) ++statistics_.certified;
  return certified_;
}

Answer Engine::EntailsAlways(std::span<const Literal> clause) {
  if (certified_) return FromCertificate(clause);
  Explore();
  if (world_ == World::kSome) {
    if (IsRefuted(clause)) return {Verdict::kNo, Basis::kWitness};
    ExploreOther();
  }
  switch (world_) {
    case World::kInconsistent:
      return {Verdict::kYes, Basis::kInconsistent};
    case World::kUnique:
      return FromUnique(clause);
    case World::kPlural:
      return Search(clause);
    case World::kUnexplored:
    case World::kSome:
    case World::kUndecided:
      break;
  }
  return {};
}

Answer Engine::HoldsSomewhere(std::span<const Literal> conjunction) {
  std::vector<Literal> clause;
  for (const Literal literal : conjunction) clause.push_back(-literal);
  const Answer answer = EntailsAlways(clause);
  if (answer.verdict == Verdict::kUnknown) return answer;
  return {answer.verdict == Verdict::kYes ? Verdict::kNo : Verdict::kYes, answer.basis};
}

std::optional<Model> Engine::CounterModel(Literal literal) {
  Model candidate;
  if (certified_) {
    candidate = certificate_.ToModel();
    if (!candidate.Holds(literal)) return candidate;
    negation_ = {-literal};
    Model varied;
    if (search_->Vary(candidate, negation_, varied) != SatResult::kSatisfiable) return {};
    return varied;
  }
  if (EntailsAlways({&literal, 1}).verdict != Verdict::kNo) return {};
  negation_ = {-literal};
  Model lower;
  for (std::size_t calls = 0; calls < options_.calls; calls += 2) {
    if (search_->Candidate(latches_, negation_, candidate) != SatResult::kSatisfiable) return {};
    const SatResult result = search_->Below(candidate, literal, lower);
    if (result == SatResult::kLimit) return {};
    // No model below has the literal, so a minimal one below has it not.
    if (result == SatResult::kUnsatisfiable) {
      if (!Descend(candidate)) return {};
      return minimal_.back();
    }
    search_->Learn(candidate, lower);
  }
  return {};
}

Answer Engine::IsInconsistent() {
  if (certified_) return {Verdict::kNo, Basis::kCertificate};
  Explore();
  if (world_ == World::kUndecided) return {};
  if (world_ == World::kInconsistent) return {Verdict::kYes, Basis::kInconsistent};
  return {Verdict::kNo, Basis::kWitness};
}

EngineStatistics Engine::statistics() const {
  EngineStatistics statistics = statistics_;
  statistics.sat_calls += search_->calls();
  statistics.learnt = search_->learnt();
  return statistics;
}

bool Engine::Descend(Model& model) {
  Model lower;
  for (std::size_t calls = 0; calls < options_.calls; ++calls) {
    const SatResult result = search_->Below(model, 0, lower);
    if (result == SatResult::kLimit) return false;
    if (result == SatResult::kUnsatisfiable) {
      minimal_.push_back(model);
      return true;
    }
    search_->Learn(model, lower);
    std::swap(model, lower);
  }
  return false;
}

void Engine::Explore() {
  if (world_ != World::kUnexplored) return;
  world_ = World::kUndecided;
  if (search_->learnt() > options_.max_learnt) {
    statistics_.sat_calls += search_->calls();
    search_ = std::make_unique<MinimalModels>(theory_, options_.conflicts, options_.spending);
  }
  Model model;
  const SatResult result = search_->Candidate(latches_, {}, model);
  if (result == SatResult::kUnsatisfiable) world_ = World::kInconsistent;
  if (result == SatResult::kSatisfiable && Descend(model)) world_ = World::kSome;
}

void Engine::ExploreOther() {
  world_ = World::kUndecided;
  Model other;
  const SatResult result = search_->Other(latches_, minimal_.front(), other);
  if (result == SatResult::kLimit) return;
  const bool unique = result == SatResult::kUnsatisfiable && KnowsFixed();
  world_ = unique ? World::kUnique : World::kPlural;
  if (result == SatResult::kSatisfiable && !Descend(other)) world_ = World::kUndecided;
}

Answer Engine::FromCertificate(std::span<const Literal> clause) {
  const std::optional<bool> holds = certificate_.SatisfiesAll(clause);
  if (holds) return {*holds ? Verdict::kYes : Verdict::kNo, Basis::kCertificate};
  negation_.clear();
  for (const Literal literal : clause) negation_.push_back(-literal);
  return VaryWorld(certificate_.ToModel(), Basis::kCertificate);
}

/// Whether the varying atoms can make the negated query true in the only minimal world.
Answer Engine::VaryWorld(const Model& model, Basis basis) {
  Model varied;
  const SatResult result = search_->Vary(model, negation_, varied);
  if (result == SatResult::kLimit) return {};
  return {result == SatResult::kSatisfiable ? Verdict::kNo : Verdict::kYes, basis};
}

Answer Engine::FromUnique(std::span<const Literal> clause) {
  const Model& model = minimal_.front();
  bool holds = false;
  negation_.clear();
  for (const Literal literal : clause) {
    negation_.push_back(-literal);
    if (!model.Holds(literal)) continue;
    if (theory_.role(AtomOf(literal)) != Role::kVarying) return {Verdict::kYes, Basis::kUnique};
    holds = true;
  }
  if (!holds) return {Verdict::kNo, Basis::kUnique};
  return VaryWorld(model, Basis::kUnique);
}

bool Engine::KnowsFixed() const {
  std::vector<Atom> known;
  for (const Literal latch : latches_) known.push_back(AtomOf(latch));
  std::sort(known.begin(), known.end());
  return std::includes(known.begin(), known.end(), theory_.fixed().begin(), theory_.fixed().end());
}

/// Whether a minimal model below one that falsifies the clause falsifies it, too.
bool Engine::IsPositive(std::span<const Literal> clause) const {
  return std::all_of(clause.begin(), clause.end(), [&](Literal literal) {
    const Role role = theory_.role(AtomOf(literal));
    return role == Role::kFixed ||
           (role == Role::kMinimized && literal > 0 && theory_.level(AtomOf(literal)) == 0);
  });
}

bool Engine::IsRefuted(std::span<const Literal> clause) const {
  return std::any_of(minimal_.begin(), minimal_.end(),
                     [&](const Model& model) { return !Satisfies(model, clause); });
}

Answer Engine::Search(std::span<const Literal> clause) {
  if (IsRefuted(clause)) return {Verdict::kNo, Basis::kWitness};
  negation_.clear();
  for (const Literal literal : clause) negation_.push_back(-literal);
  if (clause.size() != 1) return Refute(clause);
  const auto place = std::lower_bound(asked_.begin(), asked_.end(), clause[0]);
  if (place == asked_.end() || *place != clause[0]) {
    if (asked_.size() < options_.max_asked) asked_.insert(place, clause[0]);
    return Refute(clause);
  }
  if (!settled_) Settle();
  if (std::binary_search(agreed_.begin(), agreed_.end(), clause[0])) {
    return {Verdict::kYes, Basis::kAllMinimal};
  }
  return IsRefuted(clause) ? Answer{Verdict::kNo, Basis::kWitness} : Refute(clause);
}

void Engine::Settle() {
  settled_ = true;
  agreed_ = asked_;
  for (std::size_t calls = 0; calls < options_.calls; calls += 2) {
    agreed_.erase(std::remove_if(agreed_.begin(), agreed_.end(),
                                 [&](Literal literal) {
                                   return IsRefuted({&literal, 1});
                                 }),
                  agreed_.end());
    if (agreed_.empty()) return;
    Model candidate;
    const SatResult result = search_->Doubt(latches_, agreed_, candidate);
    if (result == SatResult::kUnsatisfiable) return;
    if (result == SatResult::kLimit || !Descend(candidate)) break;
  }
  agreed_.clear();
}

/// Looks for a minimal model of negation_.
Answer Engine::Refute(std::span<const Literal> clause) {
  const bool positive = IsPositive(clause);
  const Literal also = clause.size() == 1 ? clause[0] : 0;
  Model candidate;
  Model lower;
  for (std::size_t calls = 0; calls < options_.calls; calls += 2) {
    SatResult result = search_->Candidate(latches_, negation_, candidate);
    if (result == SatResult::kLimit) break;
    if (result == SatResult::kUnsatisfiable) return {Verdict::kYes, Basis::kAllMinimal};
    if (positive) return {Verdict::kNo, Basis::kWitness};
    result = search_->Below(candidate, also, lower);
    if (result == SatResult::kLimit) break;
    if (result == SatResult::kUnsatisfiable) {
      if (also == 0) minimal_.push_back(candidate);
      return {Verdict::kNo, Basis::kWitness};
    }
    search_->Learn(candidate, lower);
  }
  return {};
}

}  // namespace latchwork::circumscription

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/policies/policy.h"

#include <array>

namespace latchwork::circumscription {
namespace {

constexpr std::array<Policy, 5> kPolicies = {Policy::kCwa, Policy::kGcwa, Policy::kCcwa,
                                             Policy::kEgcwa, Policy::kEcwa};

/// What is minimized, and in what order, as the policy has it.
GroundTheory WithRoles(GroundTheory theory, Policy policy) {
  if (policy == Policy::kEcwa) return theory;
  const bool all = policy == Policy::kGcwa || policy == Policy::kEgcwa;
  for (AtomInfo& atom : theory.atoms) {
    atom.level = 1;
    if (all) atom.role = Role::kMinimized;
  }
  return theory;
}

/// Facts over atoms that are not fixed any more belong to the theory.
GroundTheory WithFacts(GroundTheory theory, std::span<const Literal> facts) {
  for (const Literal fact : facts) theory.clauses.push_back({fact});
  return theory;
}

/// Nothing is minimized: minimal models are the models.
GroundTheory Classical(GroundTheory theory) {
  for (AtomInfo& atom : theory.atoms) atom.role = Role::kVarying;
  return theory;
}

}  // namespace

std::string_view Name(Policy policy) {
  switch (policy) {
    case Policy::kCwa:
      return "cwa";
    case Policy::kGcwa:
      return "gcwa";
    case Policy::kCcwa:
      return "ccwa";
    case Policy::kEgcwa:
      return "egcwa";
    case Policy::kEcwa:
      break;
  }
  return "ecwa";
}

std::optional<Policy> FindPolicy(std::string_view name) {
  for (const Policy policy : kPolicies) {
    if (Name(policy) == name) return policy;
  }
  return std::nullopt;
}

ClosedWorld::ClosedWorld(const GroundTheory& theory, std::span<const Literal> latches,
                         Policy policy, const EngineOptions& options) {
  const GroundTheory roles = WithFacts(WithRoles(theory, policy), latches);
  if (policy == Policy::kEcwa || policy == Policy::kEgcwa) {
    engine_ = std::make_unique<Engine>(roles, options);
  } else {
    CloseAtoms(roles, policy, options);
    GroundTheory closed = Classical(roles);
    for (const Atom atom : closed_) closed.clauses.push_back({-atom});
    engine_ = std::make_unique<Engine>(closed, options);
  }
  engine_->SetLatches({});
}

void ClosedWorld::CloseAtoms(const GroundTheory& theory, Policy policy,
                             const EngineOptions& options) {
  Engine engine(policy == Policy::kCwa ? Classical(theory) : theory, options);
  engine.SetLatches({});
  for (std::size_t i = 0; i < theory.atoms.size(); ++i) {
    if (theory.atoms[i].role != Role::kMinimized) continue;
    const auto atom = static_cast<Atom>(i + 1);
    const Literal asked = policy == Policy::kCwa ? atom : -atom;
    const Verdict verdict = engine.EntailsAlways({&asked, 1}).verdict;
    complete_ = complete_ && verdict != Verdict::kUnknown;
    const Verdict closes = policy == Policy::kCwa ? Verdict::kNo : Verdict::kYes;
    if (verdict == closes) closed_.push_back(atom);
  }
}

}  // namespace latchwork::circumscription

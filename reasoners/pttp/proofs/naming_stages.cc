// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/naming_stages.h"

#include <algorithm>
#include <utility>

namespace latchwork::pttp {
namespace {

using logic::Formula;
using logic::Variable;
using Kind = Formula::Kind;

/// What stands below negations and universal quantifiers.
struct Inner {
  const Formula* formula;
  bool positive;
  std::vector<Variable> variables = {};

  void Descend() {
    while (true) {
      const Kind universal = positive ? Kind::kForall : Kind::kExists;
      if (formula->kind() != Kind::kNot && formula->kind() != universal) return;
      const auto bound = formula->variables();
      variables.insert(variables.end(), bound.begin(), bound.end());
      positive = positive != (formula->kind() == Kind::kNot);
      formula = &formula->children()[0];
    }
  }
  bool is_disjunction() const { return formula->kind() == (positive ? Kind::kOr : Kind::kAnd); }
};

}  // namespace

std::optional<NamingStages> NamingStages::Of(const Formula& formula, bool positive,
                                             const Formula& normal) {
  Inner said{&formula, positive};
  Inner named{&normal, true};
  said.Descend();
  named.Descend();
  std::sort(said.variables.begin(), said.variables.end());
  std::sort(named.variables.begin(), named.variables.end());
  if (!said.is_disjunction() || !named.is_disjunction() || !named.positive ||
      said.variables != named.variables) {
    return std::nullopt;
  }
  const auto before = said.formula->children();
  const auto after = named.formula->children();
  if (before.size() != after.size()) return std::nullopt;
  NamingStages stages;
  stages.variables_ = std::move(said.variables);
  stages.said_.assign(before.begin(), before.end());
  stages.positive_ = said.positive;
  stages.parts_.assign(after.begin(), after.end());
  return stages;
}

Formula NamingStages::Stage(std::size_t first) const {
  const auto split = static_cast<std::ptrdiff_t>(first);
  std::vector<Formula> said(said_.begin(), said_.begin() + split);
  std::vector<Formula> parts(parts_.begin() + split, parts_.end());
  if (!said.empty()) {
    Formula left = said.size() == 1 ? said[0]
                   : positive_      ? Formula::Or(std::move(said))
                                    : Formula::And(std::move(said));
    if (!positive_) left = Formula::Not(std::move(left));
    parts.insert(parts.begin(), std::move(left));
  }
  Formula stage = parts.size() == 1 ? std::move(parts[0]) : Formula::Or(std::move(parts));
  return variables_.empty() ? stage : Formula::Forall(variables_, std::move(stage));
}

}  // namespace latchwork::pttp

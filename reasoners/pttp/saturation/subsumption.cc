// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/saturation/subsumption.h"

#include <algorithm>

namespace latchwork::pttp::saturation {
namespace {

constexpr std::size_t kMaxSteps = 3000;

}  // namespace

bool Subsumer::Subsumes(std::span<const Literal> general, std::span<const Literal> special) {
  if (general.size() > special.size()) return false;
  pattern_.assign(general.begin(), general.end());
  std::ranges::stable_sort(pattern_, [&](const Literal& a, const Literal& b) {
    return terms_.size(a.left) > terms_.size(b.left);
  });
  used_.assign(special.size(), 0);
  steps_ = 0;
  const bool found = Cover(0, special);
  matcher_.Undo(0);
  return found;
}

bool Subsumer::Cover(std::size_t next, std::span<const Literal> special) {
  if (next == pattern_.size()) return true;
  for (std::size_t i = 0; i < special.size(); ++i) {
    if (used_[i] != 0 || special[i].positive != pattern_[next].positive) continue;
    if (++steps_ > kMaxSteps) return false;
    used_[i] = 1;
    if (CoverBy(next, special[i], special)) return true;
    used_[i] = 0;
  }
  return false;
}

bool Subsumer::CoverBy(std::size_t next, const Literal& target, std::span<const Literal> special) {
  const Literal& pattern = pattern_[next];
  if (pattern.is_equation() != target.is_equation()) return false;
  if (Assign(pattern, target.left, target.right, next, special)) return true;
  return pattern.is_equation() && Assign(pattern, target.right, target.left, next, special);
}

bool Subsumer::Assign(const Literal& pattern, TermId left, TermId right, std::size_t next,
                      std::span<const Literal> special) {
  const std::size_t mark = matcher_.Mark();
  if (matcher_.Match(pattern.left, left) && matcher_.Match(pattern.right, right) &&
      Cover(next + 1, special)) {
    return true;
  }
  matcher_.Undo(mark);
  return false;
}

FeatureIndex::Trie::Key FeatureIndex::Features(std::span<const Literal> literals) {
  Trie::Key key{};
  for (const Literal& literal : literals) {
    const std::size_t sign = literal.positive ? 0 : 1;
    ++key[sign];
    visits_.assign({literal.left, literal.right});
    while (!visits_.empty()) {
      const TermId term = visits_.back();
      visits_.pop_back();
      if (Terms::IsVariable(term) || term == kTrue) continue;
      ++key[2 + 2 * (terms_.head(term) % kClasses) + sign];
      for (const TermId argument : terms_.arguments(term)) visits_.push_back(argument);
    }
  }
  return key;
}

}  // namespace latchwork::pttp::saturation

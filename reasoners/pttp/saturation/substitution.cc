// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/saturation/substitution.h"

#include <algorithm>

namespace latchwork::pttp::saturation {
namespace {

constexpr std::size_t kMaxSteps = 4'000'000;

std::size_t Place(Item variable) {
  return std::size_t{Terms::Number(variable.term)} * 2 + variable.bank;
}

}  // namespace

void Substitution::Reset() {
  for (const std::size_t place : trail_) bindings_[place] = {};
  for (const std::size_t place : named_) names_[place] = kNoTerm;
  trail_.clear();
  named_.clear();
}

Item Substitution::Resolve(Item item) const {
  while (Terms::IsVariable(item.term)) {
    const std::size_t place = Place(item);
    if (place >= bindings_.size() || bindings_[place].term == kNoTerm) break;
    item = bindings_[place];
  }
  return item;
}

void Substitution::Bind(Item variable, Item value) {
  const std::size_t place = Place(variable);
  if (place >= bindings_.size()) bindings_.resize(place + 1);
  bindings_[place] = value;
  trail_.push_back(place);
}

bool Substitution::Occurs(Item variable, Item in) {
  visits_.assign(1, in);
  std::size_t steps = 0;
  while (!visits_.empty()) {
    if (++steps > kMaxSteps) {
      overflowed_ = true;
      return true;
    }
    const Item item = Resolve(visits_.back());
    visits_.pop_back();
    if (Terms::IsVariable(item.term)) {
      if (item == variable) return true;
      continue;
    }
    if (terms_.is_ground(item.term)) continue;
    for (const TermId argument : terms_.arguments(item.term)) {
      visits_.push_back({argument, item.bank});
    }
  }
  return false;
}

bool Substitution::Unify(Item first, Item second) {
  pairs_.assign(1, {first, second});
  std::size_t steps = 0;
  while (!pairs_.empty()) {
    if (++steps > kMaxSteps) {
      overflowed_ = true;
      return false;
    }
    Item a = Resolve(pairs_.back().first);
    Item b = Resolve(pairs_.back().second);
    pairs_.pop_back();
    if (a.term == b.term && (a.bank == b.bank || terms_.is_ground(a.term))) continue;
    if (!Terms::IsVariable(a.term)) std::swap(a, b);
    if (Terms::IsVariable(a.term)) {
      if (!Terms::IsVariable(b.term) && Occurs(a, b)) return false;
      Bind(a, b);
      continue;
    }
    if (terms_.head(a.term) != terms_.head(b.term)) return false;
    const auto left = terms_.arguments(a.term);
    const auto right = terms_.arguments(b.term);
    for (std::size_t i = left.size(); i > 0; --i) {
      pairs_.push_back({{left[i - 1], a.bank}, {right[i - 1], b.bank}});
    }
  }
  return true;
}

TermId Substitution::Rename(Item variable) {
  const std::size_t place = Place(variable);
  if (place >= names_.size()) names_.resize(place + 1, kNoTerm);
  if (names_[place] == kNoTerm) {
    names_[place] = Terms::Variable(static_cast<std::uint32_t>(named_.size()));
    named_.push_back(place);
  }
  return names_[place];
}

TermId Substitution::ApplyReplacing(Item root, Item from, TermId to) {
  const bool in_ground = from.term != kNoTerm && terms_.is_ground(from.term);
  const auto enter = [&](Item& item) {
    if (item == from) return to;
    item = Resolve(item);
    if (item == from) return to;
    if (Terms::IsVariable(item.term)) return Rename(item);
    return terms_.is_ground(item.term) && !in_ground ? item.term : kNoTerm;
  };
  const TermId built = rebuilder_.Build(root, enter);
  overflowed_ = overflowed_ || built == kNoTerm;
  return built;
}

bool Matcher::Match(TermId pattern, TermId target) {
  pairs_.assign(1, {pattern, target});
  while (!pairs_.empty()) {
    const auto [p, t] = pairs_.back();
    pairs_.pop_back();
    if (Terms::IsVariable(p)) {
      const std::uint32_t number = Terms::Number(p);
      if (number >= bindings_.size()) bindings_.resize(number + 1, kNoTerm);
      if (bindings_[number] == kNoTerm) {
        Bind(number, t);
      } else if (bindings_[number] != t) {
        return false;
      }
      continue;
    }
    if (terms_.is_ground(p)) {
      if (p != t) return false;
      continue;
    }
    if (Terms::IsVariable(t) || terms_.head(p) != terms_.head(t) ||
        terms_.size(p) > terms_.size(t)) {
      return false;
    }
    const auto left = terms_.arguments(p);
    const auto right = terms_.arguments(t);
    for (std::size_t i = left.size(); i > 0; --i) pairs_.emplace_back(left[i - 1], right[i - 1]);
  }
  return true;
}

void Matcher::Bind(std::uint32_t variable, TermId value) {
  if (variable >= bindings_.size()) bindings_.resize(variable + 1, kNoTerm);
  bindings_[variable] = value;
  trail_.push_back(variable);
}

void Matcher::Undo(std::size_t mark) {
  while (trail_.size() > mark) {
    bindings_[trail_.back()] = kNoTerm;
    trail_.pop_back();
  }
}

TermId Matcher::Apply(TermId pattern) {
  return rebuilder_.Build({pattern, 0}, [&](Item& item) {
    if (Terms::IsVariable(item.term)) {
      const std::uint32_t number = Terms::Number(item.term);
      const bool bound = number < bindings_.size() && bindings_[number] != kNoTerm;
      return bound ? bindings_[number] : item.term;
    }
    return terms_.is_ground(item.term) ? item.term : kNoTerm;
  });
}

bool Matcher::IsRenaming() const {
  for (std::size_t i = 0; i < trail_.size(); ++i) {
    const TermId value = bindings_[trail_[i]];
    if (!Terms::IsVariable(value)) return false;
    const auto earlier = trail_.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::any_of(trail_.begin(), earlier, [&](auto v) { return bindings_[v] == value; })) {
      return false;
    }
  }
  return true;
}

}  // namespace latchwork::pttp::saturation

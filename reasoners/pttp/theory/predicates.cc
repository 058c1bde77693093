// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/theory/predicates.h"

namespace latchwork::pttp {

PredicateId Predicates::Number(const logic::PredicateName& name) {
  const std::uint64_t key = (std::uint64_t{name.symbol.index()} << 24U) ^ name.arity;
  const auto [entry, added] = numbers_.try_emplace(key, static_cast<PredicateId>(infos_.size()));
  if (!added) return entry->second;
  Info info;
  info.name = name;
  if (name.symbol == equality_ && name.arity == 2) {
    info.kind = PredicateKind::kEquality;
  } else if (const auto found = arithmetic_->FindPredicate(name.symbol, name.arity)) {
    info.kind = PredicateKind::kArithmetic;
    info.arithmetic = *found;
  }
  infos_.push_back(info);
  return entry->second;
}

PredicateId Predicates::AddHidden(const logic::PredicateName& name) {
  Info info;
  info.name = name;
  info.has_facts = true;
  infos_.push_back(info);
  return static_cast<PredicateId>(infos_.size() - 1);
}

}  // namespace latchwork::pttp

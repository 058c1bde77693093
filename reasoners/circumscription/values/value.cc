// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/values/value.h"

#include <algorithm>

namespace latchwork::circumscription {

using logic::Term;

std::uint64_t HashOf(std::span<const Value> values) {
  std::uint64_t hash = values.size();
  for (const Value& value : values) hash = Mix(hash, value);
  return hash;
}

void RowTable::Clear() {
  if (used_ == 0) return;
  std::fill(slots_.begin(), slots_.end(), Slot());
  used_ = 0;
}

void RowTable::Put(const Slot& slot) {
  std::size_t i = slot.hash & mask();
  while (slots_[i].row != kNone) i = (i + 1) & mask();
  slots_[i] = slot;
}

void RowTable::Insert(std::uint64_t hash, std::uint32_t row) {
  if (2 * (used_ + 1) > slots_.size()) {
    std::vector<Slot> old(std::max<std::size_t>(16, 2 * slots_.size()));
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.row != kNone) Put(slot);
    }
  }
  Put({hash, row});
  ++used_;
}

Value ValueBank::OfReal(double real) {
  return {std::bit_cast<std::uint64_t>(real == 0.0 ? 0.0 : real), Value::Kind::kReal};
}

Value ValueBank::Of(const Term& term) {
  switch (term.kind()) {
    case Term::Kind::kInteger:
      return {std::bit_cast<std::uint64_t>(term.integer()), Value::Kind::kInteger};
    case Term::Kind::kReal:
      return OfReal(term.real());
    case Term::Kind::kCompound:
      break;
    default:
      return OfConstant(term.symbol());
  }
  std::vector<Value> arguments;
  for (const Term& argument : term.arguments()) arguments.push_back(Of(argument));
  return Compound(term.symbol(), arguments);
}

Value ValueBank::Compound(logic::Symbol function, std::span<const Value> arguments) {
  const std::uint64_t hash = Mix(HashOf(arguments), std::bit_cast<std::uint64_t>(function));
  const std::uint32_t known = table_.Find(hash, [&](std::uint32_t row) {
    const Record& record = compounds_[row];
    return record.function == function && record.count == arguments.size() &&
           std::equal(arguments.begin(), arguments.end(),
                      arguments_.begin() + static_cast<std::ptrdiff_t>(record.first));
  });
  if (known != RowTable::kNone) return {known, Value::Kind::kCompound};
  scratch_.assign(arguments.begin(), arguments.end());
  std::vector<Term> terms;
  for (const Value& argument : scratch_) terms.push_back(ToTerm(argument));
  const auto row = static_cast<std::uint32_t>(compounds_.size());
  compounds_.push_back(
      {function, arguments_.size(), scratch_.size(), Term::Compound(function, std::move(terms))});
  arguments_.insert(arguments_.end(), scratch_.begin(), scratch_.end());
  table_.Insert(hash, row);
  return {row, Value::Kind::kCompound};
}

Term ValueBank::ToTerm(const Value& value) const {
  switch (value.kind) {
    case Value::Kind::kInteger:
      return Term::Integer(std::bit_cast<std::int64_t>(value.bits));
    case Value::Kind::kReal:
      return Term::Real(std::bit_cast<double>(value.bits));
    case Value::Kind::kConstant:
      return Term::Constant(std::bit_cast<logic::Symbol>(value.bits));
    case Value::Kind::kCompound:
      break;
  }
  return compounds_[value.bits].term;
}

std::span<const Value> ValueBank::Arguments(const Value& compound) const {
  const Record& record = compounds_[compound.bits];
  return {arguments_.data() + record.first, record.count};
}

void ValueBank::Clear() {
  compounds_.clear();
  arguments_.clear();
  table_.Clear();
}

}  // namespace latchwork::circumscription

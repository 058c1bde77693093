// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/machine/fact_store.h"

#include <algorithm>
#include <utility>

namespace latchwork::icarus {

/// A fact with memory of its own, which it keeps when it is used again.
struct FactStore::Record : Fact {
  Arena arena{256};
};

FactStore::FactStore() : table_(64, nullptr) {}
FactStore::~FactStore() = default;

NameId FactStore::HeadOf(const Value& list) {
  const auto items = list.list->items();
  return !items.empty() && items[0].kind == ValueKind::kSymbol ? items[0].name : kNoName;
}

FactStore::Bucket* FactStore::FindBucket(NameId head, std::size_t length) const {
  const std::size_t mask = table_.size() - 1;
  std::size_t at = (head * 0x9e3779b1U + length * 0x85ebca6bU) & mask;
  while (table_[at] != nullptr) {
    if (table_[at]->head == head && table_[at]->length == length) return table_[at];
    at = (at + 1) & mask;
  }
  return nullptr;
}

void FactStore::Grow() {
  table_.assign(table_.size() * 2, nullptr);
  const std::size_t mask = table_.size() - 1;
  for (const auto& bucket : buckets_) {
    std::size_t at = (bucket->head * 0x9e3779b1U + bucket->length * 0x85ebca6bU) & mask;
    while (table_[at] != nullptr) at = (at + 1) & mask;
    table_[at] = bucket.get();
  }
}

FactStore::Bucket& FactStore::BucketOf(const Value& list) {
  const NameId head = HeadOf(list);
  const std::uint32_t length = list.list->size;
  if (Bucket* const known = FindBucket(head, length)) return *known;
  if (buckets_.size() * 2 >= table_.size()) Grow();
  auto made = std::make_unique<Bucket>();
  made->head = head;
  made->length = length;
  const std::size_t mask = table_.size() - 1;
  std::size_t at = (head * 0x9e3779b1U + length * 0x85ebca6bU) & mask;
  while (table_[at] != nullptr) at = (at + 1) & mask;
  table_[at] = made.get();
  buckets_.push_back(std::move(made));
  return *buckets_.back();
}

const FactStore::Fact* FactStore::First(NameId head, std::size_t length) const {
  const Bucket* const bucket = FindBucket(head, length);
  return bucket == nullptr ? nullptr : bucket->first;
}

FactStore::Fact* FactStore::Find(const Value& list) const {
  const Bucket* const bucket = FindBucket(HeadOf(list), list.list->size);
  Fact* fact = bucket == nullptr ? nullptr : bucket->first;
  while (fact != nullptr && (fact->died != 0 || !Equal(fact->value, list))) {
    fact = fact->next_in_bucket;
  }
  return fact;
}

FactStore::Fact* FactStore::NewFact(const Value& list, std::uint64_t order) {
  if (free_.empty()) {
    records_.push_back(std::make_unique<Record>());
    free_.reserve(records_.size());
    free_.push_back(records_.back().get());
  }
  Record& record = *free_.back();
  free_.pop_back();
  record.arena.Reset();
  static_cast<Fact&>(record) = Fact();
  record.value = record.arena.Copy(list);
  record.born = ++version_;
  record.order = order;
  ++size_;
  return &record;
}

void FactStore::Link(Fact* fact, Fact* after) {
  Fact*& link = after == nullptr ? first_ : after->next;
  fact->next = link;
  link = fact;
  if (last_ == after) last_ = fact;
}

/// Behind all facts of the same or a lower order.
void FactStore::LinkInBucket(Bucket& bucket, Fact* fact) {
  Fact* after = bucket.last;
  if (after != nullptr && after->order > fact->order) {
    after = nullptr;
    for (Fact* f = bucket.first; f->order <= fact->order; f = f->next_in_bucket) after = f;
  }
  Fact*& link = after == nullptr ? bucket.first : after->next_in_bucket;
  fact->next_in_bucket = link;
  link = fact;
  if (bucket.last == after) bucket.last = fact;
}

bool FactStore::Store(const Value& list) {
  if (Fact* const known = Find(list)) return known->stored = true;
  if (size_ >= kMostFacts) return false;
  Bucket& bucket = BucketOf(list);
  Fact* const fact = NewFact(list, next_order_++);
  fact->stored = true;
  Link(fact, last_);
  LinkInBucket(bucket, fact);
  return true;
}

void FactStore::Remove(const Fact* fact) {
  if (fact->died != 0) return;
  const_cast<Fact*>(fact)->died = ++version_;
  const_cast<Fact*>(fact)->stored = false;
  --size_;
  ++dead_;
}

void FactStore::Replace(const Fact* fact, const Value& list) {
  if (Equal(fact->value, list)) return;
  Remove(fact);
  if (Fact* const known = Find(list)) {
    known->stored = true;
    return;
  }
  Bucket& bucket = BucketOf(list);
  Fact* const fresh = NewFact(list, fact->order);
  fresh->stored = true;
  Link(fresh, const_cast<Fact*>(fact));
  LinkInBucket(bucket, fresh);
}

void FactStore::Tidy() {
  if (dead_ == 0) return;
  for (const auto& bucket : buckets_) bucket->first = bucket->last = nullptr;
  Fact* fact = first_;
  first_ = last_ = nullptr;
  while (fact != nullptr) {
    Fact* const next = fact->next;
    fact->next = fact->next_in_bucket = nullptr;
    if (fact->died != 0 && fact->holders > 0) {
      fact->died = 0;
      fact->born = ++version_;
      ++size_;
    }
    if (fact->died == 0) {
      Link(fact, last_);
      LinkInBucket(BucketOf(fact->value), fact);
    } else {
      free_.push_back(static_cast<Record*>(fact));
    }
    fact = next;
  }
  dead_ = 0;
}

std::uint64_t FactStore::OpenPlace() {
  constexpr unsigned kBits = 32;
  const std::uint64_t place = ((next_order_ >> kBits) + 1) << kBits;
  next_order_ = place + (std::uint64_t{1} << kBits);
  return place;
}

FactStore::Fact* FactStore::LastBefore(std::uint64_t order) const {
  Fact* last = nullptr;
  for (Fact* fact = first_; fact != nullptr && fact->order < order; fact = fact->next) last = fact;
  return last;
}

const FactStore::Fact* FactStore::Hold(const Value& list, std::uint64_t place, const Fact* after) {
  Fact* fact = Find(list);
  if (fact == nullptr) {
    if (size_ >= kMostFacts) return nullptr;
    Bucket& bucket = BucketOf(list);
    fact = NewFact(list, place);
    Link(fact, after == nullptr ? LastBefore(place) : const_cast<Fact*>(after));
    LinkInBucket(bucket, fact);
  }
  ++fact->holders;
  return fact;
}

void FactStore::Release(const Fact* fact) {
  if (--const_cast<Fact*>(fact)->holders == 0 && !fact->stored) Remove(fact);
}

void FactStore::CopyFrom(const FactStore& other) {
  for (const Fact* fact = other.first_; fact != nullptr; fact = fact->next) {
    if (fact->died != 0 && fact->holders == 0) continue;
    Fact* const copy = NewFact(fact->value, fact->order);
    copy->stored = true;
    Link(copy, last_);
    LinkInBucket(BucketOf(copy->value), copy);
  }
  next_order_ = other.next_order_;
}

void FactStore::Swap(FactStore& other) {
  std::swap(buckets_, other.buckets_);
  std::swap(table_, other.table_);
  std::swap(records_, other.records_);
  std::swap(free_, other.free_);
  std::swap(first_, other.first_);
  std::swap(last_, other.last_);
  std::swap(size_, other.size_);
  std::swap(dead_, other.dead_);
  std::swap(version_, other.version_);
  std::swap(next_order_, other.next_order_);
}

}  // namespace latchwork::icarus

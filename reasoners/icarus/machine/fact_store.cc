// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/machine/fact_store.h"

#include <utility>

namespace latchwork::icarus {

namespace {

constexpr std::size_t kHeads = 0;  ///< In Fact::next_alike.
constexpr std::size_t kSeconds = 1;

}  // namespace

/// A fact with memory of its own, which it keeps when it is used again.
struct FactStore::Record : Fact {
  Arena arena{256};
  Fact* previous = nullptr;
  std::array<Bucket*, 2> buckets = {};
};

FactStore::FactStore() : table_(64, nullptr) {}
FactStore::~FactStore() = default;

FactStore::Key FactStore::HeadKey(const Value& list) {
  const auto items = list.list->items();
  const bool named = !items.empty() && items[0].kind == ValueKind::kSymbol;
  return {named ? items[0].name : kNoName, list.list->size, 0};
}

FactStore::Key FactStore::SecondKey(NameId head, std::size_t length, const Value& second) {
  return {head, static_cast<std::uint32_t>(length), Hash(second) | 1U};
}

/// That of the head where there is no second item.
FactStore::Key FactStore::SecondKey(const Value& list) {
  const Key key = HeadKey(list);
  return key.length < 2 ? key : SecondKey(key.head, key.length, list.list->items()[1]);
}

std::size_t FactStore::PlaceOf(const Key& key) const {
  std::uint64_t hash = key.second ^ (key.head * 0x9e3779b97f4a7c15ULL + key.length);
  hash = (hash ^ (hash >> 32U)) * 0xd6e8feb86659fd93ULL;
  return (hash >> 32U) & (table_.size() - 1);
}

FactStore::Bucket* FactStore::FindBucket(const Key& key) const {
  Bucket* bucket = table_[PlaceOf(key)];
  while (bucket != nullptr && !(bucket->key == key)) bucket = bucket->next;
  return bucket;
}

void FactStore::Grow() {
  std::vector<Bucket*> old(table_.size() * 2, nullptr);
  old.swap(table_);
  for (Bucket* bucket : old) {
    while (bucket != nullptr) {
      Bucket*& place = table_[PlaceOf(bucket->key)];
      bucket = std::exchange(bucket->next, std::exchange(place, bucket));
    }
  }
}

FactStore::Bucket& FactStore::BucketOf(const Key& key) {
  if (Bucket* const known = FindBucket(key)) return *known;
  if (++used_buckets_ > table_.size()) Grow();
  if (free_buckets_ == nullptr) {
    buckets_.push_back(std::make_unique<Bucket>());
    free_buckets_ = buckets_.back().get();
  }
  Bucket& bucket = *free_buckets_;
  free_buckets_ = bucket.next;
  bucket = Bucket();
  bucket.key = key;
  Bucket*& place = table_[PlaceOf(key)];
  bucket.next = std::exchange(place, &bucket);
  return bucket;
}

/// An empty bucket goes out of the table.
void FactStore::Drop(Bucket& bucket) {
  Bucket** link = &table_[PlaceOf(bucket.key)];
  while (*link != &bucket) link = &(*link)->next;
  *link = bucket.next;
  bucket.next = std::exchange(free_buckets_, &bucket);
  --used_buckets_;
}

const FactStore::Fact* FactStore::First(NameId head, std::size_t length) const {
  const Bucket* const bucket = FindBucket({head, static_cast<std::uint32_t>(length), 0});
  return bucket == nullptr ? nullptr : bucket->first;
}

const FactStore::Fact* FactStore::First(NameId head, std::size_t length,
                                        const Value& second) const {
  const Bucket* const bucket = FindBucket(SecondKey(head, length, second));
  return bucket == nullptr ? nullptr : bucket->first;
}

FactStore::Fact* FactStore::Find(const Value& list) const {
  const Key key = SecondKey(list);
  const std::size_t chain = key.second == 0 ? kHeads : kSeconds;
  const Bucket* const bucket = FindBucket(key);
  Fact* fact = bucket == nullptr ? nullptr : bucket->first;
  while (fact != nullptr && (fact->died != 0 || !Equal(fact->value, list))) {
    fact = fact->next_alike[chain];
  }
  return fact;
}

/// A fact in its places: behind `after`, at the start when that is null.
FactStore::Record* FactStore::NewFact(const Value& list, std::uint64_t order, Fact* after) {
  if (free_.empty()) {
    records_.push_back(std::make_unique<Record>());
    free_.reserve(records_.size());
    dead_.reserve(records_.size());
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
  record.previous = after;
  Fact*& link = after == nullptr ? first_ : after->next;
  record.next = link;
  link = &record;
  if (record.next != nullptr) {
    static_cast<Record*>(record.next)->previous = &record;
  } else {
    last_ = &record;
  }
  const Key second = SecondKey(record.value);
  record.buckets[kHeads] = &BucketOf(HeadKey(record.value));
  record.buckets[kSeconds] = second.second == 0 ? nullptr : &BucketOf(second);
  for (const std::size_t chain : {kHeads, kSeconds}) {
    if (record.buckets[chain] != nullptr) LinkInBucket(*record.buckets[chain], chain, &record);
  }
  return &record;
}

/// Behind all facts of the same or a lower order.
void FactStore::LinkInBucket(Bucket& bucket, std::size_t chain, Fact* fact) {
  Fact* after = bucket.last;
  if (after != nullptr && after->order > fact->order) {
    after = nullptr;
    for (Fact* f = bucket.first; f->order <= fact->order; f = f->next_alike[chain]) after = f;
  }
  Fact*& link = after == nullptr ? bucket.first : after->next_alike[chain];
  fact->next_alike[chain] = link;
  link = fact;
  if (bucket.last == after) bucket.last = fact;
}

bool FactStore::Store(const Value& list) {
  if (Fact* const known = Find(list)) return known->stored = true;
  if (size_ >= kMostFacts) return false;
  NewFact(list, next_order_++, last_)->stored = true;
  return true;
}

void FactStore::Remove(const Fact* fact) {
  if (fact->died == 0) Kill(static_cast<Record*>(const_cast<Fact*>(fact)));
}

void FactStore::Kill(Record* record) {
  record->died = ++version_;
  record->stored = false;
  --size_;
  dead_.push_back(record);
}

void FactStore::Replace(const Fact* fact, const Value& list) {
  if (Equal(fact->value, list)) return;
  Remove(fact);
  if (Fact* const known = Find(list)) {
    known->stored = true;
  } else {
    NewFact(list, fact->order, const_cast<Fact*>(fact))->stored = true;
  }
}

void FactStore::Unlink(Record* record) {
  (record->previous == nullptr ? first_ : record->previous->next) = record->next;
  if (record->next == nullptr) {
    last_ = record->previous;
  } else {
    static_cast<Record*>(record->next)->previous = record->previous;
  }
  for (Bucket* const bucket : record->buckets) {
    if (bucket != nullptr) bucket->dirty = true;
  }
}

/// Takes the dead out of a bucket.
void FactStore::Clean(Bucket& bucket, std::size_t chain) {
  bucket.dirty = false;
  bucket.last = nullptr;
  Fact** link = &bucket.first;
  while (*link != nullptr) {
    if ((*link)->died == 0) {
      bucket.last = *link;
      link = &(*link)->next_alike[chain];
    } else {
      *link = (*link)->next_alike[chain];
    }
  }
  if (bucket.first == nullptr) Drop(bucket);
}

void FactStore::Tidy() {
  for (Record* const record : dead_) {
    if (record->holders > 0) {
      record->died = 0;
      record->born = ++version_;
      ++size_;
    } else {
      Unlink(record);
    }
  }
  for (Record* const record : dead_) {
    if (record->died == 0) continue;
    for (const std::size_t chain : {kHeads, kSeconds}) {
      Bucket* const bucket = record->buckets[chain];
      if (bucket != nullptr && bucket->dirty) Clean(*bucket, chain);
    }
    free_.push_back(record);
  }
  dead_.clear();
}

std::uint64_t FactStore::OpenPlace() {
  constexpr unsigned kBits = 32;
  const std::uint64_t place = ((next_order_ >> kBits) + 1) << kBits;
  next_order_ = place + (std::uint64_t{1} << kBits);
  return place;
}

void FactStore::Forget(const Value& pattern) {
  if (IsGround(pattern)) {
    if (const Fact* const fact = Find(pattern)) Remove(fact);
    return;
  }
  for (const Fact* fact = first_; fact != nullptr; fact = fact->next) {
    if (fact->died == 0 && Fits(pattern, fact->value)) Remove(fact);
  }
}

bool FactStore::Update(const Value& pattern, const Value& list) {
  if (IsGround(pattern)) {
    const Fact* const fact = Find(pattern);
    if (fact == nullptr) return Store(list);
    Replace(fact, list);
    return true;
  }
  bool placed = false;
  for (const Fact* fact = first_; fact != nullptr; fact = fact->next) {
    if (fact->died != 0 || !Fits(pattern, fact->value)) continue;
    if (!placed) {
      Replace(fact, list);
    } else if (!Equal(fact->value, list)) {
      Remove(fact);
    }
    placed = true;
  }
  return placed || Store(list);
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
    fact = NewFact(list, place, after == nullptr ? LastBefore(place) : const_cast<Fact*>(after));
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
    NewFact(fact->value, fact->order, last_)->stored = true;
  }
  next_order_ = other.next_order_;
}

void FactStore::Swap(FactStore& other) {
  std::swap(buckets_, other.buckets_);
  std::swap(table_, other.table_);
  std::swap(used_buckets_, other.used_buckets_);
  std::swap(free_buckets_, other.free_buckets_);
  std::swap(records_, other.records_);
  std::swap(free_, other.free_);
  std::swap(dead_, other.dead_);
  std::swap(first_, other.first_);
  std::swap(last_, other.last_);
  std::swap(size_, other.size_);
  std::swap(version_, other.version_);
  std::swap(next_order_, other.next_order_);
}

}  // namespace latchwork::icarus

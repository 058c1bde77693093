// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_FACT_STORE_H_
#define LATCHWORK_ICARUS_FACT_STORE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "reasoners/icarus/machine/value.h"

namespace latchwork::icarus {

/// Short-term memory: an ordered list of ground lists, indexed by head and length, and by the item
/// after the head. What is written
/// is visible at once, but an enumeration sees memory as it was when it began. Facts taken out stay
/// readable until Tidy. Besides what is stored, a host may hold facts: they are in memory as long
/// as somebody holds them. Uses memory again; allocates while it grows.
class FactStore {
 public:
  using Version = std::uint64_t;

  struct Fact {
    Value value;
    Version born = 0;
    Version died = 0;  ///< 0: in memory.
    std::uint64_t order = 0;
    std::uint32_t holders = 0;
    bool stored = false;
    Fact* next = nullptr;  ///< In the order of memory.
    /// Of the same head and length; of those that may have the same second item.
    std::array<Fact*, 2> next_alike = {};

    bool VisibleAt(Version version) const {
      return born <= version && (died == 0 || died > version);
    }
  };

  /// Facts that memory may hold.
  static constexpr std::size_t kMostFacts = 1U << 20U;

  FactStore();
  ~FactStore();
  FactStore(const FactStore&) = delete;
  FactStore& operator=(const FactStore&) = delete;

  Version version() const { return version_; }
  std::size_t size() const { return size_; }

  /// Which facts an enumeration goes through: all, those of one head and length, or of these, too,
  /// those of one second item.
  enum class Chain : std::uint8_t { kAll, kHead, kSecond };
  static const Fact* Next(const Fact* fact, Chain chain) {
    return chain == Chain::kAll ? fact->next : fact->next_alike[chain == Chain::kHead ? 0 : 1];
  }
  /// The first fact that may match a list of this head, a symbol, and length.
  const Fact* First(NameId head, std::size_t length) const;
  /// The first of those that may have this second item.
  const Fact* First(NameId head, std::size_t length, const Value& second) const;
  /// The first fact of all.
  const Fact* First() const { return first_; }

  /// Appends the list unless it is there. False: memory is full.
  bool Store(const Value& list);
  /// Takes a fact out.
  void Remove(const Fact* fact);
  /// Puts the list where `fact` was; nothing when it is there elsewhere already.
  void Replace(const Fact* fact, const Value& list);
  /// Takes out all facts that fit the pattern.
  void Forget(const Value& pattern);
  /// Puts the list where the first fact that fits the pattern stands, and takes out the others that
  /// do; appends it when none does. False: memory is full.
  bool Update(const Value& pattern, const Value& list);
  /// The fact that is this list; null when it is not in memory.
  Fact* Find(const Value& list) const;
  bool Holds(const Value& list) const { return Find(list) != nullptr; }
  /// Forgets for good what was taken out, but puts back what is held. No enumeration may be under
  /// way.
  void Tidy();

  /// A place in the order of memory, behind all that is there now, for 2^32 facts in the order of
  /// their numbers `place + i`.
  std::uint64_t OpenPlace();
  /// Has the list in memory until it is released; at this place, unless it is there already.
  /// `after`: the fact before that place, null when not known. Null: memory is full.
  const Fact* Hold(const Value& list, std::uint64_t place, const Fact* after);
  void Release(const Fact* fact);
  /// Stores the facts of another as its Tidy would leave them.
  void CopyFrom(const FactStore& other);
  /// Exchanges all they have; facts keep their addresses.
  void Swap(FactStore& other);

 private:
  struct Key {
    NameId head = kNoName;
    std::uint32_t length = 0;
    std::uint64_t second = 0;  ///< Hash of the second item; 0: whatever it is.
    friend bool operator==(const Key&, const Key&) = default;
  };
  /// The facts of one key, in the order of memory.
  struct Bucket {
    Key key;
    Fact* first = nullptr;
    Fact* last = nullptr;
    Bucket* next = nullptr;  ///< At the same place of the table, or free.
    bool dirty = false;      ///< Facts of it were taken out.
  };
  struct Record;

  static Key HeadKey(const Value& list);
  static Key SecondKey(const Value& list);
  static Key SecondKey(NameId head, std::size_t length, const Value& second);
  Fact* LastBefore(std::uint64_t order) const;
  std::size_t PlaceOf(const Key& key) const;
  Bucket* FindBucket(const Key& key) const;
  Bucket& BucketOf(const Key& key);
  void Grow();
  void Drop(Bucket& bucket);
  Record* NewFact(const Value& list, std::uint64_t order, Fact* after);
  void Unlink(Record* record);
  void Clean(Bucket& bucket, std::size_t chain);
  static void LinkInBucket(Bucket& bucket, std::size_t chain, Fact* fact);
  void Kill(Record* record);

  std::vector<std::unique_ptr<Bucket>> buckets_;
  std::vector<Bucket*> table_;  ///< Buckets by their keys; a power of two.
  std::size_t used_buckets_ = 0;
  Bucket* free_buckets_ = nullptr;
  std::vector<std::unique_ptr<Record>> records_;
  std::vector<Record*> free_;
  std::vector<Record*> dead_;
  Fact* first_ = nullptr;
  Fact* last_ = nullptr;
  std::size_t size_ = 0;
  Version version_ = 1;
  std::uint64_t next_order_ = 1;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_FACT_STORE_H_

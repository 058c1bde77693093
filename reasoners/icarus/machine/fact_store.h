// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_FACT_STORE_H_
#define LATCHWORK_ICARUS_FACT_STORE_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "reasoners/icarus/machine/value.h"

namespace latchwork::icarus {

/// Short-term memory: an ordered list of ground lists, indexed by head and length. What is written
/// is visible at once, but an enumeration sees memory as it was when it began. Facts taken out stay
/// readable until Tidy. Uses memory again; allocates while it grows.
class FactStore {
 public:
  using Version = std::uint64_t;

  struct Fact {
    Value value;
    Version born = 0;
    Version died = 0;  ///< 0: in memory.
    std::uint64_t order = 0;
    Fact* next = nullptr;            ///< In the order of memory.
    Fact* next_in_bucket = nullptr;  ///< Of the same head and length.

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

  /// The first fact that may match a list of this head, a symbol, and length.
  const Fact* First(NameId head, std::size_t length) const;
  /// The first fact of all.
  const Fact* First() const { return first_; }

  /// Appends the list unless it is there. False: memory is full.
  bool Store(const Value& list);
  /// Takes a fact out.
  void Remove(const Fact* fact);
  /// Puts the list where `fact` was; nothing when it is there elsewhere already.
  void Replace(const Fact* fact, const Value& list);
  bool Holds(const Value& list) const;
  /// Forgets for good what was taken out. No enumeration may be under way.
  void Tidy();

 private:
  struct Bucket {
    NameId head = kNoName;
    std::uint32_t length = 0;
    Fact* first = nullptr;
    Fact* last = nullptr;
  };
  struct Record;

  static NameId HeadOf(const Value& list);
  Bucket* FindBucket(NameId head, std::size_t length) const;
  Bucket& BucketOf(const Value& list);
  void Grow();
  Fact* NewFact(const Value& list, std::uint64_t order);
  void Link(Fact* fact, Fact* after);
  static void LinkInBucket(Bucket& bucket, Fact* fact);

  std::vector<std::unique_ptr<Bucket>> buckets_;
  std::vector<Bucket*> table_;  ///< Open addressing by head and length; a power of two.
  std::vector<std::unique_ptr<Record>> records_;
  std::vector<Record*> free_;
  Fact* first_ = nullptr;
  Fact* last_ = nullptr;
  std::size_t size_ = 0;
  std::size_t dead_ = 0;
  Version version_ = 1;
  std::uint64_t next_order_ = 1;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_FACT_STORE_H_

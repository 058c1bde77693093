// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_FACTS_H_
#define LATCHWORK_PTTP_FACTS_H_

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "latchwork/logic/atom.h"
#include "reasoners/pttp/arena.h"
#include "reasoners/pttp/functors.h"
#include "reasoners/pttp/predicates.h"
#include "reasoners/pttp/word.h"

namespace latchwork::pttp {

inline constexpr std::uint32_t kNoRow = 0xffffffffU;

/// The facts of one predicate from one source. Rows keep the order of the source. Every argument
/// position has a hash index, made when it is first asked for.
class FactTable {
 public:
  explicit FactTable(std::size_t arity) : arity_(arity), columns_(arity) {}

  void Clear();
  Word* AddRow();
  std::uint32_t rows() const { return rows_; }
  const Word* row(std::uint32_t index) const { return cells_.data() + std::size_t{index} * arity_; }

  /// A way through the rows that may match a goal.
  struct Cursor {
    const FactTable* table = nullptr;
    std::uint32_t row = kNoRow;
    std::uint32_t column = kNoRow;  ///< The index that is followed; kNoRow: row by row.
  };
  Cursor Find(const Word* goal);
  static void Advance(Cursor& cursor);

 private:
  static constexpr std::uint32_t kSmall = 8;
  struct Column {
    bool built = false;
    std::vector<std::uint32_t> first;  ///< By hash.
    std::vector<std::uint32_t> next;   ///< By row.
  };
  void Build(std::size_t index);

  std::size_t arity_;
  std::uint32_t rows_ = 0;
  std::vector<Word> cells_;
  std::vector<Column> columns_;
};

/// The facts of one source: the body, or a latch.
class FactSource {
 public:
  FactSource(std::string name, std::size_t order) : name_(std::move(name)), order_(order) {}

  const std::string& name() const { return name_; }
  bool enabled = true;
  bool is_latch = false;
  std::uint64_t version = 0;
  bool loaded = false;

 private:
  friend class FactStore;
  std::string name_;
  std::size_t order_;
  Arena terms_;
  std::vector<std::pair<PredicateId, std::unique_ptr<FactTable>>> tables_;
};

/// All facts that the engine may use, by predicate and source.
class FactStore {
 public:
  FactStore(Predicates& predicates, Functors& functors)
      : predicates_(&predicates), functors_(&functors) {}

  FactSource& AddSource(std::string name);
  std::size_t sources() const { return sources_.size(); }
  FactSource& source(std::size_t index) { return *sources_[index]; }

  void Clear(FactSource& source);
  /// Adds a fact; true when its predicate had no facts before in any source (what is reachable may
  /// have changed).
  bool Add(FactSource& source, const logic::Fact& fact);

  struct Entry {
    FactSource* source;
    FactTable* table;
  };
  std::span<const Entry> Tables(PredicateId predicate) const {
    if (predicate >= by_predicate_.size()) return {};
    return by_predicate_[predicate];
  }

 private:
  FactTable& TableOf(FactSource& source, PredicateId predicate, std::size_t arity);

  Predicates* predicates_;
  Functors* functors_;
  std::vector<std::unique_ptr<FactSource>> sources_;
  std::vector<std::vector<Entry>> by_predicate_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_FACTS_H_

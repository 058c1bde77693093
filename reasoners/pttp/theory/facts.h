// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_FACTS_H_
#define LATCHWORK_PTTP_FACTS_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/logic/atom.h"
#include "reasoners/pttp/terms/arena.h"
#include "reasoners/pttp/terms/functors.h"
#include "reasoners/pttp/terms/word.h"
#include "reasoners/pttp/theory/predicates.h"

namespace latchwork::pttp {

inline constexpr std::uint32_t kNoRow = 0xffffffffU;

/// The facts of one predicate from one source. Rows keep the order of the source. Every argument
/// position has a hash index, made when it is first asked for.
class FactTable {
 public:
  explicit FactTable(std::size_t arity) : arity_(arity), columns_(arity) {}

  void Clear();
  Word* AddRow();

  /// A batch takes the place of the rows: BeginBatch, SetRow for each fact, EndBatch. Numbers are
  /// written where those of the batch before stood, and an index outlives a batch that leaves its
  /// column as it was.
  void BeginBatch() {
    filled_ = 0;
    changed_ = false;
  }
  /// How many terms in `terms` are of no use any more.
  std::size_t SetRow(const logic::Fact& fact, Functors& functors, Arena& terms);
  /// True when the batch differs from the one before.
  bool EndBatch();
  std::size_t arity() const { return arity_; }
  std::uint32_t rows() const { return rows_; }
  const Word* row(std::uint32_t index) const { return cells_.data() + std::size_t{index} * arity_; }

  /// A way through the rows that may match a goal.
  struct Cursor {
    const FactTable* table = nullptr;
    std::uint32_t row = kNoRow;
    const std::uint32_t* next = nullptr;  ///< By row; null: row by row.
  };
  Cursor Find(const Word* goal);
  /// The same for one argument, which is ground.
  Cursor FindBy(std::size_t column, Word key);
  /// Whether no two rows have the same argument there. May say no where it is so.
  bool TellsRowsApart(std::size_t column);
  Cursor All() const { return {this, rows_ == 0 ? kNoRow : 0, nullptr}; }
  static void Advance(Cursor& cursor) {
    if (cursor.next != nullptr) {
      cursor.row = cursor.next[cursor.row];
    } else {
      cursor.row = cursor.row + 1 < cursor.table->rows_ ? cursor.row + 1 : kNoRow;
    }
  }

 private:
  static constexpr std::uint32_t kSmall = 8;
  struct Column {
    bool built = false;
    bool distinct = false;             ///< All hashes are.
    std::vector<std::uint32_t> first;  ///< By hash.
    std::vector<std::uint32_t> next;   ///< By row.
  };
  void Build(std::size_t index);
  void NoteChange(std::size_t column) {
    columns_[column].built = false;
    changed_ = true;
  }

  std::size_t arity_;
  std::uint32_t rows_ = 0;
  std::uint32_t filled_ = 0;
  bool changed_ = false;
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
  bool is_scratch = false;  ///< What it holds is gone before the next decision.
  std::uint64_t version = 0;
  bool loaded = false;

 private:
  friend class FactStore;
  struct Entry {
    logic::PredicateName name;
    PredicateId predicate;
    std::unique_ptr<FactTable> table;
  };
  std::string name_;
  std::size_t order_;
  Arena terms_;
  std::vector<Entry> tables_;
  std::size_t last_ = 0;     ///< The table used last.
  std::size_t garbage_ = 0;  ///< Terms that lie about in terms_.
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
  /// Makes these the facts of the source; true as with Add. Costs what differs from the facts
  /// before.
  bool Replace(FactSource& source, std::span<const logic::Fact> facts);

  /// A table of the source for rows that are no facts of anybody's.
  FactTable& AddHiddenTable(FactSource& source, PredicateId predicate);

  /// Counts changes of facts. What was found out at one time stands while no predicate that it
  /// rests on has changed since.
  std::uint64_t now() const { return now_; }
  bool ChangedSince(PredicateId predicate, std::uint64_t time) const {
    return predicate < changed_at_.size() && changed_at_[predicate] > time;
  }

  struct Entry {
    FactSource* source;
    FactTable* table;
  };
  std::span<const Entry> Tables(PredicateId predicate) const {
    if (predicate >= by_predicate_.size()) return {};
    return by_predicate_[predicate];
  }

 private:
  FactSource::Entry& EntryOf(FactSource& source, const logic::PredicateName& name);
  FactSource::Entry& AddTable(FactSource& source, const logic::PredicateName& name);
  FactTable& AddTable(FactSource& source, PredicateId predicate, const logic::PredicateName& name);
  bool NoteFacts(PredicateId predicate);
  void NoteChange(const FactSource& source, PredicateId predicate);

  Predicates* predicates_;
  Functors* functors_;
  std::vector<std::unique_ptr<FactSource>> sources_;
  std::vector<std::vector<Entry>> by_predicate_;
  std::uint64_t now_ = 0;
  std::vector<std::uint64_t> changed_at_;  ///< By predicate.
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_FACTS_H_

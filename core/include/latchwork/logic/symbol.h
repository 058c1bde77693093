// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_SYMBOL_H_
#define LATCHWORK_LOGIC_SYMBOL_H_

#include <compare>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace latchwork::logic {

/// What a name stands for when it is written down: `word` (lower or quoted word, `$word`), or a
/// "distinct object", which is unequal to every other distinct object by definition (TPTP).
enum class SymbolKind : unsigned char { kWord, kDistinctObject };

/// An interned name: a predicate, function or constant. A pointer to a record of the `SymbolTable`
/// that made it, so it copies and compares in one instruction and prints itself. Symbols are
/// ordered by name, never by address. A symbol must not outlive its table. A default-made symbol is
/// null. Arity is not part of a symbol: p/1 and p/2 share one.
class Symbol {
 public:
  constexpr Symbol() = default;

  std::string_view name() const { return record_ == nullptr ? std::string_view() : record_->name; }
  SymbolKind kind() const { return record_ == nullptr ? SymbolKind::kWord : record_->kind; }
  /// Dense index in the table in order of interning: an array index, never an order that a run may
  /// depend on.
  std::size_t index() const { return record_->index; }
  explicit operator bool() const { return record_ != nullptr; }

  friend bool operator==(Symbol a, Symbol b) { return a.record_ == b.record_; }
  friend std::strong_ordering operator<=>(Symbol a, Symbol b) {
    if (a.record_ == b.record_) return std::strong_ordering::equal;
    if (const auto by_name = a.name() <=> b.name(); std::is_neq(by_name)) return by_name;
    return a.kind() <=> b.kind();
  }

 private:
  friend class SymbolTable;
  struct Record {
    std::string name;
    SymbolKind kind;
    std::size_t index;
  };
  explicit Symbol(const Record* record) : record_(record) {}

  const Record* record_ = nullptr;
};

/// Owns the names of one run. All parts of one agent share one table. Thread rule: every member may
/// be called from any thread; symbols already made are read without a lock.
class SymbolTable {
 public:
  SymbolTable();
  ~SymbolTable();
  SymbolTable(const SymbolTable&) = delete;
  SymbolTable& operator=(const SymbolTable&) = delete;

  /// The symbol of this name and kind, made at its first use. `name` is the bare name: quotes are
  /// syntax.
  Symbol Intern(std::string_view name, SymbolKind kind = SymbolKind::kWord);
  /// A symbol whose name starts with `stem` and that no call of Intern or Fresh returned before
  /// (Skolem functions, definitions).
  Symbol Fresh(std::string_view stem);
  std::size_t size() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_SYMBOL_H_

// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/symbol.h"

#include <array>
#include <deque>
#include <mutex>
#include <shared_mutex>
#include <unordered_map>
#include <utility>

namespace latchwork::logic {

struct SymbolTable::Implementation {
  const Symbol::Record* Find(std::string_view name, SymbolKind kind) const {
    const auto& index = by_name[static_cast<std::size_t>(kind)];
    const auto found = index.find(name);
    return found == index.end() ? nullptr : found->second;
  }

  const Symbol::Record* Add(std::string name, SymbolKind kind) {
    records.push_back({std::move(name), kind, records.size()});
    const Symbol::Record& record = records.back();
    by_name[static_cast<std::size_t>(kind)].emplace(record.name, &record);
    return &record;
  }

  mutable std::shared_mutex mutex;
  std::deque<Symbol::Record> records;  // Never move, so symbols point at them.
  std::array<std::unordered_map<std::string_view, const Symbol::Record*>, 2> by_name;
  std::unordered_map<std::string, std::size_t> last_fresh;  // By stem.
};

SymbolTable::SymbolTable() : implementation_(std::make_unique<Implementation>()) {}
SymbolTable::~SymbolTable() = default;

Symbol SymbolTable::Intern(std::string_view name, SymbolKind kind) {
  {
    const std::shared_lock lock(implementation_->mutex);
    if (const auto* record = implementation_->Find(name, kind)) return Symbol(record);
  }
  const std::unique_lock lock(implementation_->mutex);
  if (const auto* record = implementation_->Find(name, kind)) return Symbol(record);
  return Symbol(implementation_->Add(std::string(name), kind));
}

Symbol SymbolTable::Fresh(std::string_view stem) {
  const std::unique_lock lock(implementation_->mutex);
  std::size_t& number = implementation_->last_fresh[std::string(stem)];
  while (true) {
    std::string name = std::string(stem) + std::to_string(++number);
    if (implementation_->Find(name, SymbolKind::kWord) == nullptr) {
      return Symbol(implementation_->Add(std::move(name), SymbolKind::kWord));
    }
  }
}

std::size_t SymbolTable::size() const {
  const std::shared_lock lock(implementation_->mutex);
  return implementation_->records.size();
}

}  // namespace latchwork::logic

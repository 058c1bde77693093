// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/body/term_bridge.h"

#include <cmath>
#include <string>
#include <utility>

#include "reasoners/icarus/language/source_tree.h"

namespace latchwork::icarus {

namespace {

using logic::Term;

constexpr std::size_t kPlaces = 4096;  ///< For lists that went out; a power of two.

}  // namespace

TermBridge::Spelling& TermBridge::SpellingOf(NameId name) {
  if (name >= spellings_.size()) spellings_.resize(name + 1);
  return spellings_[name];
}

NameId TermBridge::Import(logic::Symbol symbol) {
  const std::size_t index = symbol.index();
  if (index >= name_of_.size()) name_of_.resize(index + 1, kNoName);
  if (name_of_[index] != kNoName) return name_of_[index];
  const bool is_word = symbol.kind() == logic::SymbolKind::kWord;
  const NameId name = names_.Intern(is_word ? Fold(symbol.name()) : std::string(symbol.name()));
  name_of_[index] = name;
  Spelling& spelling = SpellingOf(name);
  if (!is_word) {
    spelling.object = symbol;
  } else if (!spelling.from_fact) {
    spelling.word = symbol;
    spelling.from_fact = true;
  }
  return name;
}

Value TermBridge::Import(const Term& term, Arena& arena) { return Import(term, arena, 0); }

Value TermBridge::Import(const logic::Fact& fact, Arena& arena) {
  return ImportList(Import(fact.predicate()), fact.arguments(), arena, 0);
}

Value TermBridge::Import(const Term& term, Arena& arena, std::uint32_t depth) {
  switch (term.kind()) {
    case Term::Kind::kInteger:
      return Value::Integer(term.integer());
    case Term::Kind::kReal:
      return std::isfinite(term.real()) ? Value::Real(term.real()) : Value();
    case Term::Kind::kConstant: {
      const NameId name = Import(term.symbol());
      return term.symbol().kind() == logic::SymbolKind::kWord ? Value::Symbol(name)
                                                              : Value::String(name);
    }
    case Term::Kind::kCompound:
      return depth < kMaxListDepth
                 ? ImportList(Import(term.symbol()), term.arguments(), arena, depth)
                 : Value();
    case Term::Kind::kVariable:
      break;
  }
  return {};
}

Value TermBridge::ImportList(NameId head, std::span<const Term> arguments, Arena& arena,
                             std::uint32_t depth) {
  const std::size_t mark = stack_.size();
  stack_.push_back(Value::Symbol(head));
  bool whole = true;
  for (const Term& argument : arguments) {
    const Value value = Import(argument, arena, depth + 1);
    whole = whole && !value.is_none();
    stack_.push_back(value);
  }
  Value list;
  if (whole) list = arena.MakeList({stack_.data() + mark, stack_.size() - mark});
  stack_.resize(mark);
  return list;
}

logic::Symbol TermBridge::Export(NameId name) {
  Spelling& spelling = SpellingOf(name);
  if (!spelling.word) spelling.word = symbols_.Intern(names_.Name(name));
  return spelling.word;
}

bool TermBridge::Export(const Value& value, Term& term) {
  switch (value.kind) {
    case ValueKind::kInteger:
      term = Term::Integer(value.integer);
      return true;
    case ValueKind::kReal:
      term = Term::Real(value.real);
      return true;
    case ValueKind::kSymbol:
      term = Term::Constant(Export(value.name));
      return true;
    case ValueKind::kString: {
      logic::Symbol& object = SpellingOf(value.name).object;
      if (!object) {
        object = symbols_.Intern(names_.Name(value.name), logic::SymbolKind::kDistinctObject);
      }
      term = Term::Constant(object);
      return true;
    }
    case ValueKind::kList:
      return ExportList(value, term);
    case ValueKind::kNone:
      break;
  }
  return false;
}

/// Keeps what it makes, so that a list that goes out in every cycle is made once.
bool TermBridge::ExportList(const Value& list, Term& term) {
  const std::span<const Value> items = list.list->items();
  if (items.size() < 2 || items[0].kind != ValueKind::kSymbol) return false;
  if (kept_.empty()) kept_.resize(kPlaces);
  Kept& kept = kept_[(list.list->hash >> 20U) & (kPlaces - 1)];
  if (!kept.list.is_none() && Equal(kept.list, list)) {
    term = kept.term;
    return true;
  }
  std::vector<Term> arguments(items.size() - 1);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (!Export(items[i + 1], arguments[i])) return false;
  }
  term = Term::Compound(Export(items[0].name), std::move(arguments));
  if (++kept_count_ > 4 * kPlaces) {
    kept_.assign(kPlaces, {});
    kept_lists_.Reset();
    kept_count_ = 0;
  }
  kept_[(list.list->hash >> 20U) & (kPlaces - 1)] = {kept_lists_.Copy(list), term};
  return true;
}

void TermBridge::Spell(NameId name, std::string_view spelling) {
  Spelling& known = SpellingOf(name);
  if (!known.word) known.word = symbols_.Intern(spelling);
}

}  // namespace latchwork::icarus

// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/eprover/disguise.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <utility>
#include <vector>

namespace latchwork::eprover {
namespace {

/// A term with its leaves replaced. Facts may be nested deeply: nothing recurses.
template <typename Replace>
logic::Term Map(const logic::Term& term, const Replace& replace) {
  struct Visit {
    const logic::Term* term;
    bool is_done;
  };
  std::vector<Visit> open = {{&term, false}};
  std::vector<logic::Term> results;
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    const auto arguments = visit.term->arguments();
    if (arguments.empty()) {
      results.push_back(replace(*visit.term));
    } else if (!visit.is_done) {
      open.push_back({visit.term, true});
      for (std::size_t i = arguments.size(); i > 0; --i) open.push_back({&arguments[i - 1], false});
    } else {
      const auto first = results.end() - static_cast<std::ptrdiff_t>(arguments.size());
      std::vector<logic::Term> parts(first, results.end());
      results.erase(first, results.end());
      results.push_back(logic::Term::Compound(visit.term->symbol(), std::move(parts)));
    }
  }
  return std::move(results.back());
}

template <typename Replace>
logic::Atom MapAtom(const logic::Atom& atom, const Replace& replace) {
  std::vector<logic::Term> arguments;
  for (const logic::Term& argument : atom.arguments()) arguments.push_back(Map(argument, replace));
  return {atom.predicate(), arguments};
}

constexpr char kMark = '#';

bool IsMarked(const logic::Term& leaf) {
  return leaf.kind() == logic::Term::Kind::kConstant &&
         leaf.symbol().kind() == logic::SymbolKind::kDistinctObject &&
         leaf.symbol().name().starts_with(kMark);
}

logic::Term DistinctObject(std::string_view name, logic::SymbolTable& symbols) {
  return logic::Term::Constant(symbols.Intern(name, logic::SymbolKind::kDistinctObject));
}

auto Hider(logic::SymbolTable& symbols) {
  return [&symbols](const logic::Term& leaf) {
    if (leaf.is_number()) return DistinctObject(kMark + ToString(leaf), symbols);
    if (!IsMarked(leaf)) return leaf;
    return DistinctObject(kMark + std::string(leaf.symbol().name()), symbols);
  };
}

std::optional<logic::Term> NumberIn(std::string_view text) {
  const char* const end = text.data() + text.size();
  std::int64_t integer = 0;
  const auto whole = std::from_chars(text.data(), end, integer);
  if (whole.ec == std::errc() && whole.ptr == end) return logic::Term::Integer(integer);
  double real = 0;
  const auto read = std::from_chars(text.data(), end, real);
  if (read.ec == std::errc() && read.ptr == end) return logic::Term::Real(real);
  return std::nullopt;
}

auto Revealer(logic::SymbolTable& symbols) {
  return [&symbols](const logic::Term& leaf) {
    if (!IsMarked(leaf)) return leaf;
    std::string_view name = leaf.symbol().name();
    name.remove_prefix(1);
    if (name.starts_with(kMark)) return DistinctObject(name, symbols);
    return NumberIn(name).value_or(leaf);
  };
}

}  // namespace

logic::Term Disguise(const logic::Term& term, logic::SymbolTable& symbols) {
  return Map(term, Hider(symbols));
}

logic::Atom Disguise(const logic::Atom& atom, logic::SymbolTable& symbols) {
  return MapAtom(atom, Hider(symbols));
}

logic::Term Undisguise(const logic::Term& term, logic::SymbolTable& symbols) {
  return Map(term, Revealer(symbols));
}

logic::Atom Undisguise(const logic::Atom& atom, logic::SymbolTable& symbols) {
  return MapAtom(atom, Revealer(symbols));
}

std::string Axiom(const logic::Clause& clause, logic::SymbolTable& symbols) {
  logic::Clause hidden = clause;
  for (logic::Literal& literal : hidden.literals) literal.atom = Disguise(literal.atom, symbols);
  // Names of variables are the reader's; numbered ones cannot clash.
  for (std::size_t i = 0; i < hidden.variable_names.size(); ++i) {
    hidden.variable_names[i] = fmt::format("X{}", i);
  }
  return fmt::format("cnf(c, axiom, ({})).\n", ToString(hidden));
}

std::string Axiom(const logic::Literal& literal, logic::SymbolTable& symbols) {
  const logic::Literal hidden{literal.positive, Disguise(literal.atom, symbols)};
  return fmt::format("cnf(f, axiom, ({})).\n", ToString(hidden));
}

}  // namespace latchwork::eprover

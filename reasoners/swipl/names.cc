// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/swipl/names.h"

#include <fmt/format.h>

#include <iterator>

namespace latchwork::swipl {
namespace {

/// With a point, as Prolog wants it.
void WriteReal(double value, std::string& text) {
  const std::string digits = fmt::format("{}", value == 0.0 ? 0.0 : value);
  const std::size_t exponent = digits.find('e');
  if (digits.find('.') == std::string::npos) {
    text += digits.substr(0, exponent) + ".0";
    if (exponent != std::string::npos) text += digits.substr(exponent);
  } else {
    text += digits;
  }
}

}  // namespace

std::size_t Names::Predicate(const logic::PredicateName& name) {
  const auto [found, is_new] = numbers_.emplace(name, predicates_.size());
  if (is_new) predicates_.push_back(name);
  return found->second;
}

std::size_t Names::Number(logic::Symbol symbol) {
  symbols_.emplace(symbol.index(), symbol);
  return symbol.index();
}

std::optional<logic::Symbol> Names::symbol(std::size_t number) const {
  const auto found = symbols_.find(number);
  if (found == symbols_.end()) return std::nullopt;
  return found->second;
}

void Names::WriteLeaf(const logic::Term& term, std::string& text) {
  const auto out = std::back_inserter(text);
  switch (term.kind()) {
    case logic::Term::Kind::kVariable:
      fmt::format_to(out, "X{}", term.variable());
      break;
    case logic::Term::Kind::kInteger:
      fmt::format_to(out, "{}", term.integer());
      break;
    case logic::Term::Kind::kReal:
      WriteReal(term.real(), text);
      break;
    default: {
      const bool is_word = term.symbol().kind() == logic::SymbolKind::kWord;
      const std::size_t number = Number(term.symbol());
      text += is_word ? fmt::format("c{}", number) : fmt::format("d({})", number);
    }
  }
}

void Names::Write(const logic::Term& term, std::string& text) {
  struct Visit {
    const logic::Term* term;
    std::size_t next;
  };
  std::vector<Visit> open = {{&term, 0}};
  while (!open.empty()) {
    Visit& visit = open.back();
    if (visit.term->kind() != logic::Term::Kind::kCompound) {
      WriteLeaf(*visit.term, text);
      open.pop_back();
      continue;
    }
    const auto arguments = visit.term->arguments();
    if (visit.next == arguments.size()) {
      text += ')';
      open.pop_back();
      continue;
    }
    if (visit.next == 0) {
      fmt::format_to(std::back_inserter(text), "g{}", Number(visit.term->symbol()));
    }
    text += visit.next == 0 ? '(' : ',';
    const logic::Term* const argument = &arguments[visit.next++];
    open.push_back({argument, 0});
  }
}

void Names::Write(std::string_view prefix, const logic::Atom& atom, std::string& text,
                  std::string_view more) {
  fmt::format_to(std::back_inserter(text), "{}{}", prefix, Predicate(NameOf(atom)));
  char separator = '(';
  for (const logic::Term& argument : atom.arguments()) {
    text += separator;
    Write(argument, text);
    separator = ',';
  }
  if (!more.empty()) {
    text += separator;
    text += more;
    separator = ',';
  }
  if (separator == ',') text += ')';
}

}  // namespace latchwork::swipl

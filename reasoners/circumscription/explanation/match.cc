// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/explanation/match.h"

#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace latchwork::circumscription {
namespace {

using logic::Term;
using Pairs = std::vector<std::pair<Term, Term>>;

void AddPairs(std::span<const Term> patterns, std::span<const Term> terms, Pairs& open) {
  for (std::size_t i = 0; i < patterns.size(); ++i) open.emplace_back(patterns[i], terms[i]);
}

}  // namespace

bool Matches(const logic::Atom& pattern, const logic::Fact& fact) {
  if (NameOf(pattern) != NameOf(fact)) return false;
  std::map<logic::Variable, Term> values;
  Pairs open;
  AddPairs(pattern.arguments(), fact.arguments(), open);
  while (!open.empty()) {
    const auto [part, term] = std::move(open.back());
    open.pop_back();
    if (part.is_variable()) {
      if (!(values.emplace(part.variable(), term).first->second == term)) return false;
    } else if (part.arguments().empty()) {
      if (!(part == term)) return false;
    } else {
      const bool is_alike =
          term.arguments().size() == part.arguments().size() && term.symbol() == part.symbol();
      if (!is_alike) return false;
      AddPairs(part.arguments(), term.arguments(), open);
    }
  }
  return true;
}

}  // namespace latchwork::circumscription

// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "core/logic/print.h"
#include "latchwork/logic/tptp.h"

namespace latchwork::logic {

namespace {

bool IsVariableName(std::string_view name) {
  const auto is_word_byte = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !name.empty() && ((name[0] >= 'A' && name[0] <= 'Z') || name[0] == '_') &&
         std::all_of(name.begin(), name.end(), is_word_byte);
}

std::string Annotate(std::string_view language, std::string_view name, Role role,
                     std::string_view formula) {
  std::string text(language);
  text += '(';
  text += QuoteName(name);
  text += ", ";
  text += RoleName(role);
  text += ", ";
  text += formula;
  text += ").\n";
  return text;
}

}  // namespace

std::string_view RoleName(Role role) {
  switch (role) {
    case Role::kConjecture:
      return "conjecture";
    case Role::kNegatedConjecture:
      return "negated_conjecture";
    default:
      return "axiom";
  }
}

std::vector<std::string> DistinctNames(const std::vector<std::string>& names) {
  std::unordered_set<std::string> taken;
  std::vector<std::string> distinct;
  for (const std::string& name : names) {
    const std::string stem = IsVariableName(name) ? name : "X" + std::to_string(distinct.size());
    std::string candidate = stem;
    for (std::size_t n = distinct.size(); !taken.insert(candidate).second; ++n) {
      candidate = stem + "_" + std::to_string(n);
    }
    distinct.push_back(std::move(candidate));
  }
  return distinct;
}

std::string WriteTptp(const std::vector<AnnotatedFormula>& formulas) {
  std::string text;
  for (const AnnotatedFormula& each : formulas) {
    const bool is_closed = each.is_clause && each.formula.kind() == Formula::Kind::kForall;
    const Formula& formula = is_closed ? each.formula.children()[0] : each.formula;
    text += Annotate(each.is_clause ? "cnf" : "fof", each.name, each.role,
                     ToString(formula, DistinctNames(each.variable_names)));
  }
  return text;
}

std::string WriteTptp(const Clause& clause) {
  Clause named = clause;
  named.variable_names = DistinctNames(clause.variable_names);
  return Annotate("cnf", clause.name, clause.role, ToString(named));
}

}  // namespace latchwork::logic

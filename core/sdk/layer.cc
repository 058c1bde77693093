// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/layer.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace latchwork::sdk {
namespace {

struct ToTerm {
  logic::SymbolTable& symbols;

  logic::Term operator()(std::int64_t value) const { return logic::Term::Integer(value); }
  logic::Term operator()(double value) const { return logic::Term::Real(value); }
  logic::Term operator()(bool value) const {
    return logic::Term::Constant(symbols.Intern(value ? "true" : "false"));
  }
  logic::Term operator()(const std::string& value) const {
    return logic::Term::Constant(symbols.Intern(value));
  }
};

}  // namespace

std::vector<logic::Fact> ParameterFacts(const Parameters& parameters, logic::SymbolTable& symbols) {
  std::vector<logic::Fact> facts;
  facts.reserve(parameters.entries().size());
  for (const auto& [name, entry] : parameters.entries()) {
    facts.emplace_back(symbols.Intern(name), std::initializer_list<logic::Term>{
                                                 std::visit(ToTerm{symbols}, entry.value)});
  }
  return facts;
}

}  // namespace latchwork::sdk

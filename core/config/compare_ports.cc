// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "core/config/agent_check.h"

namespace latchwork::config {
namespace {

std::string_view TypeName(sdk::ArgumentType type) {
  switch (type) {
    case sdk::ArgumentType::kInteger:
      return "integer";
    case sdk::ArgumentType::kReal:
      return "real";
    case sdk::ArgumentType::kSymbol:
      return "symbol";
    case sdk::ArgumentType::kAny:
      break;
  }
  return "any";
}

bool Accepts(sdk::ArgumentType to, sdk::ArgumentType from) {
  using Type = sdk::ArgumentType;
  return to == from || to == Type::kAny || from == Type::kAny ||
         (to == Type::kReal && from == Type::kInteger);
}

std::optional<Mismatch> Compare(const sdk::PredicateSpec& from, const sdk::PredicateSpec& to) {
  if (from.arguments.size() != to.arguments.size()) {
    return Mismatch{fmt::format("'{}' leaves as {}/{} and enters as {}/{}", from.name, from.name,
                                from.arguments.size(), to.name, to.arguments.size()),
                    "the two ports must declare it with the same number of arguments"};
  }
  for (std::size_t i = 0; i < from.arguments.size(); ++i) {
    const sdk::ArgumentSpec& a = from.arguments[i];
    const sdk::ArgumentSpec& b = to.arguments[i];
    if (!Accepts(b.type, a.type)) {
      return Mismatch{fmt::format("argument {} of '{}' leaves as {} and enters as {}", i + 1,
                                  from.name, TypeName(a.type), TypeName(b.type)),
                      ""};
    }
    if (!a.unit.empty() && !b.unit.empty() && a.unit != b.unit) {
      return Mismatch{fmt::format("argument {} of '{}' leaves in {} and enters in {}", i + 1,
                                  from.name, a.unit, b.unit),
                      ""};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Mismatch> Compare(const sdk::PortSpec& from, const sdk::PortSpec& to) {
  bool has_common = false;
  for (const sdk::PredicateSpec& predicate : to.predicates) {
    const auto source =
        std::ranges::find(from.predicates, predicate.name, &sdk::PredicateSpec::name);
    if (source == from.predicates.end()) continue;
    if (auto mismatch = Compare(*source, predicate)) return mismatch;
    has_common = true;
  }
  if (has_common) return std::nullopt;
  return Mismatch{
      "no predicate is declared at both ends",
      fmt::format("it carries {}; it takes {}", fmt::join(NamesOf(from.predicates), ", "),
                  fmt::join(NamesOf(to.predicates), ", "))};
}

}  // namespace latchwork::config

// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "core/config/agent_check.h"
#include "latchwork/logic/tptp.h"

namespace latchwork::config {
namespace {

std::string_view TypeName(sdk::ArgumentType type) {
  switch (type) {
    case sdk::ArgumentType::kInteger:
      return "an integer";
    case sdk::ArgumentType::kReal:
      return "a number";
    case sdk::ArgumentType::kSymbol:
      return "a name";
    case sdk::ArgumentType::kAny:
      break;
  }
  return "a term";
}

bool IsOfType(const logic::Term& term, sdk::ArgumentType type) {
  switch (type) {
    case sdk::ArgumentType::kInteger:
      return term.kind() == logic::Term::Kind::kInteger;
    case sdk::ArgumentType::kReal:
      return term.is_number();
    case sdk::ArgumentType::kSymbol:
      return term.kind() == logic::Term::Kind::kConstant;
    case sdk::ArgumentType::kAny:
      break;
  }
  return true;
}

std::string Signature(const sdk::PredicateSpec& spec) {
  if (spec.arguments.empty()) return spec.name;
  return fmt::format("{}({})", spec.name, fmt::join(NamesOf(spec.arguments), ", "));
}

}  // namespace

std::optional<logic::Fact> AgentCheck::ReadFact(std::string_view text,
                                                const logic::SourcePlace& place,
                                                std::span<const sdk::PredicateSpec> predicates,
                                                const std::string& owner) {
  logic::TptpAtom read = logic::ReadTptpAtom(text, place.file, symbols);
  if (!read.atom) {
    const std::string why =
        read.diagnostics.empty() ? "no atom can be read" : read.diagnostics.front().message;
    Say(place, fmt::format("'{}' is not a fact: {}", text, why));
    return std::nullopt;
  }
  const logic::Atom& atom = *read.atom;
  const auto spec =
      std::ranges::find(predicates, atom.predicate().name(), &sdk::PredicateSpec::name);
  if (spec == predicates.end()) {
    Say(place, fmt::format("{} does not know '{}'", owner, logic::ToString(logic::NameOf(atom))),
        NameHint(atom.predicate().name(), NamesOf(predicates)));
    return std::nullopt;
  }
  if (spec->arguments.size() != atom.arity()) {
    Say(place,
        fmt::format("'{}' has {} arguments, not {}", spec->name, spec->arguments.size(),
                    atom.arity()),
        fmt::format("write {}", Signature(*spec)));
    return std::nullopt;
  }
  if (!atom.is_ground()) {
    Say(place, fmt::format("'{}' is not ground: a fact has no variables", text),
        "names start with a small letter");
    return std::nullopt;
  }
  for (std::size_t i = 0; i < atom.arity(); ++i) {
    const sdk::ArgumentSpec& argument = spec->arguments[i];
    if (IsOfType(atom.argument(i), argument.type)) continue;
    Say(place, fmt::format("argument {} of '{}' must be {}, not {}", argument.name, spec->name,
                           TypeName(argument.type), logic::ToString(atom.argument(i))));
    return std::nullopt;
  }
  return std::move(read.atom);
}

}  // namespace latchwork::config

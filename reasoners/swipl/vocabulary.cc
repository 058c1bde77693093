// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/swipl/vocabulary.h"

#include <algorithm>
#include <array>

namespace latchwork::swipl {

Vocabulary::Vocabulary(const sdk::Body& body, Names& names, logic::SymbolTable& symbols)
    : body_(body),
      names_(names),
      symbols_(symbols),
      arithmetic_(symbols),
      equality_{symbols.Intern("="), 2} {}

const Vocabulary::Info& Vocabulary::operator[](std::size_t predicate) {
  while (infos_.size() <= predicate) infos_.push_back(MakeInfo(names_.predicate(infos_.size())));
  return infos_[predicate];
}

Vocabulary::Info Vocabulary::MakeInfo(const logic::PredicateName& name) const {
  Info info;
  for (const sdk::Minimized& minimized : body_.minimized) {
    if (minimized.predicate == name) info.minimized = minimized.depth;
  }
  info.is_input = std::ranges::find(body_.inputs, name) != body_.inputs.end();
  if (name == equality_) info.kind = Kind::kEquality;
  if (arithmetic_.FindPredicate(name.symbol, name.arity)) info.kind = Kind::kArithmetic;
  for (std::size_t i = 0; i < body_.attachments.size(); ++i) {
    const auto& signature = body_.attachments[i]->signature();
    if (symbols_.Intern(signature.predicate) != name.symbol ||
        signature.arguments.size() != name.arity) {
      continue;
    }
    info.kind = Kind::kAttachment;
    info.attachment = i;
  }
  return info;
}

bool Vocabulary::HasArithmetic(const logic::Term& term) const {
  std::vector<const logic::Term*> open = {&term};
  while (!open.empty()) {
    const logic::Term& current = *open.back();
    open.pop_back();
    if (current.kind() != logic::Term::Kind::kCompound) continue;
    if (arithmetic_.FindFunction(current.symbol(), current.arguments().size())) return true;
    for (const logic::Term& argument : current.arguments()) open.push_back(&argument);
  }
  return false;
}

std::string_view NameIn(logic::Arithmetic::Predicate predicate) {
  constexpr std::array<std::string_view, 6> kNames = {"less",      "lesseq", "greater",
                                                      "greatereq", "is_int", "is_real"};
  return kNames[static_cast<std::size_t>(predicate)];
}

std::string_view NameIn(logic::Arithmetic::Function function) {
  constexpr std::array<std::string_view, 16> kNames = {
      "sum",         "difference", "product", "quotient", "uminus",   "to_int",
      "to_real",     "floor",      "ceiling", "round",    "truncate", "quotient_e",
      "remainder_e", "abs",        "min",     "max"};
  return kNames[static_cast<std::size_t>(function)];
}

}  // namespace latchwork::swipl

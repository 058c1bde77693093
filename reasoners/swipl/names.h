// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SWIPL_NAMES_H_
#define LATCHWORK_SWIPL_NAMES_H_

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/symbol.h"

namespace latchwork::swipl {

/// What symbols are called in Prolog, so that nothing needs quotes: constants c17, functions g17,
/// distinct objects d(17), predicates by a number of their own; variable 3 is X3.
class Names {
 public:
  std::size_t Predicate(const logic::PredicateName& name);
  const logic::PredicateName& predicate(std::size_t number) const { return predicates_[number]; }
  std::size_t size() const { return predicates_.size(); }

  void Write(const logic::Term& term, std::string& text);
  /// `f3(c1,X0)`, where `prefix` is the f; without arguments `f3`. `more` ends the arguments.
  void Write(std::string_view prefix, const logic::Atom& atom, std::string& text,
             std::string_view more = {});

  /// The symbol behind c17 or g17; nothing when none was written.
  std::optional<logic::Symbol> symbol(std::size_t number) const;

 private:
  void WriteLeaf(const logic::Term& term, std::string& text);
  std::size_t Number(logic::Symbol symbol);

  std::map<logic::PredicateName, std::size_t> numbers_;
  std::vector<logic::PredicateName> predicates_;
  std::unordered_map<std::size_t, logic::Symbol> symbols_;
};

}  // namespace latchwork::swipl

#endif  // LATCHWORK_SWIPL_NAMES_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SATURATION_TRANSLATION_H_
#define LATCHWORK_PTTP_SATURATION_TRANSLATION_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/symbol.h"
#include "reasoners/pttp/saturation/ordering.h"
#include "reasoners/pttp/saturation/saturate.h"
#include "reasoners/pttp/saturation/terms.h"

namespace latchwork::pttp::saturation {

/// Between the terms of logic and the shared ones.
class Translation {
 public:
  Translation(Terms& terms, logic::SymbolTable& symbols);

  std::vector<Literal> Read(const logic::Clause& clause);
  /// Gives every functor its place in the ordering and its weights, by the clauses read so far.
  void Arrange(const Options& options);
  /// A number, a distinct object or a `$` symbol was read.
  bool has_fixed_meaning() const { return has_fixed_meaning_; }

  logic::Clause Write(std::span<const Literal> literals) const;

 private:
  enum class Kind : std::uint8_t { kPredicate, kFunction, kInteger, kReal };
  struct Name {
    Kind kind;
    std::uint64_t value;  ///< Index of the symbol, or the bits of the number.
    std::size_t arity;
    friend bool operator<(const Name& a, const Name& b) {
      return std::tie(a.kind, a.value, a.arity) < std::tie(b.kind, b.value, b.arity);
    }
  };
  struct Source {
    logic::Term term;  ///< A constant or number; its symbol names functions and predicates, too.
    bool predicate = false;
    std::uint32_t occurrences = 0;
    bool in_goal = false;
  };

  FunctorId Find(const Name& name, const logic::Term& constant, Functor::Distinct distinct);
  FunctorId FindPredicate(const logic::Atom& atom);
  FunctorId FindHead(const logic::Term& term);
  void Note(FunctorId functor);
  /// The unary function that occurs most often; 0 when there is none.
  FunctorId FrequentUnary() const;
  TermId ReadTerm(const logic::Term& root);
  logic::Term WriteTerm(TermId root) const;
  logic::Atom WriteAtom(const Literal& literal) const;

  Terms& terms_;
  logic::Symbol equality_;
  std::map<Name, FunctorId> functors_;
  std::vector<Source> sources_;  ///< By functor.
  bool reading_goal_ = false;
  bool has_fixed_meaning_ = false;
};

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_PTTP_SATURATION_TRANSLATION_H_

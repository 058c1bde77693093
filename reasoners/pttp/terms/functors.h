// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_FUNCTORS_H_
#define LATCHWORK_PTTP_FUNCTORS_H_

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "latchwork/logic/arithmetic.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/logic/term.h"
#include "reasoners/pttp/terms/arena.h"
#include "reasoners/pttp/terms/word.h"

namespace latchwork::pttp {

/// What arithmetic on reals may do.
enum class Reals : std::uint8_t {
  kRounded,  ///< Round as IEEE doubles do: what a robot computes with.
  kExact,    ///< Where a result would be rounded there is no value: what a proof is made of.
  kGiven,    ///< The same, and some numeral was rounded when it was read: no sums and products.
};

/// Numbers the constants and functions (name and arity) that the engine has met, and turns terms
/// into words and back.
class Functors {
 public:
  Functors(const logic::Arithmetic& arithmetic, Reals reals)
      : arithmetic_(&arithmetic), reals_(reals) {}

  struct Functor {
    logic::Symbol symbol;
    std::uint32_t arity = 0;
    std::optional<logic::Arithmetic::Function> function;
  };

  std::uint32_t Number(logic::Symbol symbol, std::size_t arity);
  Reals reals() const { return reals_; }
  const Functor& operator[](std::uint32_t number) const { return functors_[number]; }

  /// Copies a term into the arena. Its variables become slots; ground compounds are plain, others
  /// templates.
  Word Import(const logic::Term& term, Arena& arena);
  /// Reads a term out; unbound variables are numbered in the order of `variables`, which grows.
  logic::Term Export(Word word, std::vector<Word>& variables) const;

 private:
  const logic::Arithmetic* arithmetic_;
  Reals reals_;
  std::vector<Functor> functors_;
  std::vector<std::uint32_t> constants_;  ///< By symbol index; kNone when not met.
  std::unordered_map<std::uint64_t, std::uint32_t> compounds_;
  struct ImportTask {
    const logic::Term* term;
    Word* place;
  };
  std::vector<ImportTask> tasks_;
};

/// A boxed number.
Word IntegerWord(std::int64_t value, Arena& arena);
Word RealWord(double value, Arena& arena);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_FUNCTORS_H_

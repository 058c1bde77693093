// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_PTTP_SATURATION_FIXTURE_H_
#define LATCHWORK_TESTS_REASONERS_PTTP_SATURATION_FIXTURE_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "latchwork/logic/clausify.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/logic/tptp.h"
#include "latchwork/sdk/random.h"
#include "reasoners/pttp/saturation/saturate.h"
#include "reasoners/pttp/saturation/terms.h"

namespace latchwork::pttp::saturation {

/// Numbers drawn one after another.
class Draws {
 public:
  explicit Draws(std::uint64_t number) : number_(number) {}

  std::size_t Pick(std::size_t count) {
    return static_cast<std::size_t>(stream_.Index(count, number_, draws_++));
  }

 private:
  sdk::RandomStream stream_{11, "saturation"};
  std::uint64_t number_;
  std::uint64_t draws_ = 0;
};

/// A run on TPTP text.
struct Attempt {
  explicit Attempt(const std::string& text, const Options& options = {},
                   std::size_t memory = std::size_t{1} << 30U) {
    clauses = logic::Clausify(logic::ReadTptp(text, "test", symbols).formulas, symbols);
    const std::function<bool()> stop;
    outcome = Saturate({clauses, symbols}, options, {memory, stop});
  }

  logic::SymbolTable symbols;
  std::vector<logic::Clause> clauses;
  Outcome outcome;
};

/// Constants a, b, unary f, binary g, with precedences in this order.
struct SmallSignature {
  SmallSignature() {
    for (const std::uint32_t arity : {0U, 0U, 1U, 2U}) {
      Functor functor;
      functor.arity = arity;
      functor.precedence = static_cast<std::uint32_t>(terms.functor_count());
      functors.push_back(terms.AddFunctor(functor));
    }
  }

  TermId Random(Draws& draws, std::size_t depth, std::uint32_t variables = 3) {
    const std::size_t choice = draws.Pick(depth == 0 ? 3 : 6);
    if (choice == 0) {
      return Terms::Variable(static_cast<std::uint32_t>(draws.Pick(variables)));
    }
    if (choice < 3) return terms.Make(functors[choice - 1], {});
    if (choice == 3)
      return terms.Make(functors[2], std::vector{Random(draws, depth - 1, variables)});
    const TermId left = Random(draws, depth - 1, variables);
    return terms.Make(functors[3], std::vector{left, Random(draws, depth - 1, variables)});
  }

  Terms terms;
  std::vector<FunctorId> functors;
};

}  // namespace latchwork::pttp::saturation

#endif  // LATCHWORK_TESTS_REASONERS_PTTP_SATURATION_FIXTURE_H_

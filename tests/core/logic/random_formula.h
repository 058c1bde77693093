// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_CORE_LOGIC_RANDOM_FORMULA_H_
#define LATCHWORK_TESTS_CORE_LOGIC_RANDOM_FORMULA_H_

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/logic/formula.h"
#include "latchwork/logic/symbol.h"

namespace latchwork::logic {

/// Closed random formulas over p/1, q/1, r/0 and s/0 for property tests; the same for the same
/// seed.
class RandomFormula {
 public:
  RandomFormula(SymbolTable& symbols, std::uint64_t seed) : symbols_(symbols), state_(seed) {}

  AnnotatedFormula Next(int depth) {
    variables_ = 0;
    scope_.clear();
    AnnotatedFormula annotated;
    annotated.name = "random";
    annotated.formula = Make(depth);
    for (std::uint32_t i = 0; i < variables_; ++i) {
      annotated.variable_names.push_back("V" + std::to_string(i));
    }
    return annotated;
  }

  std::uint64_t Below(std::uint64_t bound) {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return state_ % bound;
  }

 private:
  Formula Make(int depth) {
    if (depth == 0) return MakeAtom();
    switch (Below(9)) {
      case 0:
        return MakeAtom();
      case 1:
        return Formula::Not(Make(depth - 1));
      case 2:
        return Formula::And(MakeSome(depth));
      case 3:
        return Formula::Or(MakeSome(depth));
      case 4: {
        Formula premise = Make(depth - 1);
        return Formula::Implies(std::move(premise), Make(depth - 1));
      }
      case 5: {
        Formula left = Make(depth - 1);
        return Formula::Equivalent(std::move(left), Make(depth - 1));
      }
      case 6:
      case 7:
        return MakeQuantified(depth);
      default:
        return Below(8) > 0 ? Make(depth - 1) : Below(2) > 0 ? Formula::True() : Formula::False();
    }
  }

  std::vector<Formula> MakeSome(int depth) {
    std::vector<Formula> formulas;
    const std::uint64_t count = 2 + Below(2);
    for (std::uint64_t i = 0; i < count; ++i) formulas.push_back(Make(depth - 1));
    return formulas;
  }

  Formula MakeQuantified(int depth) {
    std::vector<Variable> bound(1 + Below(2));
    for (Variable& variable : bound) scope_.push_back(variable = variables_++);
    Formula inside = Make(depth - 1);
    scope_.resize(scope_.size() - bound.size());
    return Below(2) > 0 ? Formula::Forall(std::move(bound), std::move(inside))
                        : Formula::Exists(std::move(bound), std::move(inside));
  }

  Formula MakeAtom() {
    if (scope_.empty() || Below(4) == 0) {
      return Formula::Of(Atom(symbols_.Intern(Below(2) > 0 ? "r" : "s")));
    }
    const Term argument = Term::Var(scope_[Below(scope_.size())]);
    return Formula::Of(Atom(symbols_.Intern(Below(2) > 0 ? "p" : "q"), {argument}));
  }

  SymbolTable& symbols_;
  std::uint64_t state_;
  Variable variables_ = 0;
  std::vector<Variable> scope_;
};

}  // namespace latchwork::logic

#endif  // LATCHWORK_TESTS_CORE_LOGIC_RANDOM_FORMULA_H_

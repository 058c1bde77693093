// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_CHECK_PROOF_SMALL_SIMPLIFIER_H_
#define LATCHWORK_APPS_CHECK_PROOF_SMALL_SIMPLIFIER_H_

#include <cstddef>
#include <vector>

#include "latchwork/logic/clause.h"

namespace latchwork::check_proof {

/// Makes clauses simpler by unit clauses that are known: equations rewrite from the larger side to
/// the smaller, other units cut what contradicts them off.
class SmallSimplifier {
 public:
  using Literals = std::vector<logic::Literal>;

  void AddUnit(const logic::Literal& unit);
  void RemoveUnit(const logic::Literal& unit);

  /// Whether it changed; a clause that is true is not told from others.
  bool Simplify(Literals& clause) const;
  /// Whether a literal is false in every model, or true.
  static bool IsFalse(const logic::Literal& literal);
  static bool IsTrue(const logic::Literal& literal);

 private:
  logic::Term Rewrite(const logic::Term& term, std::size_t& steps) const;
  bool RewriteOnce(logic::Term& term) const;
  bool IsCut(const logic::Literal& literal) const;

  Literals units_;
  Literals equations_;  ///< The positive equations among the units.
};

/// Whether an instance of a clause is part of another; false as well when that takes too long to
/// say.
bool Subsumes(const std::vector<logic::Literal>& general,
              const std::vector<logic::Literal>& special);

}  // namespace latchwork::check_proof

#endif  // LATCHWORK_APPS_CHECK_PROOF_SMALL_SIMPLIFIER_H_

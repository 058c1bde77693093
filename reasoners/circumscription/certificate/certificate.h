// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_CERTIFICATE_CERTIFICATE_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_CERTIFICATE_CERTIFICATE_H_

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "reasoners/circumscription/certificate/propagator.h"
#include "reasoners/circumscription/theory/compiled_theory.h"

namespace latchwork::circumscription {

/// Propagates from the latches, assumes what is still open of the first level false, propagates,
/// and so on level by level. If this ends in a model, every minimal model agrees with it on the
/// minimized atoms. Satisfiable definite theories whose fixed atoms are known always get that far.
class Certificate {
 public:
  explicit Certificate(const CompiledTheory& theory) : theory_(theory), propagator_(theory) {}

  /// Whether the certificate closes. `latches`: literals over the fixed atoms.
  bool Close(std::span<const Literal> latches);

  /// After Close returned true.
  bool Holds(Literal literal) const { return propagator_.Value(literal) > 0; }
  /// Whether all minimal models agree on `literal`: varying atoms may have been chosen.
  bool IsDetermined(Literal literal) const {
    return !chosen_ || theory_.role(AtomOf(literal)) != Role::kVarying || WasForced(literal);
  }
  /// Yes, no, or nothing: it depends on atoms that may vary.
  std::optional<bool> SatisfiesAll(std::span<const Literal> clause) const;
  Model ToModel() const;

 private:
  bool KnowsFixed() const;
  bool CloseLevel(const std::vector<Atom>& atoms);
  bool ChooseVarying();
  bool WasForced(Literal literal) const;

  const CompiledTheory& theory_;
  Propagator propagator_;
  bool chosen_ = false;     ///< A varying atom was assumed false.
  std::size_t forced_ = 0;  ///< Trail length before the first choice.
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_CERTIFICATE_CERTIFICATE_H_

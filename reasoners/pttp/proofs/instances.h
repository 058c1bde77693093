// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_INSTANCES_H_
#define LATCHWORK_PTTP_INSTANCES_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "latchwork/logic/clause.h"

namespace latchwork::pttp {

/// A term of a copy of a clause: its variables are numbered from `base` on.
struct TermCopy {
  const logic::Term* term = nullptr;
  std::uint32_t base = 0;
};

/// Values of the variables of clause copies, for searches so short that nothing is compiled for
/// them. Terms must outlive it. Work on single terms is bounded: what is larger than the bound
/// counts as not unifiable.
class Instances {
 public:
  struct Mark {
    std::size_t variables;
    std::size_t trail;
  };
  using Numbers = std::map<std::uint32_t, logic::Variable>;  ///< Of variables that are left.

  /// The base of a new copy of a clause.
  std::uint32_t Copy(std::size_t variables);
  Mark mark() const { return {values_.size(), trail_.size()}; }
  void UndoTo(const Mark& mark);

  /// With occurs check. Bindings made before a failure stay.
  bool Unify(TermCopy a, TermCopy b);
  bool Unify(const logic::Atom& a, std::uint32_t base_a, const logic::Atom& b,
             std::uint32_t base_b);
  bool Identical(const logic::Atom& a, std::uint32_t base_a, const logic::Atom& b,
                 std::uint32_t base_b) const;

  /// Terms that were looked at so far: what all that was asked cost.
  std::uint64_t work() const { return work_; }

  /// With all values put in; nothing when it is too large.
  std::optional<logic::Term> Export(TermCopy term, Numbers& numbers) const;
  std::optional<logic::Atom> Export(const logic::Atom& atom, std::uint32_t base,
                                    Numbers& numbers) const;

 private:
  TermCopy Resolve(TermCopy term) const;
  bool Bind(TermCopy variable, TermCopy value);
  bool Occurs(std::uint32_t variable, TermCopy term) const;

  std::vector<TermCopy> values_;  ///< By variable; without a term: unbound.
  std::vector<std::uint32_t> trail_;
  mutable std::uint64_t work_ = 0;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_INSTANCES_H_

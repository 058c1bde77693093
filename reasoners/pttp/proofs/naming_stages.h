// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_NAMING_STAGES_H_
#define LATCHWORK_PTTP_NAMING_STAGES_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "latchwork/logic/formula.h"

namespace latchwork::pttp {

/// A formula and its normal form, where both are disjunctions of as many parts below the same
/// universal quantifiers: the way from one to the other can be shown part by part.
class NamingStages {
 public:
  /// `formula` is negated where it is not `positive`. Nothing where the two are not of that kind.
  static std::optional<NamingStages> Of(const logic::Formula& formula, bool positive,
                                        const logic::Formula& normal);

  /// Of the normal form.
  const std::vector<logic::Formula>& parts() const { return parts_; }
  /// The parts from `first` on as the normal form has them, those before as the formula says them.
  /// What is left of the formula stays as it was, which makes it easy to recognise.
  logic::Formula Stage(std::size_t first) const;

 private:
  std::vector<logic::Variable> variables_;
  std::vector<logic::Formula> said_;
  bool positive_ = true;
  std::vector<logic::Formula> parts_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_NAMING_STAGES_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_SURE_OUTCOMES_H_
#define LATCHWORK_ICARUS_SURE_OUTCOMES_H_

#include <cstdint>
#include <vector>

#include "reasoners/icarus/language/program.h"

namespace latchwork::icarus {

/// What skills come to whenever they are asked, whatever the world and memory hold.
class SureOutcomes {
 public:
  explicit SureOutcomes(const Program& program);

  /// The objective has clauses, and is True or acts whenever it is asked.
  bool ObjectiveIsNeverFalse(const Skill& skill) const;

 private:
  enum class Outcome : std::uint8_t { kUnknown, kNeverFalse, kActs, kTrue };

  Outcome Of(const Clause& clause) const;
  Outcome OfConjunction(const std::vector<Clause>& clauses) const;
  Outcome OfSteps(const std::vector<Clause>& steps) const;
  Outcome OfMeans(const std::vector<Clause>& means) const;
  Outcome OfPlan(const Skill& skill) const;
  Outcome OfSkill(const Skill& skill) const;

  std::vector<Outcome> outcomes_;  ///< By skill.
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_SURE_OUTCOMES_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_LAYERS_LEGS_H_
#define LATCHWORK_OMPL_LAYERS_LEGS_H_

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "reasoners/ompl/layers/job.h"

namespace latchwork::planning {

/// Ways on foot between landmarks of one floor. Each is planned when it is first asked for.
class Legs {
 public:
  explicit Legs(const JobSetup& setup);

  /// No way leads through these any more, and through no others: doors that are shut.
  void Shut(const std::vector<logic::Symbol>& landmarks);
  /// Both are landmarks of the map on the same floor.
  FoundPath Between(logic::Symbol from, logic::Symbol to, Effort& effort);

 private:
  JobSetup setup_;
  std::map<std::int64_t, FreeSpace> spaces_;
  std::vector<logic::Symbol> shut_;
  std::map<std::pair<logic::Symbol, logic::Symbol>, FoundPath> known_;  ///< First < second.
};

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_LAYERS_LEGS_H_

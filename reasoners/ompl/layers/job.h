// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OMPL_LAYERS_JOB_H_
#define LATCHWORK_OMPL_LAYERS_JOB_H_

#include <memory>
#include <string>
#include <vector>

#include "latchwork/sdk/reasoner.h"
#include "reasoners/ompl/layers/latch_facts.h"
#include "reasoners/ompl/map/building_map.h"
#include "reasoners/ompl/paths/find_path.h"

namespace latchwork::planning {

/// What all layers that a planner drives have in common.
struct JobSetup {
  const BuildingMap* map = nullptr;
  PathSettings paths;
  double clearance = 0.3;   ///< m, from the robot's centre to whatever is in the map
  double lookahead = 1.0;   ///< m
  double stray = 0.7;       ///< m
  double ride_cost = 20.0;  ///< m
};

/// What a cycle came to.
struct Verdict {
  FoundPath::State state = FoundPath::State::kNone;
  std::vector<logic::Fact> facts;  ///< Only with kFound.
  std::string message;  ///< Of what is wrong with the latches; then nothing is concluded.
};

/// A contract that a planner can meet. What it planned stays from cycle to cycle, until it no
/// longer fits what the latches say.
class Job {
 public:
  virtual ~Job() = default;
  virtual Verdict Decide(const LatchFacts& latches, Effort& effort) = 0;
};

/// Where to push: in pose, destination; out object, distance, direction.
std::unique_ptr<Job> MakeSeekJob(const JobSetup& setup, const sdk::Body& body,
                                 logic::SymbolTable& symbols);
/// Which landmark comes next: in place, building, doors, goal, elevators; out target_landmark.
std::unique_ptr<Job> MakeItineraryJob(const JobSetup& setup, logic::SymbolTable& symbols);
/// How to get there: in place, elevators, building, target; out move_cmd, call, ride.
std::unique_ptr<Job> MakeElevatorsJob(const JobSetup& setup, logic::SymbolTable& symbols);

}  // namespace latchwork::planning

#endif  // LATCHWORK_OMPL_LAYERS_JOB_H_

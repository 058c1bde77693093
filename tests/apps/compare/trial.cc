// SPDX-License-Identifier: BSD-3-Clause
#include "tests/apps/compare/trial.h"

#include "latchwork/sdk/svg.h"

namespace latchwork::compare {
namespace {

RunRecord MakeRun(const std::string& contender, std::uint64_t seed, Outcome outcome,
                  double time_s) {
  RunRecord run;
  run.key = {"floor", contender, seed};
  run.outcome = outcome;
  run.time_s = time_s;
  run.duration_s = 600;
  run.distance_m = 12.5;
  run.command = "latchwork run 'a & b.xml' --seed " + std::to_string(seed);
  run.message = outcome == Outcome::kReached ? "" : "hit <a wall>";
  run.trajectory = "1 1,1 2,1 2,2.5";
  run.layers = {{"avoid", "pttp", 10, 2.5, 0, 0, 0, 12, 11, 20}};
  return run;
}

FloorPlan MakePlan() {
  sdk::Svg svg({.x1 = -1, .y1 = 0, .x2 = 9, .y2 = 4}, 20);
  svg.Rectangle({0, 0}, {1, 1}, {.fill = "currentColor"});
  return *ReadPlan(svg.ToString());
}

}  // namespace

Trial::Trial(std::uint64_t seeds) {
  experiment.name = "trial";
  experiment.last_seed = seeds;
  experiment.scenarios = {{"floor", "floor.xml"}};
  for (const char* name : {"good", "twin", "slow", "bad"}) {
    experiment.contenders.push_back({name, {}, {}});
  }
  experiment.contenders.back().fragment = "bad.xml";
  experiment.contenders.back().settings = {"avoid.gain=0"};
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const double time = 100 + 3.0 * static_cast<double>(seed);
    for (const RunRecord& run : {MakeRun("good", seed, Outcome::kReached, time),
                                 MakeRun("twin", seed, Outcome::kReached, time),
                                 MakeRun("slow", seed, Outcome::kReached, time + 20),
                                 MakeRun("bad", seed, Outcome::kCollision, time)}) {
      records.emplace(run.key, run);
    }
  }
  findings = Evaluate(experiment, records);
  buildings["floor"] = {{1, MakePlan()}};
}

ReportInput Trial::Input() const {
  return {experiment,
          records,
          findings,
          buildings,
          {"latchwork compare trial.xml", "latchwork", "1.2.3"}};
}

}  // namespace latchwork::compare

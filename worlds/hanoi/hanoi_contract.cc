// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/hanoi/hanoi_contract.h"

#include <utility>

#include "latchwork/sdk/specs.h"

namespace latchwork::hanoi {
namespace {

using sdk::ArgumentSpec;
using sdk::ArgumentType;
using sdk::ParameterSpec;
using sdk::ParameterType;
using sdk::PortSpec;
using sdk::RealParameter;

const ArgumentSpec kDisk{"disk", ArgumentType::kInteger, ""};
const ArgumentSpec kPeg{"peg", ArgumentType::kSymbol, ""};

}  // namespace

sdk::Contract HanoiContract() {
  PortSpec arm{.name = "arm",
               .predicates = {{"move_to", {kPeg}, "to the side, while raised only"},
                              {"lower", {}, "onto what is below"},
                              {"raise", {}, "all the way up"},
                              {"grasp", {}, "when down: the topmost disk"},
                              {"release", {}, "when down: what is held"}},
               .help = "what the gripper does, as long as it is told; the first of several counts",
               .optional = true};
  PortSpec task{.name = "task",
                .predicates = {{"disks", {{"count", ArgumentType::kInteger, ""}}, "1 is smallest"},
                               {"peg", {kPeg}, "there are three: left, middle, right"},
                               {"target", {kPeg}, "all disks have to come there"}},
                .help = "the puzzle; at tick 0"};
  PortSpec camera{.name = "camera",
                  .predicates = {{"on_peg", {kDisk, kPeg}, "where a disk is that is not held"},
                                 {"topmost", {kPeg, kDisk}, "of a peg that is not empty"}},
                  .help = "the position; when it changes"};
  PortSpec gripper{.name = "gripper",
                   .predicates = {{"above", {kPeg}, "right above this peg"},
                                  {"raised", {}, "all the way up"},
                                  {"down", {}, "standing on a disk or on the base"},
                                  {"holds", {kDisk}, "between its fingers"}},
                   .help = "how the gripper stands; every tick"};
  return {.inputs = {std::move(arm)},
          .outputs = {std::move(task), std::move(camera), std::move(gripper)}};
}

std::vector<ParameterSpec> HanoiParameters() {
  return {
      sdk::IntegerParameter("disks", "5", 1, 12, "in the puzzle"),
      {.name = "start",
       .type = ParameterType::kText,
       .default_value = "tower",
       .unit = "",
       .help = "'tower': all on the left; 'random': any position, by seed; or a letter l, m, r "
               "for the peg of every disk, from the smallest",
       .choices = {}},
      {.name = "target",
       .type = ParameterType::kText,
       .default_value = "right",
       .unit = "",
       .help = "the peg to bring all disks to",
       .choices = {"left", "middle", "right"}},
      RealParameter("hand_every", "0", 0, 1e6, "s", "mean time between moves of a hand; 0: none"),
      RealParameter("slip", "0", 0, 0.9, "", "probability that closing fingers find no hold"),
      RealParameter("travel_speed", "0.5", 0.01, 10, "m/s", "of the gripper, to the side"),
      RealParameter("lift_speed", "0.5", 0.01, 10, "m/s", "of the gripper, up and down"),
      RealParameter("grip_time", "0.3", 0, 60, "s", "to close and to open the fingers")};
}

std::vector<sdk::PredicateSpec> HanoiEvents() {
  return {{"hand_moves", {kDisk, kPeg}, "a hand puts the disk onto the peg, as the rules allow"}};
}

}  // namespace latchwork::hanoi

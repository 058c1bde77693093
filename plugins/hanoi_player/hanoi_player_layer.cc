// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/hanoi_player/hanoi_player_layer.h"

#include <utility>

#include "latchwork/sdk/contract_body.h"

namespace latchwork::hanoi_player {
namespace {

using sdk::ArgumentSpec;
using sdk::ArgumentType;
using sdk::PortSpec;

const ArgumentSpec kDisk{"disk", ArgumentType::kInteger, ""};
const ArgumentSpec kPeg{"peg", ArgumentType::kSymbol, ""};

sdk::Contract MakeContract() {
  PortSpec task{.name = "task",
                .predicates = {{"disks", {{"count", ArgumentType::kInteger, ""}}, "1 is smallest"},
                               {"peg", {kPeg}, "one of the three"},
                               {"target", {kPeg}, "all disks have to come there"}},
                .help = "the puzzle"};
  PortSpec camera{.name = "camera",
                  .predicates = {{"on_peg", {kDisk, kPeg}, "where a disk is that is not held"},
                                 {"topmost", {kPeg, kDisk}, "of a peg that is not empty"}},
                  .help = "the position"};
  PortSpec gripper{.name = "gripper",
                   .predicates = {{"above", {kPeg}, "right above this peg"},
                                  {"raised", {}, "all the way up"},
                                  {"down", {}, "standing on a disk or on the base"},
                                  {"holds", {kDisk}, "between its fingers"}},
                   .help = "how the gripper stands"};
  PortSpec arm{.name = "arm",
               .predicates = {{"move_to", {kPeg}, "to the side"},
                              {"lower", {}, "onto what is below"},
                              {"raise", {}, "all the way up"},
                              {"grasp", {}, "the topmost disk"},
                              {"release", {}, "what is held"}},
               .help = "what the gripper does next"};
  return {{std::move(task), std::move(camera), std::move(gripper)}, {std::move(arm)}};
}

}  // namespace

const sdk::Contract& HanoiPlayerLayer::contract() const {
  static const sdk::Contract contract = MakeContract();
  return contract;
}

sdk::Body HanoiPlayerLayer::MakeBody(std::string_view language,
                                     const sdk::Parameters& /*parameters*/,
                                     const std::filesystem::path& data,
                                     logic::SymbolTable& symbols) const {
  sdk::Body body = sdk::ContractBody(contract(), language, symbols);
  body.files = {data / "hanoi_player.icarus"};
  return body;
}

}  // namespace latchwork::hanoi_player

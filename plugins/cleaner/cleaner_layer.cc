// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/cleaner/cleaner_layer.h"

#include <utility>

#include "latchwork/sdk/contract_body.h"
#include "latchwork/sdk/specs.h"
#include "plugins/cleaner/attachments.h"

namespace latchwork::cleaner {

namespace {

using sdk::IntegerArgument;
using sdk::ParameterSpec;
using sdk::PortSpec;
using sdk::RealArgument;
using sdk::RealParameter;
using sdk::SymbolArgument;

sdk::Contract MakeContract() {
  PortSpec robot{
      .name = "robot",
      .predicates = {{"tile_size", {RealArgument("side", "m")}, "of a tile of the floor"},
                     {"dock",
                      {IntegerArgument("i"), IntegerArgument("j")},
                      "the tile of the dock"}},
      .help = "what the robot knows of itself"};
  PortSpec pose{.name = "pose",
                .predicates = {{"pose",
                                {RealArgument("x", "m"), RealArgument("y", "m"),
                                 RealArgument("heading", "rad")},
                                "of it"}},
                .help = "where the robot is"};
  PortSpec view{
      .name = "view",
      .predicates = {{"picture", {IntegerArgument("number")}, "counts them"},
                     {"row_in_view", {IntegerArgument("j")}, "a row with tiles in view"},
                     {"tile",
                      {IntegerArgument("i"), IntegerArgument("j"), SymbolArgument("state")},
                      "dirty, clean or blocked"}},
      .help = "the floor around the robot"};
  PortSpec ranges{.name = "ranges",
                  .predicates = {{"range",
                                  {IntegerArgument("sensor"), RealArgument("gap", "m")},
                                  "sensor 0 looks ahead"}},
                  .help = "how far it is to what stands there"};
  PortSpec touch{.name = "touch",
                 .predicates = {{"bump", {SymbolArgument("side")}, "ahead, left, right or behind"}},
                 .help = "what the rim touches"};
  PortSpec power{.name = "power",
                 .predicates = {{"battery", {RealArgument("charge", "")}, "1 full, 0 empty"},
                                {"charging", {}, "the robot stands on its dock"}},
                 .help = "how long it will last"};
  PortSpec motion{
      .name = "motion",
      .predicates = {{"drive",
                      {RealArgument("speed", "m/s"), RealArgument("turn_rate", "rad/s")},
                      "backwards < 0, to the left > 0"}},
      .help = "for the wheels; silent: stand"};
  return {{std::move(robot), std::move(pose), std::move(view), std::move(ranges), std::move(touch),
           std::move(power)},
          {std::move(motion)}};
}

}  // namespace

const sdk::Contract& CleanerLayer::contract() const {
  static const sdk::Contract contract = MakeContract();
  return contract;
}

std::span<const ParameterSpec> CleanerLayer::parameters() const {
  static const std::vector<ParameterSpec> parameters{
      RealParameter("cruise", "0.5", 0.1, 2, "m/s", "speed on a free way"),
      RealParameter("reserve", "0.08", 0, 1, "",
                    "part of the charge that is to be left at the dock"),
      RealParameter("charge_per_tile", "0.00125", 0, 1, "",
                    "part of the charge that a tile of the way home takes, turns included"),
      RealParameter("watch_below", "0.6", 0, 1, "",
                    "charge below which it keeps in mind how far it is from home"),
      RealParameter("full", "0.97", 0, 1, "", "charge with which it goes back to work")};
  return parameters;
}

sdk::Body CleanerLayer::MakeBody(std::string_view language, const sdk::Parameters& parameters,
                                 const std::filesystem::path& data,
                                 logic::SymbolTable& symbols) const {
  sdk::Body body = sdk::ContractBody(contract(), language, symbols);
  body.files = {data / "cleaner.icarus"};
  body.facts = sdk::ParameterFacts(parameters, symbols);
  body.attachments = MakeAttachments(symbols);
  return body;
}

}  // namespace latchwork::cleaner

// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/gardener/gardener_layer.h"

#include <utility>

#include "latchwork/sdk/contract_body.h"
#include "latchwork/sdk/specs.h"

namespace latchwork::gardener {

namespace {

using sdk::IntegerArgument;
using sdk::ParameterSpec;
using sdk::PortSpec;
using sdk::RealArgument;
using sdk::RealParameter;
using sdk::SymbolArgument;

PortSpec Clock() {
  return {"clock",
          {{"day", {IntegerArgument("day")}, "of the season"},
           {"hour", {RealArgument("hour", "h")}, "since midnight"},
           {"working", {}, "it is working time"}},
          "what time it is"};
}

PortSpec Forecast() {
  return {"forecast",
          {{"rain_expected",
            {IntegerArgument("days_ahead"), RealArgument("rain", "mm")},
            "of the whole day: 0 today, 1 tomorrow"},
           {"low_expected", {RealArgument("degrees", "C")}, "in the coming night"}},
          "the weather to come"};
}

PortSpec Beds() {
  return {
      "beds",
      {{"soil", {SymbolArgument("bed"), RealArgument("moisture", "")}, "0 dry, 1 full of water"},
       {"covered", {SymbolArgument("bed")}, "it lies under its cover"}},
      "how the beds are"};
}

PortSpec Inspection() {
  return {
      "inspection",
      {{"at", {SymbolArgument("place")}, "where the gardener is"},
       {"food", {SymbolArgument("bed"), RealArgument("food", "g")}, "in the soil of the bed here"}},
      "what it sees where it is"};
}

PortSpec Stock() {
  return {"stock",
          {{"tank", {RealArgument("water", "l")}, "that it carries"},
           {"barrel", {RealArgument("water", "l")}, "at the well"},
           {"portions", {IntegerArgument("portions")}, "of food that are left"}},
          "what there is to give"};
}

PortSpec Work() {
  return {"work",
          {{"walk", {SymbolArgument("place")}, "to a bed or to the well"},
           {"fill", {}, "the tank, at the well"},
           {"pour", {}, "water on the bed here"},
           {"feed", {}, "the bed here"},
           {"cover", {}, "the bed here"},
           {"uncover", {}, "the bed here"}},
          "what the gardener does now; silent: it rests"};
}

sdk::Contract MakeContract() {
  PortSpec map{"map",
               {{"bed", {SymbolArgument("bed"), RealArgument("way", "m")}, "how far it is"}},
               "where the beds are"};
  PortSpec weather{"weather",
                   {{"sky", {SymbolArgument("sky")}, "sun, cloud or rain"},
                    {"temperature", {RealArgument("degrees", "C")}, "of the air"}},
                   "the weather now"};
  return {{std::move(map), Clock(), std::move(weather), Forecast(), Beds(), Inspection(), Stock()},
          {Work()}};
}

}  // namespace

const sdk::Contract& GardenerLayer::contract() const {
  static const sdk::Contract contract = MakeContract();
  return contract;
}

std::span<const ParameterSpec> GardenerLayer::parameters() const {
  static const std::vector<ParameterSpec> parameters{
      RealParameter("water_below", "0.5", 0, 1, "", "moisture below which a bed is thirsty"),
      RealParameter("water_to", "0.62", 0, 1, "", "moisture that a thirsty bed is watered to"),
      RealParameter("feed_below", "32", 0, 100, "g", "food below which a bed is hungry"),
      RealParameter("frost_margin", "2.5", 0, 20, "C",
                    "beds are covered when the forecast for the night is not above this"),
      RealParameter("cover_from", "16", 0, 24, "h",
                    "hour from which beds are covered for the night")};
  return parameters;
}

sdk::Body GardenerLayer::MakeBody(std::string_view language, const sdk::Parameters& parameters,
                                  const std::filesystem::path& data,
                                  logic::SymbolTable& symbols) const {
  sdk::Body body = sdk::ContractBody(contract(), language, symbols);
  body.files = {data / "gardener.icarus"};
  body.facts = sdk::ParameterFacts(parameters, symbols);
  return body;
}

}  // namespace latchwork::gardener

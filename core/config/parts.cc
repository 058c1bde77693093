// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "core/config/agent_check.h"

namespace latchwork::config {
namespace {

std::string FirstAt(const logic::SourcePlace& place) {
  return fmt::format("the first is at {}:{}", place.file, place.line);
}

void CheckWorld(AgentCheck& check, const Element& element) {
  WorldDescription& world = check.agent.world;
  world.place = element.place;
  const Attribute* plugin = element.Find("plugin");
  if (plugin == nullptr) return;
  world.plugin = plugin->value;
  check.world = check.FindPlugin(sdk::PluginKind::kWorld, *plugin);
  if (!check.world) return;
  world.parameters =
      CheckParameters(check, element, *check.world, fmt::format("world '{}'", world.plugin));
}

void CheckTiming(AgentCheck& check, const Element& element, LayerDescription& layer) {
  const auto read = [&](std::string_view name, std::uint64_t& ticks) {
    const Attribute* attribute = element.Find(name);
    if (attribute == nullptr) return;
    if (const auto value = check.Ticks(*attribute)) ticks = *value;
  };
  read("period", layer.period);
  read("phase", layer.phase);
  read("latency", layer.latency);
  if (layer.period == 0) {
    check.Say(element.Find("period")->place, "a period must not be zero",
              "use the tick or a multiple of it");
    layer.period = 1;
  }
}

void CheckName(AgentCheck& check, const Attribute& name) {
  if (name.value == "world") {
    check.Say(name.place, "the name 'world' is reserved for the world",
              "give the layer another name");
  }
  const auto& layers = check.agent.layers;
  const auto first = std::ranges::find(layers, name.value, &LayerDescription::name);
  if (first != layers.end()) {
    check.Say(name.place, fmt::format("two layers are called '{}'", name.value),
              FirstAt(first->place));
  }
}

void CheckLayer(AgentCheck& check, const Element& element) {
  LayerDescription layer;
  layer.place = element.place;
  if (const Attribute* name = element.Find("name")) {
    CheckName(check, *name);
    layer.name = name->value;
  } else {
    check.is_whole = false;
  }
  CheckTiming(check, element, layer);
  std::optional<PluginFacts> facts;
  if (const Attribute* plugin = element.Find("plugin")) {
    layer.plugin = plugin->value;
    facts = check.FindPlugin(sdk::PluginKind::kLayer, *plugin);
  }
  if (facts) {
    layer.parameters =
        CheckParameters(check, element, *facts, fmt::format("layer '{}'", layer.name));
  }
  CheckReasoner(check, element, layer, facts);
  CheckMinimized(check, element, layer);
  CheckFallback(check, element, layer, facts);
  check.agent.layers.push_back(std::move(layer));
  check.layers.push_back(std::move(facts));
}

}  // namespace

sdk::Parameters CheckParameters(AgentCheck& check, const Element& element, const PluginFacts& facts,
                                const std::string& owner) {
  std::vector<sdk::Parameters::Given> given;
  bool is_whole = true;
  for (const Element& child : element.children) {
    const Attribute* name = child.Find("name");
    const Attribute* value = child.Find("value");
    if (child.name != "param") continue;
    if (name == nullptr || value == nullptr) {
      is_whole = false;
    } else {
      const bool is_known = std::ranges::find(facts.parameters, name->value,
                                              &sdk::ParameterSpec::name) != facts.parameters.end();
      given.push_back({name->value, value->value, is_known ? value->place : name->place});
    }
  }
  logic::Diagnostics found;
  auto parameters = sdk::Parameters::Check(facts.parameters, given, owner, element.place, found);
  for (auto& diagnostic : found) {
    const bool is_about_element = diagnostic.place.line == element.place.line &&
                                  diagnostic.place.column == element.place.column;
    if (is_whole || !is_about_element) check.diagnostics.push_back(std::move(diagnostic));
  }
  return parameters;
}

void CheckParts(AgentCheck& check, const std::vector<Element>& elements) {
  const Element* world = nullptr;
  std::size_t layers = 0;
  for (const Element& element : elements) {
    if (element.name == "world" && world != nullptr) {
      check.Say(element.place, "an agent lives in one world, this is a second one",
                FirstAt(world->place));
    } else if (element.name == "world") {
      world = &element;
      CheckWorld(check, element);
    } else if (element.name == "layer") {
      if (++layers <= kMaxLayers) CheckLayer(check, element);
    }
  }
  if (layers > kMaxLayers) {
    check.is_whole = false;
    check.Say(
        check.agent.layers.back().place,
        fmt::format("this is the last layer that fits: there are {}, and at most {} are allowed",
                    layers, kMaxLayers));
  }
  if (!check.is_whole) return;
  const logic::SourcePlace whole{check.agent.file.string(), 0, 0};
  if (world == nullptr) check.Say(whole, "there is no <world>", "add <world plugin=\"…\"/>");
  if (layers == 0) check.Say(whole, "there is no <layer>", "an agent has at least one");
}

}  // namespace latchwork::config

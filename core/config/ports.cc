// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "core/config/agent_check.h"

namespace latchwork::config {
namespace {

const std::vector<sdk::PortSpec>& PortsOf(const sdk::Contract& contract, PortSide side) {
  return side == PortSide::kOutput ? contract.outputs : contract.inputs;
}

std::optional<std::size_t> IndexOf(const std::vector<sdk::PortSpec>& ports, std::string_view name) {
  const auto found = std::ranges::find(ports, name, &sdk::PortSpec::name);
  if (found == ports.end()) return std::nullopt;
  return static_cast<std::size_t>(found - ports.begin());
}

std::string_view SideName(PortSide side, std::size_t part) {
  if (part == PortAddress::kWorld) return side == PortSide::kOutput ? "sensor" : "effector";
  return side == PortSide::kOutput ? "output" : "input";
}

void SayUnknownPort(AgentCheck& check, const Attribute& attribute, std::size_t part,
                    std::string_view port, PortSide side) {
  const sdk::Contract& contract = check.FactsOf(part)->contract;
  const PortSide other = side == PortSide::kOutput ? PortSide::kInput : PortSide::kOutput;
  const std::vector<std::string> names = NamesOf(PortsOf(contract, side));
  if (IndexOf(PortsOf(contract, other), port)) {
    check.Say(attribute.place,
              fmt::format("'{}' is an {}, but '{}' takes an {}", attribute.value,
                          other == PortSide::kOutput ? "output" : "input", attribute.name,
                          side == PortSide::kOutput ? "output" : "input"),
              fmt::format("facts leave by outputs and sensors and enter by inputs and effectors"));
    return;
  }
  check.Say(attribute.place,
            fmt::format("'{}' has no {} '{}'", check.NameOf(part), SideName(side, part), port),
            NameHint(port, names));
}

}  // namespace

std::vector<std::string> PartNames(const AgentCheck& check) {
  std::vector<std::string> names = NamesOf(check.agent.layers);
  names.insert(names.begin(), "world");
  return names;
}

std::optional<std::size_t> FindPart(const AgentCheck& check, std::string_view name) {
  if (name == "world") return PortAddress::kWorld;
  const auto& layers = check.agent.layers;
  const auto found = std::ranges::find(layers, name, &LayerDescription::name);
  if (found == layers.end()) return std::nullopt;
  return static_cast<std::size_t>(found - layers.begin());
}

std::optional<FoundPort> FindPort(AgentCheck& check, const Attribute* attribute, PortSide side) {
  if (attribute == nullptr) return std::nullopt;
  const std::string_view text = attribute->value;
  const std::size_t dot = text.find('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const std::string_view part_name = text.substr(0, dot);
  const std::string_view port_name = text.substr(dot + 1);
  const auto part = FindPart(check, part_name);
  if (!part) {
    if (check.is_whole) {
      check.Say(attribute->place, fmt::format("there is no part '{}'", part_name),
                NameHint(part_name, PartNames(check)));
    }
    return std::nullopt;
  }
  const PluginFacts* facts = check.FactsOf(*part);
  if (facts == nullptr) return FoundPort{{*part, 0}, nullptr};
  const auto& ports = PortsOf(facts->contract, side);
  if (const auto port = IndexOf(ports, port_name)) return FoundPort{{*part, *port}, &ports[*port]};
  SayUnknownPort(check, *attribute, *part, port_name, side);
  return std::nullopt;
}

}  // namespace latchwork::config

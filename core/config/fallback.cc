// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "core/config/agent_check.h"

namespace latchwork::config {
namespace {

void CheckFact(AgentCheck& check, const Element& element, const sdk::Contract& contract,
               LayerDescription& layer) {
  const Attribute* name = element.Find("port");
  if (name == nullptr) return;
  const auto port = std::ranges::find(contract.outputs, name->value, &sdk::PortSpec::name);
  if (port == contract.outputs.end()) {
    check.Say(name->place, fmt::format("'{}' has no output '{}'", layer.name, name->value),
              NameHint(name->value, NamesOf(contract.outputs)));
    return;
  }
  auto fact = check.ReadFact(element.text, element.place, port->predicates,
                             fmt::format("the output '{}.{}'", layer.name, port->name));
  if (!fact) return;
  layer.fallback->push_back(
      {static_cast<std::size_t>(port - contract.outputs.begin()), *std::move(fact)});
}

}  // namespace

void CheckFallback(AgentCheck& check, const Element& layer, LayerDescription& description,
                   const std::optional<PluginFacts>& facts) {
  for (const Element& child : layer.children) {
    if (child.name != "fallback") continue;
    description.fallback.emplace();
    if (!facts) continue;
    for (const Element& fact : child.children) {
      if (fact.name == "fact") CheckFact(check, fact, facts->contract, description);
    }
  }
}

}  // namespace latchwork::config

// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "core/config/agent_check.h"

namespace latchwork::config {

void CheckEvents(AgentCheck& check, const std::vector<Element>& elements) {
  for (const Element& element : elements) {
    if (element.name != "event" || check.HasEnough()) continue;
    const Attribute* at = element.Find("at");
    const Attribute* text = element.Find("fact");
    const auto tick = at == nullptr ? std::nullopt : check.Ticks(*at);
    if (text == nullptr || !check.world) continue;
    auto fact = check.ReadFact(text->value, text->place, check.world->events,
                               "the world '" + check.agent.world.plugin + "'");
    if (fact && tick) check.agent.events.push_back({*tick, *std::move(fact), element.place});
  }
  std::ranges::stable_sort(check.agent.events, {}, &Event::tick);
}

}  // namespace latchwork::config

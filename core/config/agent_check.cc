// SPDX-License-Identifier: BSD-3-Clause
#include "core/config/agent_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/config/duration.h"

namespace latchwork::config {
namespace {

std::string_view KindName(sdk::PluginKind kind) {
  switch (kind) {
    case sdk::PluginKind::kLayer:
      return "layer";
    case sdk::PluginKind::kReasoner:
      return "reasoner";
    case sdk::PluginKind::kWorld:
      return "world";
  }
  return "";
}

}  // namespace

std::string NameHint(std::string_view word, const std::vector<std::string>& known) {
  if (known.empty()) return "there are none";
  const std::string_view nearest = logic::NearestName(word, known);
  return nearest.empty() ? fmt::format("there are {}", fmt::join(known, ", "))
                         : fmt::format("did you mean '{}'?", nearest);
}

std::optional<PluginFacts> AgentCheck::FindPlugin(sdk::PluginKind kind, const Attribute& name) {
  std::string error;
  std::optional<PluginFacts> facts = catalog.find(kind, name.value, error);
  if (facts) return facts;
  plugin_failure = true;
  if (error.empty()) {
    Say(name.place, fmt::format("there is no {} plugin '{}'", KindName(kind), name.value),
        NameHint(name.value, catalog.names(kind)));
  } else {
    Say(name.place,
        fmt::format("the {} plugin '{}' cannot be loaded: {}", KindName(kind), name.value, error));
  }
  return std::nullopt;
}

std::optional<std::uint64_t> AgentCheck::Ticks(const Attribute& duration) {
  const std::optional<std::uint64_t> microseconds = ParseDuration(duration.value);
  const std::uint64_t tick = agent.tick_us;
  if (!microseconds || tick == 0) return std::nullopt;
  if (*microseconds % tick == 0) return *microseconds / tick;
  const std::uint64_t below = *microseconds / tick * tick;
  const std::string above = FormatDuration(below + tick);
  Say(duration.place,
      fmt::format("{} '{}' is no multiple of the tick ({})", duration.name, duration.value,
                  FormatDuration(tick)),
      below == 0 ? fmt::format("use {}", above)
                 : fmt::format("use {} or {}", FormatDuration(below), above));
  return std::nullopt;
}

const PluginFacts* AgentCheck::FactsOf(std::size_t part) const {
  const auto& facts = part == PortAddress::kWorld ? world : layers[part];
  return facts ? &*facts : nullptr;
}

std::string AgentCheck::NameOf(std::size_t part) const {
  return part == PortAddress::kWorld ? "world" : agent.layers[part].name;
}

}  // namespace latchwork::config

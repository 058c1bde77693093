// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/record/journal_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/record/build_id.h"

namespace latchwork::record {
namespace {

void AddPlugin(const plugin::Registry& registry, sdk::PluginKind kind, const std::string& name,
               std::vector<JournalHeader::Plugin>& plugins) {
  JournalHeader::Plugin entry{std::string(plugin::Name(kind)), name,
                              registry.Fingerprint(kind, name)};
  if (std::find(plugins.begin(), plugins.end(), entry) == plugins.end()) {
    plugins.push_back(std::move(entry));
  }
}

void Compare(std::string_view what, std::string_view recorded, std::string_view now,
             std::vector<std::string>& differences) {
  if (recorded == now) return;
  differences.push_back(fmt::format("{}: journal '{}', now '{}'", what, recorded, now));
}

std::string Text(const std::vector<config::Override>& overrides) {
  std::string text;
  for (const config::Override& each : overrides) {
    text += fmt::format("{}{}.{}={}", text.empty() ? "" : " ", each.part, each.name, each.value);
  }
  return text;
}

std::string FingerprintOf(const JournalHeader& header, const JournalHeader::Plugin& plugin) {
  for (const JournalHeader::Plugin& each : header.plugins) {
    if (each.kind == plugin.kind && each.name == plugin.name) return each.fingerprint;
  }
  return "(none)";
}

}  // namespace

JournalHeader MakeHeader(const schedule::Agent& agent, const plugin::Registry& registry,
                         std::vector<config::Override> overrides,
                         const std::filesystem::path& scenario,
                         std::optional<std::uint64_t> max_ticks) {
  const config::AgentDescription& description = agent.description;
  JournalHeader header;
  header.agent = description.name;
  header.agent_file = description.file.string();
  header.scenario = scenario.string();
  header.config_fingerprint = description.fingerprint;
  header.seed = agent.seed;
  header.tick_us = description.tick_us;
  header.max_ticks = max_ticks.value_or(description.max_ticks);
  header.overrides = std::move(overrides);
  header.build = BuildId();
  header.libm = LibmFingerprint();
  AddPlugin(registry, sdk::PluginKind::kWorld, description.world.plugin, header.plugins);
  for (const config::LayerDescription& layer : description.layers) {
    header.layers.push_back(layer.name);
    AddPlugin(registry, sdk::PluginKind::kLayer, layer.plugin, header.plugins);
    AddPlugin(registry, sdk::PluginKind::kReasoner, layer.reasoner.plugin, header.plugins);
  }
  return header;
}

std::vector<std::string> Differences(const JournalHeader& recorded, const JournalHeader& now) {
  std::vector<std::string> differences;
  Compare("agent", recorded.agent, now.agent, differences);
  Compare("fingerprint of the agent file", recorded.config_fingerprint, now.config_fingerprint,
          differences);
  Compare("seed", std::to_string(recorded.seed), std::to_string(now.seed), differences);
  Compare("overrides", Text(recorded.overrides), Text(now.overrides), differences);
  for (const JournalHeader::Plugin& each : recorded.plugins) {
    Compare(fmt::format("fingerprint of {} plugin {}", each.kind, each.name), each.fingerprint,
            FingerprintOf(now, each), differences);
  }
  Compare("build", recorded.build, now.build, differences);
  Compare("mathematics library", recorded.libm, now.libm, differences);
  return differences;
}

}  // namespace latchwork::record

// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/config/agent.h"

#include <utility>

#include "core/config/agent_check.h"
#include "core/config/document.h"
#include "core/config/duration.h"
#include "core/config/repeats.h"

namespace latchwork::config {
namespace {

void CheckRoot(AgentCheck& check, const Element& root) {
  AgentDescription& agent = check.agent;
  if (const Attribute* name = root.Find("name")) agent.name = name->value;
  if (const Attribute* tick = root.Find("tick")) {
    const auto microseconds = ParseDuration(tick->value);
    if (microseconds == std::uint64_t{0}) check.Say(tick->place, "a tick must not be zero");
    agent.tick_us = microseconds.value_or(0);
  }
  if (const Attribute* duration = root.Find("duration")) {
    agent.max_ticks = check.Ticks(*duration).value_or(0);
    if (ParseDuration(duration->value) == std::uint64_t{0}) {
      check.Say(duration->place, "a run must not end at once");
    }
  }
}

void CheckAgent(AgentCheck& check, Document& document, const std::vector<Override>& overrides) {
  CheckRoot(check, document.root);
  for (const Element& element : document.elements) CheckRepeats(element, check.diagnostics);
  ApplyOverrides(check, document.elements, overrides);
  CheckParts(check, document.elements);
  CheckWires(check, document.elements);
  CheckInhibitions(check, document.elements);
  CheckEvents(check, document.elements);
}

}  // namespace

AgentFile ReadAgentFile(const std::filesystem::path& file, const Catalog& catalog,
                        const std::vector<Override>& overrides, logic::SymbolTable& symbols,
                        const std::vector<std::filesystem::path>& fragments) {
  Document document = ReadDocument(file, fragments);
  AgentCheck check{catalog, symbols,           {},           std::move(document.diagnostics),
                   false,   document.is_whole, std::nullopt, {}};
  check.agent.file = file;
  check.agent.fingerprint = document.fingerprint;
  if (document.is_agent) CheckAgent(check, document, overrides);
  Arrange(document.sources, check.diagnostics);
  AgentFile result{std::nullopt, std::move(check.diagnostics),
                   check.plugin_failure || !document.has_reader};
  if (result.diagnostics.empty()) result.agent = std::move(check.agent);
  return result;
}

}  // namespace latchwork::config

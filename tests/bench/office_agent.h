// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_BENCH_OFFICE_AGENT_H_
#define LATCHWORK_TESTS_BENCH_OFFICE_AGENT_H_

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/config/agent.h"
#include "latchwork/plugin/registry.h"
#include "latchwork/schedule/agent.h"

namespace latchwork {

inline plugin::Registry MakeRegistry() {
  return plugin::Registry({std::filesystem::path(LATCHWORK_BINARY_DIR) / "plugins"});
}

/// An agent of examples/office, its parts made; with a fragment of that folder on top, if one is
/// named.
inline std::optional<schedule::Agent> MakeAgent(const std::string& file,
                                                const plugin::Registry& registry,
                                                logic::SymbolTable& symbols, std::uint64_t seed,
                                                const std::string& fragment = "") {
  const auto folder = std::filesystem::path(LATCHWORK_SOURCE_DIR) / "examples/office";
  std::vector<std::filesystem::path> fragments;
  if (!fragment.empty()) fragments.push_back(folder / fragment);
  config::AgentFile read =
      config::ReadAgentFile(folder / file, schedule::MakeCatalog(registry), {}, symbols, fragments);
  if (!read.agent) return std::nullopt;
  return schedule::AssembleAgent(std::move(*read.agent), schedule::MakePartFactory(registry),
                                 symbols, seed)
      .agent;
}

}  // namespace latchwork

#endif  // LATCHWORK_TESTS_BENCH_OFFICE_AGENT_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SCHEDULE_AGENT_H_
#define LATCHWORK_SCHEDULE_AGENT_H_

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/config/agent.h"
#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/plugin/registry.h"
#include "latchwork/sdk/layer.h"
#include "latchwork/sdk/reasoner.h"
#include "latchwork/sdk/world.h"

namespace latchwork::schedule {

/// Where the parts of an agent come from: the plugins of a registry, or the fakes of a test.
struct PartFactory {
  std::function<plugin::Made<sdk::Layer>(std::string_view name)> layer;
  std::function<plugin::Made<sdk::Reasoner>(std::string_view name)> reasoner;
  std::function<plugin::Made<sdk::World>(std::string_view name)> world;
  /// The folder with the files of a plugin.
  std::function<std::filesystem::path(sdk::PluginKind kind, std::string_view name)> data_folder;
};

/// The plugins of a registry, which must outlive the factory.
PartFactory MakePartFactory(const plugin::Registry& registry);

/// What config::ReadAgentFile asks of the plugins of a registry, which must outlive the catalog.
config::Catalog MakeCatalog(const plugin::Registry& registry);

/// A layer whose reasoner has loaded its body. The members keep their plugins loaded.
struct AgentLayer {
  std::shared_ptr<sdk::Layer> layer;
  std::shared_ptr<sdk::Reasoner> reasoner;
  sdk::Body body;
  /// One list of facts per output port: what the layer says on a fault.
  std::vector<std::vector<logic::Fact>> fallback;
};

/// An agent that is ready to run. A run uses it up: bodies told, worlds stepped. Assemble it anew
/// for another.
struct Agent {
  config::AgentDescription description;
  std::uint64_t seed = 0;
  logic::SymbolTable* symbols = nullptr;  ///< Outlives the agent.
  std::shared_ptr<sdk::World> world;
  std::vector<AgentLayer> layers;  ///< As in the description.
};

struct AssembledAgent {
  std::optional<Agent> agent;  ///< Only when `diagnostics` is empty.
  logic::Diagnostics diagnostics;
  bool plugin_failure = false;  ///< A part could not be made (exit code 4).
};

/// Makes the parts of a checked agent and loads the bodies and the world. All diagnostics of all
/// parts at once; what a part throws while it loads becomes one, too.
AssembledAgent AssembleAgent(config::AgentDescription description, const PartFactory& factory,
                             logic::SymbolTable& symbols, std::uint64_t seed);

}  // namespace latchwork::schedule

#endif  // LATCHWORK_SCHEDULE_AGENT_H_

// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/schedule/contain.h"
#include "core/schedule/port_contract.h"
#include "latchwork/schedule/agent.h"

namespace latchwork::schedule {
namespace {

/// What the agent file says of predicates goes before what the layer says.
void SetRoles(const config::LayerDescription& description, sdk::Body& body) {
  if (!description.minimized.empty()) body.minimized = description.minimized;
  if (!description.fixed.empty()) body.fixed = description.fixed;
  std::erase_if(body.minimized, [&](const sdk::Minimized& each) {
    const auto is_it = [&](const logic::PredicateName& name) { return name == each.predicate; };
    return std::ranges::any_of(description.varied, is_it) || std::ranges::any_of(body.fixed, is_it);
  });
  std::erase_if(body.fixed, [&](const logic::PredicateName& name) {
    return std::ranges::find(description.varied, name) != description.varied.end();
  });
}

/// Collects the parts of an agent and everything that is wrong with them.
class Assembly {
 public:
  Assembly(const PartFactory& factory, Agent& agent, AssembledAgent& result)
      : factory_(factory), agent_(agent), result_(result) {}

  void MakeWorld();
  void MakeLayer(const config::LayerDescription& description);

 private:
  template <typename Base>
  std::shared_ptr<Base> Take(plugin::Made<Base> made, const logic::SourcePlace& place);
  void Add(const logic::SourcePlace& place, std::string message);
  template <typename Call>
  void Try(std::string_view plugin, const logic::SourcePlace& place, Call&& call);
  void Load(const config::LayerDescription& description, AgentLayer& layer);
  bool CheckGoals(const config::LayerDescription& description, const AgentLayer& layer);
  void TakeFallback(const config::LayerDescription& description, AgentLayer& layer);

  const PartFactory& factory_;
  Agent& agent_;
  AssembledAgent& result_;
};

void Assembly::Add(const logic::SourcePlace& place, std::string message) {
  result_.diagnostics.push_back({place, std::move(message), "", ""});
}

template <typename Base>
std::shared_ptr<Base> Assembly::Take(plugin::Made<Base> made, const logic::SourcePlace& place) {
  if (made.object == nullptr) {
    Add(place, made.error);
    result_.plugin_failure = true;
  }
  return std::move(made.object);
}

template <typename Call>
void Assembly::Try(std::string_view plugin, const logic::SourcePlace& place, Call&& call) {
  if (const auto thrown = Contain(std::forward<Call>(call))) {
    Add(place, fmt::format("plugin {} failed while it was loaded: {}", plugin, *thrown));
  }
}

void Assembly::MakeWorld() {
  const config::WorldDescription& description = agent_.description.world;
  agent_.world = Take(factory_.world(description.plugin), description.place);
  if (agent_.world == nullptr) return;
  sdk::WorldSetup setup;
  setup.seed = agent_.seed;
  setup.tick_seconds = static_cast<double>(agent_.description.tick_us) / 1e6;
  setup.data = factory_.data_folder(sdk::PluginKind::kWorld, description.plugin);
  setup.symbols = agent_.symbols;
  Try(description.plugin, description.place, [&] {
    for (auto& each : agent_.world->Load(setup, description.parameters)) {
      result_.diagnostics.push_back(std::move(each));
    }
  });
}

void Assembly::MakeLayer(const config::LayerDescription& description) {
  AgentLayer& layer = agent_.layers.emplace_back();
  layer.layer = Take(factory_.layer(description.plugin), description.place);
  layer.reasoner = Take(factory_.reasoner(description.reasoner.plugin), description.reasoner.place);
  if (layer.layer == nullptr || layer.reasoner == nullptr) return;
  Try(description.plugin, description.place, [&] {
    layer.body = layer.layer->MakeBody(
        description.language, description.parameters,
        factory_.data_folder(sdk::PluginKind::kLayer, description.plugin), *agent_.symbols);
    SetRoles(description, layer.body);
    TakeFallback(description, layer);
    if (CheckGoals(description, layer)) Load(description, layer);
  });
}

bool Assembly::CheckGoals(const config::LayerDescription& description, const AgentLayer& layer) {
  const auto& outputs = layer.layer->contract().outputs;
  bool good = true;
  for (const sdk::Goal& goal : layer.body.goals) {
    const bool known = goal.port < outputs.size() &&
                       PortContract(outputs[goal.port], *agent_.symbols).Declares(goal.pattern);
    if (known) continue;
    good = false;
    Add(description.place, fmt::format("layer plugin {}: its goal {} has no output port that "
                                       "declares {}",
                                       description.plugin, logic::ToString(goal.pattern),
                                       logic::ToString(logic::NameOf(goal.pattern))));
  }
  return good;
}

void Assembly::TakeFallback(const config::LayerDescription& description, AgentLayer& layer) {
  const auto& outputs = layer.layer->contract().outputs;
  layer.fallback.resize(outputs.size());
  const auto say = [&](std::size_t port, const logic::Fact& fact) {
    const std::string offence = port < outputs.size()
                                    ? PortContract(outputs[port], *agent_.symbols).Offence(fact)
                                    : fmt::format("there is no output port {}", port);
    if (offence.empty()) {
      layer.fallback[port].push_back(fact);
    } else {
      Add(description.place, fmt::format("layer {}: its fallback {} breaks its contract: {}",
                                         description.name, logic::ToString(fact), offence));
    }
  };
  if (description.fallback) {
    for (const auto& each : *description.fallback) say(each.port, each.fact);
    return;
  }
  for (const sdk::Fallback& each : layer.layer->fallbacks(*agent_.symbols)) {
    for (const logic::Fact& fact : each.facts) say(each.port, fact);
  }
}

void Assembly::Load(const config::LayerDescription& description, AgentLayer& layer) {
  Try(description.reasoner.plugin, description.reasoner.place, [&] {
    for (auto& each :
         layer.reasoner->Load(layer.body, description.reasoner.parameters, *agent_.symbols)) {
      result_.diagnostics.push_back(std::move(each));
    }
  });
}

}  // namespace

AssembledAgent AssembleAgent(config::AgentDescription description, const PartFactory& factory,
                             logic::SymbolTable& symbols, std::uint64_t seed) {
  AssembledAgent result;
  Agent agent;
  agent.description = std::move(description);
  agent.seed = seed;
  agent.symbols = &symbols;
  Assembly assembly(factory, agent, result);
  assembly.MakeWorld();
  for (const config::LayerDescription& layer : agent.description.layers) assembly.MakeLayer(layer);
  if (result.diagnostics.empty()) result.agent = std::move(agent);
  return result;
}

}  // namespace latchwork::schedule

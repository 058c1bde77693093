// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/icarus_layers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <utility>

#include "latchwork/config/agent.h"
#include "latchwork/plugin/plugin_search.h"
#include "latchwork/schedule/agent.h"
#include "latchwork/sdk/contract_body.h"

namespace latchwork::app {
namespace {

constexpr const char* kLanguage = "icarus";

/// The body as the layer makes it; what its contract asks for where it has no program of its own.
sdk::Body BodyOf(const sdk::Layer& layer, const sdk::Parameters& parameters,
                 const std::filesystem::path& data_folder, logic::SymbolTable& symbols) {
  const std::vector<std::string> languages = layer.languages();
  if (std::find(languages.begin(), languages.end(), kLanguage) != languages.end()) {
    return layer.MakeBody(kLanguage, parameters, data_folder, symbols);
  }
  sdk::Body body = sdk::ContractBody(layer.contract(), kLanguage, symbols);
  body.facts = sdk::ParameterFacts(parameters, symbols);
  return body;
}

}  // namespace

LayerToFulfil::LayerToFulfil(std::string name, std::shared_ptr<sdk::Layer> layer,
                             const sdk::Parameters& parameters,
                             const std::filesystem::path& data_folder, logic::SymbolTable& symbols)
    : name_(std::move(name)),
      layer_(std::move(layer)),
      symbols_(&symbols),
      body_(BodyOf(*layer_, parameters, data_folder, symbols)),
      facts_(icarus::FactsOf(body_)) {}

NamedLayer::NamedLayer(const std::string& plugin, const Context& context)
    : registry_(plugin::MakeSearchPath(context.plugin_folders, context.executable)) {
  plugin::Made<sdk::Layer> made = registry_.MakeLayer(plugin);
  error_ = made.error;
  if (!made.object) return;
  const auto parameters = sdk::Parameters::Defaults(made.object->parameters());
  layer_.emplace(plugin, std::move(made.object), parameters,
                 registry_.DataFolder(sdk::PluginKind::kLayer, plugin), symbols_);
}

logic::Diagnostic WrongIcarusLayer(const config::AgentDescription& agent, const std::string& wanted,
                                   std::string_view does) {
  std::vector<std::string> names;
  for (const config::LayerDescription& layer : agent.layers) {
    if (layer.name == wanted && layer.language == kLanguage) return {};
    if (layer.name == wanted) {
      return {layer.place,
              fmt::format("layer '{}' is driven by {}, but only icarus {}", wanted,
                          layer.reasoner.plugin, does),
              "give it <reasoner plugin=\"icarus\"/>, or name another layer", ""};
    }
    names.push_back(layer.name);
  }
  const std::string_view nearest = logic::NearestName(wanted, names);
  return {{agent.file.string(), 0, 0},
          fmt::format("there is no layer '{}'", wanted),
          nearest.empty() ? fmt::format("its layers: {}", fmt::join(names, ", "))
                          : fmt::format("did you mean '{}'?", nearest),
          ""};
}

int CheckIcarusLayer(const std::filesystem::path& agent, const std::string& layer,
                     const Context& context) {
  const plugin::Registry registry(
      plugin::MakeSearchPath(context.plugin_folders, context.executable));
  logic::SymbolTable symbols;
  config::AgentFile file =
      config::ReadAgentFile(agent, schedule::MakeCatalog(registry), {}, symbols);
  if (file.agent) {
    logic::Diagnostic wrong = WrongIcarusLayer(*file.agent, layer, "learns");
    if (!wrong.message.empty()) file.diagnostics.push_back(std::move(wrong));
  }
  if (file.diagnostics.empty()) return kDone;
  fmt::print(stderr, "{}", logic::Format(file.diagnostics));
  return file.plugin_failure ? kPluginFailure : kInvalidInput;
}

ProgramsOfAgent::ProgramsOfAgent(const std::string& agent, const std::string& scenario,
                                 const Context& context)
    : registry_(plugin::MakeSearchPath(context.plugin_folders, context.executable)) {
  std::vector<std::filesystem::path> fragments;
  if (!scenario.empty()) fragments.emplace_back(scenario);
  config::AgentFile file =
      config::ReadAgentFile(agent, schedule::MakeCatalog(registry_), {}, symbols_, fragments);
  diagnostics_ = std::move(file.diagnostics);
  plugin_failure_ = file.plugin_failure;
  if (!file.agent) return;
  for (const config::LayerDescription& layer : file.agent->layers) {
    if (layer.language != kLanguage) continue;
    plugin::Made<sdk::Layer> made = registry_.MakeLayer(layer.plugin);
    if (!made.object) {
      diagnostics_.push_back({layer.place, made.error, "", ""});
      plugin_failure_ = true;
      continue;
    }
    layers_.emplace_back(layer.name, std::move(made.object), layer.parameters,
                         registry_.DataFolder(sdk::PluginKind::kLayer, layer.plugin), symbols_);
  }
}

}  // namespace latchwork::app

// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <utility>

#include "core/schedule/contain.h"
#include "latchwork/schedule/agent.h"

namespace latchwork::schedule {
namespace {

using config::PluginFacts;
using sdk::PluginKind;

template <typename Base>
std::optional<PluginFacts> Describe(const plugin::Made<Base>& made, std::string& error,
                                    void (*describe)(const Base&, PluginFacts&)) {
  if (made.object == nullptr) {
    if (made.failure != plugin::MakeFailure::kUnknownName) error = made.error;
    return std::nullopt;
  }
  PluginFacts facts;
  const auto parameters = made.object->parameters();
  facts.parameters.assign(parameters.begin(), parameters.end());
  describe(*made.object, facts);
  return facts;
}

void DescribeLayer(const sdk::Layer& layer, PluginFacts& facts) {
  facts.contract = layer.contract();
  facts.languages = layer.languages();
}

void DescribeReasoner(const sdk::Reasoner& reasoner, PluginFacts& facts) {
  facts.languages.emplace_back(reasoner.language());
}

void DescribeWorld(const sdk::World& world, PluginFacts& facts) {
  facts.contract = world.contract();
  facts.events.assign(world.events().begin(), world.events().end());
}

std::optional<PluginFacts> Find(const plugin::Registry& registry, PluginKind kind,
                                std::string_view name, std::string& error) {
  switch (kind) {
    case PluginKind::kLayer:
      return Describe(registry.MakeLayer(name), error, DescribeLayer);
    case PluginKind::kReasoner:
      return Describe(registry.MakeReasoner(name), error, DescribeReasoner);
    case PluginKind::kWorld:
      return Describe(registry.MakeWorld(name), error, DescribeWorld);
  }
  return std::nullopt;
}

}  // namespace

PartFactory MakePartFactory(const plugin::Registry& registry) {
  return {
      [&registry](std::string_view name) { return registry.MakeLayer(name); },
      [&registry](std::string_view name) { return registry.MakeReasoner(name); },
      [&registry](std::string_view name) { return registry.MakeWorld(name); },
      [&registry](PluginKind kind, std::string_view name) {
        return registry.DataFolder(kind, name);
      },
  };
}

config::Catalog MakeCatalog(const plugin::Registry& registry) {
  return {
      [&registry](PluginKind kind) { return registry.Names(kind); },
      [&registry](PluginKind kind, std::string_view name, std::string& error) {
        std::optional<PluginFacts> facts;
        const auto thrown = Contain([&] { facts = Find(registry, kind, name, error); });
        if (thrown) error = "it failed while it described itself: " + *thrown;
        return facts;
      },
  };
}

}  // namespace latchwork::schedule

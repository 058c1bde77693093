// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/config/agent_check.h"

namespace latchwork::config {
namespace {

template <typename Number>
void ReadNumber(const Element& element, std::string_view name, Number& number) {
  const Attribute* attribute = element.Find(name);
  if (attribute == nullptr) return;
  const std::string& text = attribute->value;
  std::from_chars(text.data(), text.data() + text.size(), number);
}

/// The language in which layer and reasoner meet.
std::string CheckLanguage(AgentCheck& check, const Attribute& plugin, const PluginFacts& reasoner,
                          const PluginFacts& layer, const std::string& layer_name) {
  const bool reads_any = reasoner.languages.empty() || reasoner.languages.front().empty();
  if (reads_any) return layer.languages.empty() ? "" : layer.languages.front();
  for (const std::string& language : reasoner.languages) {
    if (std::ranges::find(layer.languages, language) != layer.languages.end()) return language;
  }
  check.Say(plugin.place,
            fmt::format("the reasoner '{}' reads {}, but layer '{}' has no body in it",
                        plugin.value, fmt::join(reasoner.languages, ", "), layer_name),
            layer.languages.empty()
                ? "the layer has no body at all"
                : fmt::format("it has bodies in {}", fmt::join(layer.languages, ", ")));
  return "";
}

}  // namespace

void CheckReasoner(AgentCheck& check, const Element& layer, LayerDescription& description,
                   const std::optional<PluginFacts>& facts) {
  const auto element = std::ranges::find(layer.children, "reasoner", &Element::name);
  if (element == layer.children.end()) {
    check.Say(layer.place, fmt::format("layer '{}' has no reasoner", description.name),
              "add <reasoner plugin=\"…\"/>");
    return;
  }
  const sdk::Budget budget;
  ReasonerDescription& reasoner = description.reasoner;
  reasoner.place = element->place;
  reasoner.inferences = budget.inferences;
  reasoner.depth = budget.depth;
  ReadNumber(*element, "inferences", reasoner.inferences);
  ReadNumber(*element, "depth", reasoner.depth);
  const Attribute* plugin = element->Find("plugin");
  if (plugin == nullptr) {
    check.Say(element->place,
              fmt::format("the reasoner of layer '{}' names no plugin", description.name),
              NameHint("", check.catalog.names(sdk::PluginKind::kReasoner)));
    return;
  }
  reasoner.plugin = plugin->value;
  const auto found = check.FindPlugin(sdk::PluginKind::kReasoner, *plugin);
  if (!found) return;
  reasoner.parameters = CheckParameters(
      check, *element, *found,
      fmt::format("reasoner '{}' of layer '{}'", reasoner.plugin, description.name));
  if (facts) {
    description.language = CheckLanguage(check, *plugin, *found, *facts, description.name);
  }
}

}  // namespace latchwork::config

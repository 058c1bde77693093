// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CONFIG_AGENT_CHECK_H_
#define LATCHWORK_CONFIG_AGENT_CHECK_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/config/agent.h"
#include "latchwork/config/xml.h"
#include "latchwork/logic/diagnostic.h"

namespace latchwork::config {

/// What the checks of one agent file share: what they know, what they have made so far, and what
/// they found. A check says nothing about what the schema has already caught (an attribute that is
/// missing or does not match), nor about what follows from another error.
struct AgentCheck {
  const Catalog& catalog;
  logic::SymbolTable& symbols;
  AgentDescription agent;
  logic::Diagnostics diagnostics;
  bool plugin_failure = false;
  bool is_whole = true;  ///< What is not there was not written; see Document.

  std::optional<PluginFacts> world;                ///< Nothing when the plugin cannot be had.
  std::vector<std::optional<PluginFacts>> layers;  ///< Beside agent.layers.

  void Say(const logic::SourcePlace& place, std::string message, std::string hint = "") {
    diagnostics.push_back({place, std::move(message), std::move(hint), ""});
  }

  /// More would not be shown, and finding hints for them would take long.
  bool HasEnough() const { return diagnostics.size() >= 1000; }

  /// The plugin's facts; reports one that is unknown or cannot be had.
  std::optional<PluginFacts> FindPlugin(sdk::PluginKind kind, const Attribute& name);
  /// A duration in ticks; reports one that is no multiple of the tick. Nothing when there is no
  /// such number.
  std::optional<std::uint64_t> Ticks(const Attribute& duration);
  /// An atom that is ground and one of the predicates; reports what else it is. `owner` says who
  /// understands those.
  std::optional<logic::Fact> ReadFact(std::string_view text, const logic::SourcePlace& place,
                                      std::span<const sdk::PredicateSpec> predicates,
                                      const std::string& owner);

  const PluginFacts* FactsOf(std::size_t part) const;
  std::string NameOf(std::size_t part) const;
};

/// "did you mean 'x'?", or what there is: "there are a, b", or "there are none".
std::string NameHint(std::string_view word, const std::vector<std::string>& known);

template <typename Items>
std::vector<std::string> NamesOf(const Items& items) {
  std::vector<std::string> names;
  names.reserve(items.size());
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

/// Merges <override> elements and command-line overrides into the world and layers that they
/// address.
void ApplyOverrides(AgentCheck& check, std::vector<Element>& elements,
                    const std::vector<Override>& overrides);

inline constexpr std::size_t kMaxLayers = 256;

/// The world, the layers, their plugins, parameters and reasoners.
void CheckParts(AgentCheck& check, const std::vector<Element>& elements);
void CheckReasoner(AgentCheck& check, const Element& layer, LayerDescription& description,
                   const std::optional<PluginFacts>& facts);
void CheckMinimized(AgentCheck& check, const Element& layer, LayerDescription& description);
void CheckFallback(AgentCheck& check, const Element& layer, LayerDescription& description,
                   const std::optional<PluginFacts>& facts);
sdk::Parameters CheckParameters(AgentCheck& check, const Element& element, const PluginFacts& facts,
                                const std::string& owner);

enum class PortSide : std::uint8_t { kOutput, kInput };

/// What a port's address stands for.
struct FoundPort {
  PortAddress address;
  const sdk::PortSpec* spec = nullptr;  ///< Null when the part's contract cannot be had.
};

/// Finds "part.port"; reports an unknown part or port, or one of the other side. `role` says what
/// it is for.
std::optional<FoundPort> FindPort(AgentCheck& check, const Attribute* attribute, PortSide side);
/// The index of a part by name; nothing when there is none.
std::optional<std::size_t> FindPart(const AgentCheck& check, std::string_view name);
std::vector<std::string> PartNames(const AgentCheck& check);

/// Why facts of `from` can never become facts of `to`; nothing when some can.
struct Mismatch {
  std::string message;
  std::string hint;
};
std::optional<Mismatch> Compare(const sdk::PortSpec& from, const sdk::PortSpec& to);

void CheckWires(AgentCheck& check, const std::vector<Element>& elements);
void CheckInhibitions(AgentCheck& check, const std::vector<Element>& elements);
void CheckEvents(AgentCheck& check, const std::vector<Element>& elements);

}  // namespace latchwork::config

#endif  // LATCHWORK_CONFIG_AGENT_CHECK_H_

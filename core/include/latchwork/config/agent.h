// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CONFIG_AGENT_H_
#define LATCHWORK_CONFIG_AGENT_H_

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/contract.h"
#include "latchwork/sdk/parameters.h"
#include "latchwork/sdk/plugin.h"
#include "latchwork/sdk/reasoner.h"

namespace latchwork::config {

/// What the checker must know of a plugin. Copied, so that it does not depend on the plugin staying
/// loaded.
struct PluginFacts {
  sdk::Contract contract;  ///< Layers and worlds.
  std::vector<sdk::ParameterSpec> parameters;
  std::vector<std::string>
      languages;  ///< Layers: bodies it has. Reasoners: the one it reads; "" = any.
  std::vector<sdk::PredicateSpec> events;  ///< Worlds.
};

/// Where the checker looks plugins up. Given by whoever can load them.
struct Catalog {
  std::function<std::vector<std::string>(sdk::PluginKind)> names;
  /// Nothing when the plugin cannot be had; then `error` says why, or stays empty when there is
  /// none of that name.
  std::function<std::optional<PluginFacts>(sdk::PluginKind, std::string_view name,
                                           std::string& error)>
      find;
};

struct WorldDescription {
  std::string plugin;
  sdk::Parameters parameters;
  logic::SourcePlace place;
};

struct ReasonerDescription {
  std::string plugin;
  sdk::Parameters parameters;
  std::uint64_t inferences = 0;  ///< Budget of one decision.
  std::uint32_t depth = 0;
  logic::SourcePlace place;
};

struct FallbackDescription {
  std::size_t port = 0;  ///< Output port of the layer.
  logic::Fact fact;
};

struct LayerDescription {
  std::string name;
  std::string plugin;
  std::uint64_t period = 1;   ///< Ticks between decisions.
  std::uint64_t phase = 0;    ///< Tick of the first decision.
  std::uint64_t latency = 0;  ///< Ticks until conclusions arrive.
  sdk::Parameters parameters;
  ReasonerDescription reasoner;
  std::string language;                      ///< Of the body that the reasoner reads.
  std::vector<sdk::Minimized> minimized;     ///< Replaces the body's own list when not empty.
  std::vector<logic::PredicateName> varied;  ///< Not minimized, whatever the body says.
  std::vector<logic::PredicateName> fixed;   ///< Replaces the body's own list when not empty.
  std::optional<std::vector<FallbackDescription>> fallback;  ///< Nothing: the layer's own.
  logic::SourcePlace place;
};

/// One end of a wire: the world or a layer, and a port of its contract.
struct PortAddress {
  static constexpr std::size_t kWorld = static_cast<std::size_t>(-1);
  std::size_t part = kWorld;  ///< kWorld, or an index into `layers`.
  std::size_t port = 0;       ///< From: an output (sensor). To: an input (effector).
  friend bool operator==(const PortAddress&, const PortAddress&) = default;
};

/// What a wire hands down besides proved goals. Source: LSA, section 3.3.
enum class Transfer : std::uint8_t {
  kSingle,   ///< Nothing: the paper's. Unsound where the layer below takes silence for a no.
  kOpen,     ///< Undecided goals, as such: what rests on either value is not concluded.
  kRefined,  ///< And the joint states that they may be in: as exact as logic has it.
};

/// Facts that leave by `from` replace what `to` holds. Predicates that `to` does not declare stay
/// behind.
struct Wire {
  PortAddress from;
  PortAddress to;
  std::optional<std::uint64_t>
      stale_after;  ///< Ticks without a new batch after which the latch is emptied.
  Transfer transfer = Transfer::kOpen;
  logic::SourcePlace place;
};

/// While the last batch of `by` holds facts (and is not older than `hold` ticks), nothing leaves by
/// `output`.
struct Inhibition {
  PortAddress by;
  PortAddress output;
  std::uint64_t hold = 1;
  logic::SourcePlace place;
};

struct Event {
  std::uint64_t tick = 0;
  logic::Fact fact;
  logic::SourcePlace place;
};

/// A checked agent file: everything resolved, nothing left to go wrong but plugins and their files.
struct AgentDescription {
  std::string name;
  std::filesystem::path file;
  std::string fingerprint;  ///< Of the text of the file and all its includes (hex).
  std::uint64_t tick_us = 100'000;
  std::uint64_t max_ticks = 0;
  WorldDescription world;
  std::vector<LayerDescription> layers;  ///< Layer 0 first.
  std::vector<Wire> wires;
  std::vector<Inhibition> inhibitions;
  std::vector<Event> events;  ///< By tick, then in file order.
};

/// A parameter given on the command line: `--set world.people=4`, `--set avoid.gain=2`.
struct Override {
  std::string part;  ///< "world", the name of a layer, or "LAYER.reasoner" (also for its inferences
                     ///< and depth).
  std::string name;
  std::string value;
};

struct AgentFile {
  std::optional<AgentDescription> agent;  ///< Only when `diagnostics` is empty.
  logic::Diagnostics diagnostics;
  bool plugin_failure = false;  ///< Some plugin, or the reader of XML files, cannot be loaded, or
                                ///< there is no plugin of its name (exit code 4).
};

/// Reads, validates and checks an agent file. All errors at once. `fragments` are files that come
/// on top, as if they were included at the end of the agent. Thread rule: safe from any thread, as
/// far as `catalog` is.
AgentFile ReadAgentFile(const std::filesystem::path& file, const Catalog& catalog,
                        const std::vector<Override>& overrides, logic::SymbolTable& symbols,
                        const std::vector<std::filesystem::path>& fragments = {});

/// The XSD that agent files are validated against.
std::string_view AgentSchema();

}  // namespace latchwork::config

#endif  // LATCHWORK_CONFIG_AGENT_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_RECORD_JOURNAL_HEADER_H_
#define LATCHWORK_RECORD_JOURNAL_HEADER_H_

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "latchwork/config/agent.h"
#include "latchwork/plugin/registry.h"
#include "latchwork/schedule/agent.h"

namespace latchwork::record {

/// Of the journal's format (docs/journal.md). A reader reads all versions up to its own.
inline constexpr std::uint64_t kJournalVersion = 1;

/// What a run is a function of, and what it takes to repeat it.
struct JournalHeader {
  struct Plugin {
    std::string kind;
    std::string name;
    std::string fingerprint;
    friend bool operator==(const Plugin&, const Plugin&) = default;
  };
  std::uint64_t version = kJournalVersion;
  std::string agent;
  std::string agent_file;          ///< As it was given, so usually relative to a folder of then.
  std::string scenario;            ///< A fragment on top of the agent file; empty for none.
  std::string config_fingerprint;  ///< Of the agent file and its includes.
  std::uint64_t seed = 0;
  std::uint64_t tick_us = 0;
  std::uint64_t max_ticks = 0;
  std::vector<config::Override> overrides;
  std::vector<Plugin> plugins;
  std::string build;  ///< Version, compiler and standard library of the core.
  std::string libm;   ///< Of what sin, cos, exp, … give on this machine.
  std::vector<std::string> layers;
};

/// The header of a run. `max_ticks`: instead of the description's.
JournalHeader MakeHeader(const schedule::Agent& agent, const plugin::Registry& registry,
                         std::vector<config::Override> overrides = {},
                         const std::filesystem::path& scenario = {},
                         std::optional<std::uint64_t> max_ticks = std::nullopt);

/// How `now` differs from what was recorded, one sentence each; empty when a replay must agree.
std::vector<std::string> Differences(const JournalHeader& recorded, const JournalHeader& now);

}  // namespace latchwork::record

#endif  // LATCHWORK_RECORD_JOURNAL_HEADER_H_

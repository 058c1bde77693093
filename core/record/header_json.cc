// SPDX-License-Identifier: BSD-3-Clause
#include "core/record/header_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace latchwork::record {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kFormat = "latchwork journal";

/// No conversion: throws for what is negative or has a fraction.
std::uint64_t Number(const Json& json, const char* name) {
  return json.at(name).get_ref<const std::uint64_t&>();
}

void Fill(const Json& json, JournalHeader& header) {
  header.agent = json.at("agent").get<std::string>();
  header.agent_file = json.at("agent_file").get<std::string>();
  header.scenario = json.at("scenario").get<std::string>();
  header.config_fingerprint = json.at("config").get<std::string>();
  header.seed = Number(json, "seed");
  header.tick_us = Number(json, "tick_us");
  header.max_ticks = Number(json, "max_ticks");
  header.build = json.at("build").get<std::string>();
  header.libm = json.at("libm").get<std::string>();
  header.layers = json.at("layers").get<std::vector<std::string>>();
  for (const Json& each : json.at("overrides")) {
    header.overrides.push_back({each.at("part").get<std::string>(),
                                each.at("name").get<std::string>(),
                                each.at("value").get<std::string>()});
  }
  for (const Json& each : json.at("plugins")) {
    header.plugins.push_back({each.at("kind").get<std::string>(),
                              each.at("name").get<std::string>(),
                              each.at("fingerprint").get<std::string>()});
  }
}

}  // namespace

std::string HeaderToJson(const JournalHeader& header) {
  Json overrides = Json::array();
  for (const config::Override& each : header.overrides) {
    overrides.push_back({{"part", each.part}, {"name", each.name}, {"value", each.value}});
  }
  Json plugins = Json::array();
  for (const JournalHeader::Plugin& each : header.plugins) {
    plugins.push_back(
        {{"kind", each.kind}, {"name", each.name}, {"fingerprint", each.fingerprint}});
  }
  const Json json = {{"format", kFormat},
                     {"version", header.version},
                     {"agent", header.agent},
                     {"agent_file", header.agent_file},
                     {"scenario", header.scenario},
                     {"config", header.config_fingerprint},
                     {"seed", header.seed},
                     {"tick_us", header.tick_us},
                     {"max_ticks", header.max_ticks},
                     {"overrides", std::move(overrides)},
                     {"plugins", std::move(plugins)},
                     {"build", header.build},
                     {"libm", header.libm},
                     {"layers", header.layers}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string HeaderFromJson(std::string_view json, JournalHeader& header) {
  try {
    const Json parsed = Json::parse(json);
    if (parsed.at("format").get<std::string>() != kFormat) return "this is not a journal";
    header.version = Number(parsed, "version");
    if (header.version > kJournalVersion) {
      return fmt::format(
          "the journal has version {} of the format; this program reads up to version {}",
          header.version, kJournalVersion);
    }
    Fill(parsed, header);
    return {};
  } catch (const Json::exception& error) {
    return fmt::format("the header cannot be read: {}", error.what());
  }
}

}  // namespace latchwork::record

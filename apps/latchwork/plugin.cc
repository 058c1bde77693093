// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/latchwork/command.h"
#include "apps/latchwork/plugin_page.h"
#include "latchwork/logic/diagnostic.h"
#include "latchwork/plugin/plugin_search.h"
#include "latchwork/plugin/registry.h"

namespace latchwork::app {
namespace {

plugin::Registry MakeRegistry(const Context& context) {
  return plugin::Registry(plugin::MakeSearchPath(context.plugin_folders, context.executable));
}

std::string KindOf(const plugin::PluginEntry& entry) {
  return entry.info ? std::string(plugin::Name(entry.info->kind)) : "unknown";
}

void PrintJson(const plugin::Registry& registry) {
  nlohmann::ordered_json list;
  list["folders"] = nlohmann::ordered_json::array();
  list["plugins"] = nlohmann::ordered_json::array();
  for (const plugin::SearchedFolder& folder : registry.folders()) {
    list["folders"].push_back({{"path", folder.path.string()}, {"problem", folder.problem}});
  }
  for (const plugin::PluginEntry& entry : registry.List()) {
    list["plugins"].push_back({{"kind", KindOf(entry)},
                               {"name", entry.name},
                               {"version", entry.version},
                               {"summary", entry.summary},
                               {"path", entry.file.string()},
                               {"problem", entry.problem}});
  }
  fmt::print("{}\n", list.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

void PrintTable(const plugin::Registry& registry) {
  std::vector<std::vector<std::string>> rows{{"kind", "name", "version", "summary", "path"}};
  for (const plugin::PluginEntry& entry : registry.List()) {
    const std::string summary =
        entry.problem.empty() ? entry.summary : "CANNOT BE LOADED: " + entry.problem;
    rows.push_back({KindOf(entry), entry.name, entry.version, summary, entry.file.string()});
  }
  if (rows.size() == 1) {
    fmt::print("No plugins; searched: {}\n", registry.SearchedText());
    return;
  }
  fmt::print("{}", TextTable(rows, ""));
}

/// Loads one plugin and prints its page; false when it cannot be loaded, with the reason on
/// standard error.
template <typename Base>
bool Show(const plugin::PluginEntry& entry, const plugin::Made<Base>& made) {
  if (!made.object) {
    fmt::print(stderr, "latchwork: {}\n", made.error);
    return false;
  }
  fmt::print("{}", PluginPage(entry, *made.object));
  return true;
}

bool ShowEntry(const plugin::Registry& registry, const plugin::PluginEntry& entry) {
  if (!entry.info) {
    fmt::print(stderr, "latchwork: {}: {}\n", entry.file.string(), entry.problem);
    return false;
  }
  switch (entry.info->kind) {
    case sdk::PluginKind::kLayer:
      return Show(entry, registry.MakeLayer(entry.name));
    case sdk::PluginKind::kReasoner:
      return Show(entry, registry.MakeReasoner(entry.name));
    case sdk::PluginKind::kWorld:
      return Show(entry, registry.MakeWorld(entry.name));
  }
  fmt::print(stderr, "latchwork: {}: {}\n", entry.file.string(), entry.problem);
  return false;
}

int ReportUnknown(const plugin::Registry& registry, const std::string& name) {
  std::vector<std::string> names;
  for (const plugin::PluginEntry& entry : registry.List()) names.push_back(entry.name);
  const std::string_view nearest = logic::NearestName(name, names);
  fmt::print(stderr, "latchwork: there is no plugin '{}'{}\n  searched: {}\n", name,
             nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest),
             registry.SearchedText());
  return kPluginFailure;
}

int ShowAll(const plugin::Registry& registry, const std::string& name) {
  bool found = false;
  bool all_loaded = true;
  for (const plugin::PluginEntry& entry : registry.List()) {
    if (entry.name != name) continue;
    if (found) fmt::print("\n");
    found = true;
    all_loaded = ShowEntry(registry, entry) && all_loaded;
  }
  if (!found) return ReportUnknown(registry, name);
  return all_loaded ? kDone : kPluginFailure;
}

}  // namespace

void AddPlugin(CLI::App& app, Context& context) {
  CLI::App* const command = app.add_subcommand("plugin", "List plugins, or show what one offers");
  command->require_subcommand(1);

  CLI::App* const list = command->add_subcommand(
      "list",
      "All plugins of the search path, also those that cannot be loaded; runs none of them");
  const auto json = std::make_shared<bool>(false);
  list->add_flag("--json", *json, "Print JSON");
  list->callback([&context, json] {
    const plugin::Registry registry = MakeRegistry(context);
    if (*json) {
      PrintJson(registry);
    } else {
      PrintTable(registry);
    }
  });

  CLI::App* const show = command->add_subcommand(
      "show", "Contract, parameters, languages and events of a plugin, with an example of its use");
  const auto name = std::make_shared<std::string>();
  show->add_option("NAME", *name, "Its name, as 'latchwork plugin list' gives it")->required();
  show->callback([&context, name] { context.exit_code = ShowAll(MakeRegistry(context), *name); });
}

}  // namespace latchwork::app

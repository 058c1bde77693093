// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/plugin/registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

#include "core/logic/fingerprint.h"
#include "core/plugin/abi_check.h"
#include "core/plugin/library.h"
#include "core/plugin/plugin_info_reader.h"
#include "latchwork/logic/diagnostic.h"

namespace latchwork::plugin {
namespace {

PluginEntry Inspect(const std::filesystem::path& file) {
  PluginEntry entry;
  entry.file = file;
  entry.name = file.stem().string();
  PluginInfoReading reading = ReadPluginInfo(file);
  entry.problem = std::move(reading.problem);
  if (!reading.info) return entry;
  entry.problem = fmt::format("{}", fmt::join(AbiDifferences(*reading.info), "; "));
  if (!HasKnownLayout(*reading.info)) return entry;
  entry.info = reading.info;
  entry.name = TextOf(reading.info->name);
  entry.version = TextOf(reading.info->version);
  entry.summary = TextOf(reading.info->summary);
  return entry;
}

bool SameClaim(const PluginEntry& a, const PluginEntry& b) {
  return a.info && b.info && a.info->kind == b.info->kind && a.name == b.name;
}

void MarkAmbiguous(std::vector<PluginEntry>& plugins) {
  for (PluginEntry& entry : plugins) {
    const auto other = std::ranges::find_if(plugins, [&entry](const PluginEntry& candidate) {
      return &candidate != &entry && SameClaim(candidate, entry);
    });
    if (other != plugins.end() && entry.problem.empty()) {
      entry.problem =
          fmt::format("ambiguous: {} is of the same kind and name", other->file.string());
    }
  }
}

std::string AmbiguousText(sdk::PluginKind kind, std::string_view name,
                          const std::vector<const PluginEntry*>& candidates) {
  std::vector<std::string> files;
  files.reserve(candidates.size());
  for (const PluginEntry* candidate : candidates) files.push_back(candidate->file.string());
  return fmt::format(
      "the {} plugin '{}' is ambiguous: {} are of that name; take all but one out of the "
      "search path",
      Name(kind), name, fmt::join(files, " and "));
}

}  // namespace

std::string_view Name(sdk::PluginKind kind) {
  switch (kind) {
    case sdk::PluginKind::kLayer:
      return "layer";
    case sdk::PluginKind::kReasoner:
      return "reasoner";
    case sdk::PluginKind::kWorld:
      return "world";
  }
  return "unknown";
}

Registry::Registry(const std::vector<std::filesystem::path>& search_path)
    : folders_(SearchPlugins(search_path)) {
  for (const SearchedFolder& folder : folders_) {
    std::ranges::transform(folder.files, std::back_inserter(plugins_), Inspect);
  }
  MarkAmbiguous(plugins_);
}

std::vector<std::string> Registry::Names(sdk::PluginKind kind) const {
  std::vector<std::string> names;
  for (const PluginEntry& entry : plugins_) {
    if (entry.problem.empty() && entry.info->kind == kind) names.push_back(entry.name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<const PluginEntry*> Registry::Candidates(sdk::PluginKind kind,
                                                     std::string_view name) const {
  std::vector<const PluginEntry*> of_kind;
  std::vector<const PluginEntry*> unreadable;  // could be anything, so the file name has to do
  for (const PluginEntry& entry : plugins_) {
    if (entry.name != name) continue;
    if (!entry.info) unreadable.push_back(&entry);
    if (entry.info && entry.info->kind == kind) of_kind.push_back(&entry);
  }
  return of_kind.empty() ? unreadable : of_kind;
}

template <typename Base>
Made<Base> Registry::Make(sdk::PluginKind kind, std::string_view name) const {
  const std::vector<const PluginEntry*> candidates = Candidates(kind, name);
  if (candidates.empty()) {
    const std::vector<std::string> names = Names(kind);
    const std::string_view nearest = logic::NearestName(name, names);
    return {nullptr, MakeFailure::kUnknownName,
            fmt::format("there is no {} plugin '{}'{}; searched: {}", Name(kind), name,
                        nearest.empty() ? "" : fmt::format(", did you mean '{}'?", nearest),
                        SearchedText())};
  }
  if (candidates.size() > 1) {
    return {nullptr, MakeFailure::kUnusable, AmbiguousText(kind, name, candidates)};
  }
  const PluginEntry& entry = *candidates.front();
  MadeObject made{nullptr, entry.problem};
  if (entry.problem.empty()) made = MakeObject(entry.file, *entry.info);
  if (made.object == nullptr) {
    return {nullptr, MakeFailure::kUnusable,
            fmt::format("the {} plugin '{}' cannot be loaded: {}: {}; searched: {}", Name(kind),
                        name, entry.file.string(), made.problem, SearchedText())};
  }
  return {std::static_pointer_cast<Base>(std::move(made.object)), MakeFailure::kNone, {}};
}

Made<sdk::Layer> Registry::MakeLayer(std::string_view name) const {
  return Make<sdk::Layer>(sdk::PluginKind::kLayer, name);
}

Made<sdk::Reasoner> Registry::MakeReasoner(std::string_view name) const {
  return Make<sdk::Reasoner>(sdk::PluginKind::kReasoner, name);
}

Made<sdk::World> Registry::MakeWorld(std::string_view name) const {
  return Make<sdk::World>(sdk::PluginKind::kWorld, name);
}

std::filesystem::path Registry::DataFolder(sdk::PluginKind kind, std::string_view name) const {
  const std::vector<const PluginEntry*> candidates = Candidates(kind, name);
  return candidates.size() == 1 ? candidates.front()->file.parent_path() / name
                                : std::filesystem::path();
}

std::string Registry::Fingerprint(sdk::PluginKind kind, std::string_view name) const {
  const std::vector<const PluginEntry*> candidates = Candidates(kind, name);
  if (candidates.size() != 1 || !candidates.front()->info) return {};
  std::ifstream stream(candidates.front()->file, std::ios::binary);
  std::uint64_t fingerprint = logic::kFingerprintStart;
  std::array<char, 1U << 16U> buffer{};
  while (stream) {
    stream.read(buffer.data(), buffer.size());
    const std::string_view read(buffer.data(), static_cast<std::size_t>(stream.gcount()));
    fingerprint = logic::Fingerprint(read, fingerprint);
  }
  return stream.eof() ? fmt::format("{:016x}", fingerprint) : std::string();
}

std::string Registry::SearchedText() const {
  std::vector<std::string> texts;
  for (const SearchedFolder& folder : folders_) {
    texts.push_back(folder.path.string() +
                    (folder.problem.empty() ? "" : fmt::format(" ({})", folder.problem)));
  }
  return texts.empty() ? "no folder" : fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace latchwork::plugin

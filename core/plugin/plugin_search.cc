// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/plugin/plugin_search.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <system_error>
#include <utility>

namespace latchwork::plugin {
namespace {

std::filesystem::path RealPath(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path real = std::filesystem::weakly_canonical(path, error);
  return error ? path.lexically_normal() : real;
}

std::vector<std::filesystem::path> SplitAtColons(std::string_view text) {
  std::vector<std::filesystem::path> parts;
  while (!text.empty()) {
    const std::string_view part = text.substr(0, text.find(':'));
    if (!part.empty()) parts.emplace_back(part);
    text.remove_prefix(std::min(part.size() + 1, text.size()));
  }
  return parts;
}

SearchedFolder Search(const std::filesystem::path& folder) {
  SearchedFolder result{folder, {}, {}};
  std::error_code error;
  std::filesystem::directory_iterator entries(folder, error);
  for (; !error && entries != std::filesystem::directory_iterator(); entries.increment(error)) {
    if (entries->path().extension() == ".so") result.files.push_back(entries->path());
  }
  if (error) result.problem = error.message();
  std::sort(result.files.begin(), result.files.end());
  return result;
}

}  // namespace

std::vector<std::filesystem::path> MakeSearchPath(std::span<const std::filesystem::path> given,
                                                  std::string_view environment,
                                                  const std::filesystem::path& executable) {
  std::vector<std::filesystem::path> wanted(given.begin(), given.end());
  std::ranges::move(SplitAtColons(environment), std::back_inserter(wanted));
  const std::filesystem::path prefix = executable.parent_path().parent_path();
  wanted.push_back(prefix / "plugins");
  wanted.push_back(prefix / "lib" / "latchwork" / "plugins");

  std::vector<std::filesystem::path> path;
  std::set<std::filesystem::path> seen;
  for (const std::filesystem::path& folder : wanted) {
    std::filesystem::path absolute = std::filesystem::absolute(folder).lexically_normal();
    if (!absolute.has_filename()) absolute = absolute.parent_path();
    if (seen.insert(RealPath(absolute)).second) path.push_back(std::move(absolute));
  }
  return path;
}

std::vector<std::filesystem::path> MakeSearchPath(std::span<const std::filesystem::path> given,
                                                  const std::filesystem::path& executable) {
  const char* const environment = std::getenv("LATCHWORK_PLUGIN_PATH");
  return MakeSearchPath(given, environment == nullptr ? "" : environment, executable);
}

std::vector<SearchedFolder> SearchPlugins(std::span<const std::filesystem::path> folders) {
  std::vector<SearchedFolder> result;
  std::set<std::filesystem::path> seen;
  for (const std::filesystem::path& folder : folders) {
    SearchedFolder searched = Search(folder);
    std::erase_if(searched.files, [&seen](const std::filesystem::path& file) {
      return !seen.insert(RealPath(file)).second;
    });
    result.push_back(std::move(searched));
  }
  return result;
}

}  // namespace latchwork::plugin

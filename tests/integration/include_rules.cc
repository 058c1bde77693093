// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/include_rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace latchwork::tests {
namespace {

constexpr std::size_t kMaxLines = 600;
constexpr std::array<std::string_view, 6> kTopFolders = {"core",   "reasoners", "plugins",
                                                         "worlds", "apps",      "tests"};

struct Include {
  std::size_t line;
  std::string name;
};

/// A part may include the parts that `sees` names, besides its own folder: parts of core, or
/// folders.
struct Part {
  std::string_view folder;
  std::string_view sees;
};
constexpr std::array<Part, 18> kParts = {{
    {"core/logic/", ""},
    {"core/process/", ""},
    {"core/sdk/", "logic"},
    {"core/config/", "logic sdk"},
    {"core/plugin/", "logic sdk"},
    {"core/schedule/", "logic sdk config plugin"},
    {"core/record/", "logic sdk config plugin schedule"},
    {"reasoners/circumscription/", "logic sdk reasoners/pttp"},
    {"reasoners/eprover/", "logic sdk process reasoners/contrapositives reasoners/pttp"},
    {"reasoners/swipl/", "logic sdk process reasoners/contrapositives reasoners/pttp"},
    {"reasoners/", "logic sdk"},
    {"plugins/", "logic sdk"},
    {"worlds/", "logic sdk"},
    {"apps/check_proof/", "logic"},
    {"apps/compare/", "logic sdk config process"},
    {"apps/latchwork_mpi/", "logic apps/compare apps/latchwork"},
    {"apps/",
     "logic sdk config plugin schedule record reasoners/circumscription reasoners/icarus "
     "reasoners/pttp apps/check_proof apps/compare"},
    {"tests/", "logic sdk config plugin schedule record"},
}};

/// Includes that start with `prefix` may stand below `folders` (and the tests of those) only.
struct Confinement {
  std::string_view prefix;
  std::string_view folders;
};
constexpr std::array<Confinement, 18> kConfinements = {{
    {"mrpt/", "worlds/office/"},
    {"opencv2/", ""},
    {"Eigen/", ""},
    {"ompl/", "reasoners/ompl/"},
    {"png.h", "reasoners/ompl/"},
    {"xercesc/", "core/config/"},
    {"boost/dll/", "core/plugin/"},
    {"boost/math/", "apps/compare/"},
    {"sqlite3.h", "apps/compare/"},
    {"mpi.h", "apps/latchwork_mpi/"},
    {"dlfcn.h", "core/config/ core/plugin/"},
    {"cadical", "reasoners/circumscription/"},
    {"CLI/", "apps/"},
    {"fmt/",
     "core/sdk/ core/config/ core/plugin/ core/schedule/ core/record/ reasoners/ plugins/ worlds/ "
     "apps/ tests/"},
    {"nlohmann/", "core/record/ worlds/ apps/ tests/"},
    {"gtest/", "tests/"},
    {"gmock/", "tests/"},
    {"benchmark/", "tests/bench/"},
}};

constexpr std::array<std::string_view, 6> kSingleUser = {"xercesc/", "boost/dll/", "cadical",
                                                         "mpi.h",    "sqlite3.h",  "png.h"};

std::vector<std::string> Words(std::string_view text) {
  std::istringstream stream{std::string(text)};
  return {std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
}

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<Include> Includes(const SourceFile& file) {
  std::vector<Include> includes;
  const std::vector<std::string> lines = Lines(file.text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].starts_with("#include")) continue;
    const std::size_t first = lines[i].find_first_of("<\"");
    if (first == std::string::npos) continue;
    const std::size_t last = lines[i].find_first_of(">\"", first + 1);
    includes.push_back({i + 1, lines[i].substr(first + 1, last - first - 1)});
  }
  return includes;
}

std::string Finding(const SourceFile& file, std::size_t line, std::string_view reason) {
  return file.path + ":" + std::to_string(line) + ": " + std::string(reason);
}

/// Where a public header stands in the tree; other names are their own path.
std::string WithoutPublicPrefix(std::string_view path) {
  constexpr std::string_view kPublic = "core/include/latchwork/";
  if (path.starts_with(kPublic)) return "core/" + std::string(path.substr(kPublic.size()));
  return std::string(path);
}

std::string TreePath(std::string_view include) {
  constexpr std::string_view kPublic = "latchwork/";
  if (include.starts_with(kPublic)) return "core/" + std::string(include.substr(kPublic.size()));
  return std::string(include);
}

/// The folder that owns a path: core/logic/, reasoners/pttp/, apps/latchwork/, tests/core/.
std::string OwnFolder(std::string_view path) {
  const std::size_t first = path.find('/');
  const std::size_t second = path.find('/', first + 1);
  return std::string(path.substr(0, second == std::string_view::npos ? first + 1 : second + 1));
}

bool InTree(std::string_view path) {
  return std::ranges::any_of(kTopFolders, [&](std::string_view folder) {
    return path.starts_with(std::string(folder) + "/");
  });
}

bool MaySee(const std::string& from, const std::string& target) {
  if (from.starts_with("tests/") || OwnFolder(from) == OwnFolder(target)) return true;
  const auto* const part = std::ranges::find_if(
      kParts, [&](const Part& candidate) { return from.starts_with(candidate.folder); });
  return part != kParts.end() &&
         std::ranges::any_of(Words(part->sees), [&](const std::string& name) {
           return target.starts_with("core/" + name + "/") || target.starts_with(name + "/");
         });
}

bool IsConfinedTo(const std::string& path, std::string_view folders) {
  return std::ranges::any_of(Words(folders), [&](const std::string& folder) {
    return path.starts_with(folder) || path.starts_with("tests/" + folder);
  });
}

std::string GuardEnding(std::string_view path) {
  std::string ending = "_" + std::string(path.substr(path.rfind('/') + 1));
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) {
    return c == '.' ? '_' : static_cast<char>(std::toupper(c));
  });
  return ending + "_";
}

/// The name after #ifndef, or nothing when no #define of it follows.
std::string Guard(const std::vector<std::string>& lines) {
  constexpr std::string_view kTest = "#ifndef ";
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    if (!lines[i].starts_with(kTest)) continue;
    std::string name = lines[i].substr(kTest.size());
    return lines[i + 1] == "#define " + name ? name : "";
  }
  return "";
}

bool IsHeader(const SourceFile& file) { return file.path.ends_with(".h"); }

}  // namespace

std::vector<SourceFile> ReadTree(const std::filesystem::path& root) {
  std::vector<SourceFile> files;
  for (const std::string_view folder : kTopFolders) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cc") continue;
      std::ifstream stream(entry.path(), std::ios::binary);
      files.push_back({entry.path().lexically_relative(root).generic_string(),
                       {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}});
    }
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

Findings CheckDependencies(const SourceFile& file) {
  Findings findings;
  const std::string from = WithoutPublicPrefix(file.path);
  for (const Include& include : Includes(file)) {
    if (include.name.starts_with("../")) {
      findings.push_back(Finding(file, include.line, "includes by a path upwards"));
    }
    const std::string target = TreePath(include.name);
    if (InTree(target) && !MaySee(from, target)) {
      findings.push_back(Finding(file, include.line, "may not include " + include.name));
    }
  }
  return findings;
}

Findings CheckConfinement(const SourceFile& file) {
  Findings findings;
  const bool is_public = file.path.starts_with("core/include/");
  for (const Include& include : Includes(file)) {
    for (const Confinement& rule : kConfinements) {
      if (!include.name.starts_with(rule.prefix)) continue;
      if (is_public || !IsConfinedTo(file.path, rule.folders)) {
        findings.push_back(
            Finding(file, include.line,
                    include.name + " is confined to '" + std::string(rule.folders) + "'"));
      }
    }
  }
  return findings;
}

Findings CheckForm(const SourceFile& file) {
  Findings findings;
  const std::vector<std::string> lines = Lines(file.text);
  if (lines.empty() || lines[0] != "// SPDX-License-Identifier: BSD-3-Clause") {
    findings.push_back(Finding(file, 1, "does not start with the SPDX line"));
  }
  if (lines.size() > kMaxLines) {
    findings.push_back(Finding(file, lines.size(), "is longer than 600 lines"));
  }
  if (IsHeader(file)) {
    const std::string guard = Guard(lines);
    if (!guard.starts_with("LATCHWORK_") || !guard.ends_with(GuardEnding(file.path))) {
      findings.push_back(Finding(file, 2, "has no include guard that ends in the file's name"));
    }
  }
  return findings;
}

Findings CheckSingleUsers(const std::vector<SourceFile>& files) {
  Findings findings;
  for (const std::string_view prefix : kSingleUser) {
    std::string user;
    for (const SourceFile& file : files) {
      const std::vector<Include> includes = Includes(file);
      const auto hit = std::ranges::find_if(
          includes, [&](const Include& include) { return include.name.starts_with(prefix); });
      if (hit == includes.end()) continue;
      if (!user.empty()) {
        findings.push_back(Finding(file, hit->line, hit->name + " is hidden in " + user));
      }
      user = file.path;
    }
  }
  return findings;
}

Findings CheckGuardsDiffer(const std::vector<SourceFile>& files) {
  Findings findings;
  std::map<std::string, std::string> owners;
  for (const SourceFile& file : files) {
    if (!IsHeader(file)) continue;
    const auto [owner, is_new] = owners.emplace(Guard(Lines(file.text)), file.path);
    if (!is_new) findings.push_back(Finding(file, 2, "shares its guard with " + owner->second));
  }
  return findings;
}

}  // namespace latchwork::tests

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_INTEGRATION_INCLUDE_RULES_H_
#define LATCHWORK_TESTS_INTEGRATION_INCLUDE_RULES_H_

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace latchwork::tests {

/// A source of the tree: its path from the root, with '/', and its text.
struct SourceFile {
  std::string path;
  std::string text;
};

/// Every .h and .cc file of the tree at `root`, sorted by path.
std::vector<SourceFile> ReadTree(const std::filesystem::path& root);

/// What is wrong, as "path:line: reason", one entry per finding; empty when all is well.
using Findings = std::vector<std::string>;

/// The parts of core depend on each other in one direction; reasoners, layers and worlds see logic
/// and sdk only; nothing sees apps or tests.
Findings CheckDependencies(const SourceFile& file);

/// Each library of others is seen by the folder that it is confined to.
Findings CheckConfinement(const SourceFile& file);

/// SPDX line first, at most 600 lines, and in headers an include guard named after the file.
Findings CheckForm(const SourceFile& file);

/// Libraries that hide behind one source file do so.
Findings CheckSingleUsers(const std::vector<SourceFile>& files);

/// No include guard is used twice.
Findings CheckGuardsDiffer(const std::vector<SourceFile>& files);

}  // namespace latchwork::tests

#endif  // LATCHWORK_TESTS_INTEGRATION_INCLUDE_RULES_H_

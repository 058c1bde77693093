// SPDX-License-Identifier: BSD-3-Clause
#include "core/plugin/abi_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "core/plugin/plugin_info_reader.h"

namespace latchwork::plugin {
namespace {

constexpr sdk::PluginInfo kHere = sdk::MakePluginInfo(sdk::PluginKind::kLayer, "", "", "");

/// "gcc 12.2.0" -> "gcc 12".
std::string WithMajor(const std::string& compiler) {
  return compiler.substr(0, compiler.find('.'));
}

bool IsKind(sdk::PluginKind kind) {
  return kind == sdk::PluginKind::kLayer || kind == sdk::PluginKind::kReasoner ||
         kind == sdk::PluginKind::kWorld;
}

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// A name is part of the path of the plugin's data, and of agent files, whose rule for names this
/// is.
bool IsPlainName(std::string_view name) {
  return !name.empty() && IsLetter(name.front()) &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return IsLetter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
         });
}

void Compare(std::string_view what, const std::string& theirs, const std::string& ours,
             std::vector<std::string>& differences) {
  if (theirs == ours) return;
  differences.push_back(
      fmt::format("built with {} '{}', this latchwork with '{}'", what, theirs, ours));
}

void CompareFields(const sdk::PluginInfo& info, std::vector<std::string>& differences) {
  if (!IsKind(info.kind)) {
    differences.push_back(
        fmt::format("of the unknown kind {}", static_cast<std::uint32_t>(info.kind)));
  }
  Compare("the C++ standard", std::to_string(info.cxx), std::to_string(kHere.cxx), differences);
  Compare("the compiler", WithMajor(TextOf(info.compiler)), WithMajor(TextOf(kHere.compiler)),
          differences);
  Compare("the standard library", TextOf(info.stdlib), TextOf(kHere.stdlib), differences);
  Compare("the sanitizers", TextOf(info.sanitizers), TextOf(kHere.sanitizers), differences);
  if (const std::string name = TextOf(info.name); !IsPlainName(name)) {
    differences.push_back(
        fmt::format("named '{}': a name is a letter, then letters, digits, '_' and '-'", name));
  }
}

}  // namespace

bool HasKnownLayout(const sdk::PluginInfo& info) {
  return info.magic == kHere.magic && info.size == kHere.size;
}

std::vector<std::string> AbiDifferences(const sdk::PluginInfo& info) {
  if (info.magic != kHere.magic) {
    return {"its plugin record does not begin with latchwork's magic number"};
  }
  std::vector<std::string> differences;
  if (info.abi != kHere.abi) {
    differences.push_back(fmt::format(
        "built for plugin ABI {}, this latchwork speaks {}: rebuild it against these headers",
        info.abi, kHere.abi));
  }
  if (HasKnownLayout(info)) {
    CompareFields(info, differences);
  } else if (differences.empty()) {
    differences.push_back(fmt::format(
        "its plugin record has {} bytes, this latchwork's {}: rebuild it against these headers",
        info.size, kHere.size));
  }
  return differences;
}

}  // namespace latchwork::plugin

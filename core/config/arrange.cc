// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <tuple>

#include "core/config/document.h"

namespace latchwork::config {
namespace {

constexpr std::size_t kMaxDiagnostics = 100;

std::size_t RankOf(const std::vector<Document::Source>& sources, const std::string& file) {
  const auto found = std::ranges::find(sources, file, &Document::Source::name);
  return static_cast<std::size_t>(found - sources.begin());
}

std::string LineOf(std::string_view text, std::uint32_t line) {
  std::size_t begin = 0;
  for (std::uint32_t i = 1; i < line; ++i) {
    const std::size_t end = text.find_first_of("\r\n", begin);
    if (end == std::string_view::npos) return "";
    begin = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
  }
  return std::string(text.substr(begin, text.find_first_of("\r\n", begin) - begin));
}

}  // namespace

void Arrange(const std::vector<Document::Source>& sources, logic::Diagnostics& diagnostics) {
  const auto key = [&](const logic::Diagnostic& diagnostic) {
    const auto& place = diagnostic.place;
    return std::tuple(RankOf(sources, place.file), place.line, place.column);
  };
  std::ranges::stable_sort(diagnostics, {}, key);
  if (diagnostics.size() > kMaxDiagnostics) {
    const std::size_t more = diagnostics.size() - kMaxDiagnostics;
    diagnostics.resize(kMaxDiagnostics);
    diagnostics.push_back({{sources.empty() ? "" : sources.front().name, 0, 0},
                           fmt::format("and {} more errors", more),
                           "",
                           ""});
  }
  for (logic::Diagnostic& diagnostic : diagnostics) {
    const std::size_t rank = RankOf(sources, diagnostic.place.file);
    if (rank == sources.size() || diagnostic.place.line == 0) continue;
    diagnostic.excerpt = LineOf(sources[rank].bytes, diagnostic.place.line);
  }
}

}  // namespace latchwork::config

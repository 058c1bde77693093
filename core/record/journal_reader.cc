// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <iterator>
#include <string_view>

#include "core/record/frame.h"
#include "core/record/header_json.h"
#include "latchwork/record/journal.h"

namespace latchwork::record {
namespace {

constexpr std::string_view kTickStart = "{\"tick\":";
constexpr std::string_view kEndStart = "{\"end\":";

Journal Failure(std::string_view name, std::string message) {
  Journal journal;
  journal.diagnostics.push_back({{std::string(name), 0, 0}, std::move(message), "", ""});
  return journal;
}

std::optional<std::uint64_t> TickOf(std::string_view json) {
  if (!json.starts_with(kTickStart)) return std::nullopt;
  const char* begin = json.data() + kTickStart.size();
  std::uint64_t tick = 0;
  const auto [end, error] = std::from_chars(begin, json.data() + json.size(), tick);
  if (error != std::errc() || end == json.data() + json.size()) return std::nullopt;
  return tick;
}

/// Whether the frame is the next one of the journal; takes it in.
bool Take(const Frame& frame, std::uint64_t& chain, Journal& journal) {
  chain = Chain(chain, frame.json);
  if (chain != frame.hash || !journal.end.empty()) return false;
  if (frame.json.starts_with(kEndStart)) {
    journal.end = frame.json;
    return true;
  }
  const std::optional<std::uint64_t> tick = TickOf(frame.json);
  if (tick != journal.ticks.size()) return false;
  journal.ticks.push_back({*tick, std::string(frame.json), frame.hash});
  return true;
}

}  // namespace

Journal ReadJournalText(std::string_view bytes, std::string_view name) {
  const std::optional<Frame> first = ParseFrame(bytes);
  if (!first || first->hash != Chain(kChainStart, first->json)) {
    return Failure(name, "it is not a latchwork journal, or was cut within its header");
  }
  Journal journal;
  if (std::string problem = HeaderFromJson(first->json, journal.header); !problem.empty()) {
    return Failure(name, std::move(problem));
  }
  std::uint64_t chain = kChainStart;
  std::size_t offset = first->size;
  while (offset < bytes.size()) {
    const std::optional<Frame> frame = ParseFrame(bytes.substr(offset));
    if (!frame || !Take(*frame, chain, journal)) {
      journal.tail = fmt::format("the {} bytes from byte {} on are no whole frame of this journal",
                                 bytes.size() - offset, offset);
      return journal;
    }
    offset += frame->size;
  }
  if (journal.end.empty()) {
    journal.tail =
        fmt::format("it stops after {} ticks, before the end of the run", journal.ticks.size());
  }
  return journal;
}

Journal ReadJournal(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file)) {
    return Failure(file.string(), "it cannot be opened");
  }
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return ReadJournalText(bytes, file.string());
}

std::string HashText(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

}  // namespace latchwork::record

// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/record/journal_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <system_error>
#include <utility>

#include "core/logic/fingerprint.h"
#include "core/record/frame.h"
#include "core/record/header_json.h"

namespace latchwork::record {
namespace {

constexpr std::string_view kTickStart = R"({"tick":)";
constexpr std::string_view kEndStart = R"({"end":)";

std::optional<std::uint64_t> TickOf(std::string_view json) {
  std::uint64_t tick = 0;
  const char* const end = json.data() + json.size();
  if (!json.starts_with(kTickStart)) return std::nullopt;
  const auto parsed = std::from_chars(json.data() + kTickStart.size(), end, tick);
  if (parsed.ec != std::errc()) return std::nullopt;
  return tick;
}

/// A folder opens like a file, and fails only when it is read.
std::unique_ptr<std::istream> Open(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) return nullptr;
  auto stream = std::make_unique<std::ifstream>(file, std::ios::binary);
  if (!stream->is_open()) return nullptr;
  return stream;
}

}  // namespace

JournalReader::JournalReader(const std::filesystem::path& file)
    : JournalReader(Open(file), file.string()) {}

JournalReader::JournalReader(std::unique_ptr<std::istream> stream, std::string name)
    : stream_(std::move(stream)), name_(std::move(name)) {
  if (stream_ == nullptr) {
    Stop("the journal cannot be opened", "is it the run.journal of a folder given by run --out?");
  } else {
    ReadHeader();
  }
}

bool JournalReader::Stop(std::string message, std::string hint) {
  ended_ = true;
  problem_ = logic::Diagnostic{{name_, line_, 0}, std::move(message), std::move(hint), ""};
  return false;
}

/// Appends up to so many bytes, without memory for more than there are.
std::size_t JournalReader::Read(std::size_t count) {
  constexpr std::size_t kChunk = std::size_t{64} << 10U;
  std::size_t total = 0;
  while (total < count) {
    const std::size_t size = bytes_.size();
    const std::size_t wanted = std::min(count - total, kChunk);
    bytes_.resize(size + wanted);
    stream_->read(bytes_.data() + size, static_cast<std::streamsize>(wanted));
    const auto got = static_cast<std::size_t>(stream_->gcount());
    bytes_.resize(size + got);
    total += got;
    if (got < wanted) break;
  }
  return total;
}

/// Leaves the JSON in `bytes_`. False at the end, at a cut frame and at a broken one.
bool JournalReader::ReadFrame() {
  offset_ += line_ == 0 ? 0 : kFramePrefix + bytes_.size() + 1;
  line_ += line_ == std::numeric_limits<std::uint32_t>::max() ? 0 : 1;
  bytes_.clear();
  const std::size_t got = Read(kFramePrefix);
  if (got < kFramePrefix) {
    ended_ = tail_cut_ = true;
    return false;
  }
  const std::optional<FramePrefix> prefix = ParseFramePrefix(bytes_);
  if (!prefix) return Stop(fmt::format("no frame begins at byte {}", offset_));
  checksum_ = prefix->checksum;
  bytes_.clear();
  if (Read(prefix->length + 1) <= prefix->length) {
    ended_ = tail_cut_ = true;
    return false;
  }
  if (bytes_.back() != '\n') {
    return Stop(fmt::format("the frame at byte {} is longer or shorter than it says", offset_));
  }
  bytes_.pop_back();
  return true;
}

void JournalReader::ReadHeader() {
  constexpr std::string_view kHint = "a journal is written by latchwork run --out FOLDER";
  if (!ReadFrame()) {
    Stop(tail_cut_ ? "this is not a journal, or one that was cut within its header"
                   : "this is not a journal",
         std::string(kHint));
  } else if (logic::Fingerprint(bytes_) != checksum_) {
    Stop("the header does not match its checksum: it was changed or damaged");
  } else if (!IsShallowJson(bytes_)) {
    Stop("this is not a journal", std::string(kHint));
  } else {
    JournalHeader header;
    std::string failure = HeaderFromJson(bytes_, header);
    if (failure.empty()) {
      header_ = std::move(header);
    } else {
      Stop(std::move(failure));
    }
  }
  chain_ = logic::kFingerprintStart;
}

std::optional<JournalFrame> JournalReader::Next() {
  if (ended_ || !ReadFrame()) return std::nullopt;
  JournalFrame frame;
  if (!Accept(frame)) return std::nullopt;
  return frame;
}

bool JournalReader::Accept(JournalFrame& frame) {
  chain_ = logic::Fingerprint(bytes_, chain_);
  if (chain_ != checksum_) {
    return Stop(
        fmt::format("the frame at byte {} does not match its checksum: it, or one before "
                    "it, was changed or damaged",
                    offset_));
  }
  frame.hash = chain_;
  frame.json = bytes_;
  frame.tick = next_tick_;
  if (!IsShallowJson(bytes_)) return Stop(fmt::format("the frame at byte {} is no JSON", offset_));
  if (frame.json.starts_with(kEndStart)) {
    frame.kind = JournalFrame::Kind::kEnd;
    ended_ = true;
    if (stream_->peek() != std::istream::traits_type::eof()) {
      Stop(fmt::format("more follows the frame at byte {}, which ends the journal", offset_));
    }
    return true;
  }
  if (TickOf(frame.json) != next_tick_) {
    return Stop(fmt::format("the frame at byte {} is not that of tick {}", offset_, next_tick_));
  }
  ++next_tick_;
  return true;
}

}  // namespace latchwork::record

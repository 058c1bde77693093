// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_RECORD_JOURNAL_READER_H_
#define LATCHWORK_RECORD_JOURNAL_READER_H_

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "latchwork/logic/diagnostic.h"
#include "latchwork/record/journal_header.h"

namespace latchwork::record {

/// A whole frame after the header. `json` is valid JSON of bounded nesting (docs/journal.md).
struct JournalFrame {
  enum class Kind : std::uint8_t { kTick, kEnd };
  Kind kind = Kind::kTick;
  std::uint64_t tick = 0;  ///< Counted from 0; of the end: the number of ticks before it.
  std::uint64_t hash = 0;  ///< Chained over all ticks up to this one.
  std::string_view json;   ///< Valid until the next call of Next.
};

/// Reads a journal frame by frame, in the memory of one frame, whatever the bytes are. A journal
/// that was cut at any byte gives all its whole frames. Nothing is thrown.
class JournalReader {
 public:
  explicit JournalReader(const std::filesystem::path& file);
  /// `name` stands for the file in diagnostics.
  JournalReader(std::unique_ptr<std::istream> stream, std::string name);

  /// Nothing when there is no header that can be used; `problem` says why.
  const std::optional<JournalHeader>& header() const { return header_; }

  /// The next frame; nothing after the last whole one.
  std::optional<JournalFrame> Next();

  /// After the last frame: whether the journal stops before the end of its run, as after a kill.
  bool tail_cut() const { return tail_cut_; }
  /// What is wrong; its line is that of the frame. A cut tail alone is no problem.
  const std::optional<logic::Diagnostic>& problem() const { return problem_; }

 private:
  void ReadHeader();
  bool ReadFrame();
  bool Accept(JournalFrame& frame);
  std::size_t Read(std::size_t count);
  bool Stop(std::string message, std::string hint = {});

  std::unique_ptr<std::istream> stream_;
  std::string name_;
  std::optional<JournalHeader> header_;
  std::optional<logic::Diagnostic> problem_;
  std::string bytes_;           ///< Of the frame that is being read.
  std::uint64_t checksum_ = 0;  ///< As its prefix says.
  std::uint64_t chain_ = 0;
  std::uint64_t next_tick_ = 0;
  std::uint64_t offset_ = 0;  ///< Where the frame begins in the file.
  std::uint32_t line_ = 0;
  bool ended_ = false;
  bool tail_cut_ = false;
};

}  // namespace latchwork::record

#endif  // LATCHWORK_RECORD_JOURNAL_READER_H_

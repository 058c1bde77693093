// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_CORE_RECORD_SAMPLE_RUN_H_
#define LATCHWORK_TESTS_CORE_RECORD_SAMPLE_RUN_H_

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/record/journal_reader.h"
#include "latchwork/record/journal_writer.h"
#include "tests/core/schedule/fakes.h"

namespace latchwork::record::testing {

/// A run of one layer that turns away from what a sonar says.
struct Sample {
  std::uint64_t seed = 1;
  double gain = 0.5;
  std::uint64_t ticks = 4;
  std::uint64_t reached_at = 1000;  ///< Tick at which the world says that the goal is reached.
  unsigned threads = 1;
};

/// The agent of the sample; use its `Assemble(sample.seed)`.
class SampleAgent : public schedule::testing::FakeAgent {
 public:
  explicit SampleAgent(const Sample& sample);
};

/// Runs it and writes the journal; what the writer had to say is returned.
std::string WriteJournal(const Sample& sample, const std::filesystem::path& file);

/// The bytes of its journal.
std::string JournalOf(const Sample& sample);

JournalHeader HeaderOf(const schedule::Agent& agent);

/// A reader of bytes in memory.
JournalReader ReaderOf(std::string_view bytes);

/// The JSON of all frames that the reader still gives.
std::vector<std::string> Frames(JournalReader& reader);

/// Where the lines of a journal begin, and its end.
std::vector<std::size_t> LineStarts(std::string_view bytes);

}  // namespace latchwork::record::testing

#endif  // LATCHWORK_TESTS_CORE_RECORD_SAMPLE_RUN_H_

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_RECORD_JOURNAL_WRITER_H_
#define LATCHWORK_RECORD_JOURNAL_WRITER_H_

#include <filesystem>
#include <memory>
#include <string>

#include "latchwork/record/journal_header.h"
#include "latchwork/schedule/agent.h"
#include "latchwork/schedule/tick_record.h"

namespace latchwork::record {

/// Writes a run's journal: the header at once, a frame after every tick, each handed to the
/// operating system whole before the next tick begins. When the file cannot be written the run goes
/// on without. Thread rule: one thread.
class JournalWriter : public schedule::RunObserver {
 public:
  JournalWriter(const std::filesystem::path& file, const JournalHeader& header,
                const schedule::Agent& agent);
  ~JournalWriter() override;
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;

  bool OnTick(const schedule::TickRecord& record) override;
  void OnEnd(const schedule::RunResult& result) override;

  /// Why there is no journal, or no whole one; empty when all is well.
  const std::string& problem() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace latchwork::record

#endif  // LATCHWORK_RECORD_JOURNAL_WRITER_H_

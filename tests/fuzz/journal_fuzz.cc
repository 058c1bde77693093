// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a journal, and as the JSON of a frame whose checksum is right.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>

#include "core/record/frame.h"
#include "core/record/frame_rows.h"
#include "core/record/header_json.h"
#include "latchwork/record/journal_reader.h"

namespace record = latchwork::record;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  record::JournalReader reader(std::make_unique<std::istringstream>(bytes), "fuzz");
  if (reader.header().has_value() == reader.problem().has_value()) std::abort();
  std::uint64_t ticks = 0;
  while (const auto frame = reader.Next()) {
    if (frame->tick != ticks) std::abort();
    if (frame->kind == record::JournalFrame::Kind::kTick) ++ticks;
  }
  if (record::IsShallowJson(bytes)) {
    static_cast<void>(record::FindDifference(bytes, "{\"tick\":0}"));
    record::JournalHeader header;
    static_cast<void>(record::HeaderFromJson(bytes, header));
  }
  return 0;
}

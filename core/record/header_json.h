// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_RECORD_HEADER_JSON_H_
#define LATCHWORK_RECORD_HEADER_JSON_H_

#include <string>
#include <string_view>

#include "latchwork/record/journal_header.h"

namespace latchwork::record {

std::string HeaderToJson(const JournalHeader& header);
/// What is wrong with the text; empty when `header` was filled.
std::string HeaderFromJson(std::string_view json, JournalHeader& header);

}  // namespace latchwork::record

#endif  // LATCHWORK_RECORD_HEADER_JSON_H_

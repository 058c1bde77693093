// SPDX-License-Identifier: BSD-3-Clause
// The reader of plugin records, on any bytes.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "core/plugin/abi_check.h"
#include "core/plugin/plugin_info_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto reading = latchwork::plugin::ReadPluginInfo(std::as_bytes(std::span(data, size)));
  if (reading.info.has_value() != reading.problem.empty()) std::abort();
  if (reading.info) static_cast<void>(latchwork::plugin::AbiDifferences(*reading.info));
  return 0;
}

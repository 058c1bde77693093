// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as an agent file: a tree or diagnostics, never anything else.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "latchwork/config/agent.h"
#include "latchwork/config/xml.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto file =
      latchwork::config::ReadXmlText(text, "fuzz.xml", latchwork::config::AgentSchema());
  if (!file.complete && file.diagnostics.empty()) std::abort();
  return 0;
}

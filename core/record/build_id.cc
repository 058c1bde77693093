// SPDX-License-Identifier: BSD-3-Clause
#include "core/record/build_id.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/logic/fingerprint.h"
#include "latchwork/sdk/plugin.h"
#include "latchwork/sdk/random.h"

namespace latchwork::record {

std::string BuildId() {
  return fmt::format("latchwork {}, {}, {}, sanitizers: {}", LATCHWORK_VERSION, LATCHWORK_COMPILER,
                     sdk::kStandardLibrary, sdk::kSanitizers);
}

std::string LibmFingerprint() {
  constexpr std::uint64_t kArguments = 4096;
  const sdk::RandomStream stream(0, "libm");
  std::uint64_t fingerprint = logic::kFingerprintStart;
  for (std::uint64_t i = 0; i < kArguments; ++i) {
    const double x = stream.Between(-10, 10, i);
    const double y = stream.Between(0.001, 10, i, 1);
    for (const double value :
         {std::sin(x), std::cos(x), std::atan2(x, y), std::exp(x), std::log(y), std::pow(y, x)}) {
      const auto bytes = std::bit_cast<std::array<char, sizeof(double)>>(value);
      fingerprint = logic::Fingerprint({bytes.data(), bytes.size()}, fingerprint);
    }
  }
  return fmt::format("{:016x}", fingerprint);
}

}  // namespace latchwork::record

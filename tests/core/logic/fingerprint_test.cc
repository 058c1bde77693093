// SPDX-License-Identifier: BSD-3-Clause
#include "core/logic/fingerprint.h"

#include <gtest/gtest.h>

namespace latchwork::logic {
namespace {

// The values that the authors of FNV-1a publish for it.
static_assert(Fingerprint("") == 0xcbf29ce484222325ULL);
static_assert(Fingerprint("a") == 0xaf63dc4c8601ec8cULL);
static_assert(Fingerprint("foobar") == 0x85944171f73967e8ULL);

TEST(FingerprintTest, ContinuesFromWhatCameBefore) {
  EXPECT_EQ(Fingerprint("bar", Fingerprint("foo")), Fingerprint("foobar"));
}

TEST(FingerprintTest, BytesAboveTheAsciiRangeCountAsUnsigned) {
  EXPECT_EQ(Fingerprint("\xff"), (kFingerprintStart ^ 0xffU) * 0x100000001b3ULL);
}

}  // namespace
}  // namespace latchwork::logic

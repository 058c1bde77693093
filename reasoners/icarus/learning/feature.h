// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_FEATURE_H_
#define LATCHWORK_ICARUS_FEATURE_H_

#include <cstdint>

#include "reasoners/icarus/machine/value.h"

namespace latchwork::icarus {

/// The feature of an argument of a skill is what the value of the skill may depend on: the
/// argument, but that reals, in lists too, are told apart only by the whole numbers that they are
/// next to.
Value MakeFeature(const Value& argument, Arena& arena);

/// Whether `feature` is the feature of `argument`, which is not made for it.
bool IsFeatureOf(const Value& feature, const Value& argument);

/// The same for arguments of the same feature.
std::uint64_t HashOfFeature(const Value& argument);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_FEATURE_H_

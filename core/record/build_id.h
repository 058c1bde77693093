// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_RECORD_BUILD_ID_H_
#define LATCHWORK_RECORD_BUILD_ID_H_

#include <string>

namespace latchwork::record {

/// Version, compiler, standard library and sanitizers of this library.
std::string BuildId();

/// Of the bits that the machine's sin, cos, atan2, exp, log and pow give for a sample of arguments:
/// the mathematics library chooses its code by processor, and the last bit may differ.
std::string LibmFingerprint();

}  // namespace latchwork::record

#endif  // LATCHWORK_RECORD_BUILD_ID_H_

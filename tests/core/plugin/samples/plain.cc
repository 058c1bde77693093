// SPDX-License-Identifier: BSD-3-Clause
#include "tests/core/plugin/samples/sample_reasoner.h"

LATCHWORK_PLUGIN(latchwork::samples::SampleReasoner, "sample", "1.2", "does as it should")

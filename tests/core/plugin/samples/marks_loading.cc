// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <fstream>

#include "tests/core/plugin/samples/sample_reasoner.h"

namespace {

/// Writes the file that LATCHWORK_TEST_MARKER names: proof that code of this library ran.
struct Marker {
  Marker() {
    if (const char* const file = std::getenv("LATCHWORK_TEST_MARKER")) std::ofstream(file) << "ran";
  }
};
const Marker kMarker;

#if defined(LATCHWORK_SAMPLE_WRONG_ABI)
constexpr latchwork::sdk::PluginInfo OfTheNextAbi() {
  latchwork::sdk::PluginInfo info = latchwork::sdk::MakePluginInfo(
      latchwork::sdk::PluginKind::kReasoner, "marks_loading", "1.0", "is not to be loaded");
  ++info.abi;
  return info;
}
#endif

}  // namespace

#if defined(LATCHWORK_SAMPLE_WRONG_ABI)
// NOLINTBEGIN(readability-identifier-naming): the loader's name for it.
extern "C" {
__attribute__((
    visibility("default"))) extern const latchwork::sdk::PluginInfo latchwork_plugin_info;
__attribute__((used, section(".latchwork")))
const latchwork::sdk::PluginInfo latchwork_plugin_info = OfTheNextAbi();
}
// NOLINTEND(readability-identifier-naming)
#else
LATCHWORK_PLUGIN(latchwork::samples::SampleReasoner, "marks_loading", "1.0", "marks its loading")
#endif

// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a ground theory: it is refused with diagnostics, or its queries are answered. Small
// theories are answered with the certificate and without, and both say the same.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "reasoners/circumscription/engine/engine.h"
#include "reasoners/circumscription/engine/minimal_core.h"
#include "reasoners/circumscription/formats/circ_file.h"

namespace latchwork::circumscription {
namespace {

constexpr std::size_t kMostAtoms = 40;
constexpr int kConflicts = 200;

void Require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

std::vector<Verdict> Verdicts(const CircFile& file, std::span<const Literal> latches,
                              bool use_certificate) {
  EngineOptions options;
  options.use_certificate = use_certificate;
  options.conflicts = kConflicts;
  options.calls = 100;
  Engine engine(file.theory, options);
  engine.SetLatches(latches);
  std::vector<Verdict> verdicts = {engine.IsInconsistent().verdict};
  for (const Query& query : file.queries) {
    verdicts.push_back(
        (query.brave ? engine.HoldsSomewhere(query.literals) : engine.EntailsAlways(query.literals))
            .verdict);
  }
  return verdicts;
}

void Try(std::string_view text) {
  CircFile file = ReadCirc(text, "fuzz.circ");
  if (!file.diagnostics.empty()) {
    Require(!Format(file.diagnostics).empty(), "silent diagnostics");
    return;
  }
  const std::vector<Literal> latches = MoveFacts(file.facts, file.theory);
  if (file.theory.atoms.size() > kMostAtoms) return;
  const std::vector<Verdict> with = Verdicts(file, latches, true);
  const std::vector<Verdict> without = Verdicts(file, latches, false);
  for (std::size_t i = 0; i < with.size(); ++i) {
    const bool open = with[i] == Verdict::kUnknown || without[i] == Verdict::kUnknown;
    Require(open || with[i] == without[i], "the certificate changes an answer");
  }
  const auto core = MinimalCore(file.theory, latches, kConflicts);
  Require(!core || with[0] != Verdict::kNo, "a core of a consistent theory");
}

}  // namespace
}  // namespace latchwork::circumscription

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  latchwork::circumscription::Try({reinterpret_cast<const char*>(data), size});
  return 0;
}

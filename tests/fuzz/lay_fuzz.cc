// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a layered theory: it is refused with diagnostics, or can be written and read again
// the same; and what the procedure says of a small one agrees with Definition 1.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "reasoners/circumscription/formats/lay_file.h"
#include "reasoners/circumscription/layered/conditions.h"
#include "reasoners/circumscription/layered/layered_models.h"
#include "reasoners/circumscription/layered/procedure.h"

namespace latchwork::circumscription {
namespace {

constexpr std::size_t kMostAtoms = 40;
constexpr std::size_t kMostBridges = 40;

void Require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

bool IsSmall(const LayeredTheory& theory) {
  std::size_t atoms = 0;
  std::size_t bridges = 0;
  for (const TheoryLayer& layer : theory.layers) {
    atoms += layer.theory.atoms.size();
    bridges += layer.bridges.size();
  }
  return theory.layers.size() <= 6 && atoms <= kMostAtoms && bridges <= kMostBridges;
}

void Try(std::string_view text) {
  const LayFile file = ReadLay(text, "fuzz.lay");
  if (!file.diagnostics.empty()) {
    Require(!Format(file.diagnostics).empty(), "silent diagnostics");
    return;
  }
  const std::string written = WriteLay(file.theory, file.queries);
  const LayFile again = ReadLay(written, "again.lay");
  Require(again.diagnostics.empty(), "what was written cannot be read");
  Require(WriteLay(again.theory, again.queries) == written, "reading changes a theory");
  if (!IsSmall(file.theory)) return;
  ProcedureOptions options;
  options.engine.conflicts = 200;
  options.engine.calls = 100;
  options.max_states = 64;
  LayeredModels models(file.theory, options.engine);
  const bool has_model = models.HasModel() == Verdict::kYes;
  Procedure open(file.theory, Transfer::kOpen, options);
  Procedure refined(file.theory, Transfer::kRefined, options);
  for (const Query& query : file.queries) {
    const Verdict definition = models.Entails(query.literals).verdict;
    if (!has_model || definition == Verdict::kUnknown) continue;
    const Verdict by_open = open.Entails(query.literals).verdict;
    Require(by_open != Verdict::kYes || definition == Verdict::kYes, "open transfer is unsound");
    const Verdict by_refined = refined.Entails(query.literals).verdict;
    Require(by_refined == Verdict::kUnknown || by_refined == definition,
            "refined transfer is not exact");
  }
  static_cast<void>(CheckConditions(file.theory, options.engine));
}

}  // namespace
}  // namespace latchwork::circumscription

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  latchwork::circumscription::Try({reinterpret_cast<const char*>(data), size});
  return 0;
}

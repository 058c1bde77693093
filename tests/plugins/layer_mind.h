// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_PLUGINS_LAYER_MIND_H_
#define LATCHWORK_TESTS_PLUGINS_LAYER_MIND_H_

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/tptp.h"
#include "latchwork/plugin/registry.h"
#include "latchwork/sdk/reasoner.h"

namespace latchwork::test {

/// The reasoner of programs, for LayerMind.
inline constexpr std::string_view kIcarusMind = "icarus";

/// A layer plugin with its own body in a reasoner: latches in, conclusions out, as texts.
class LayerMind {
 public:
  explicit LayerMind(std::string_view name, std::vector<sdk::Parameters::Given> parameters = {},
                     std::string_view reasoner = "pttp")
      : registry_({std::string(LATCHWORK_BINARY_DIR) + "/plugins"}),
        layer_(registry_.MakeLayer(name)),
        reasoner_(registry_.MakeReasoner(reasoner)) {
    if (!layer_.object || !reasoner_.object) {
      ADD_FAILURE() << layer_.error << reasoner_.error;
      return;
    }
    logic::Diagnostics diagnostics;
    const auto checked =
        sdk::Parameters::Check(layer_.object->parameters(), parameters, name, {}, diagnostics);
    const auto body =
        layer_.object->MakeBody(reasoner_.object->language(), checked,
                                registry_.DataFolder(sdk::PluginKind::kLayer, name), symbols_);
    const auto unread = reasoner_.object->Load(
        body, sdk::Parameters::Defaults(reasoner_.object->parameters()), symbols_);
    diagnostics.insert(diagnostics.end(), unread.begin(), unread.end());
    EXPECT_EQ(logic::Format(diagnostics), "");
    for (const auto& port : layer_.object->contract().inputs) {
      latches_.push_back({port.name, {}, 0});
    }
  }

  void Latch(std::string_view port, const std::vector<std::string>& facts) {
    sdk::Latch& latch = latches_[PortOf(port)];
    latch.facts = Read(facts);
    ++latch.version;
  }

  /// Decides, and no more than that.
  void Cycle() {
    reasoner_.object->Decide(latches_, {.inferences = 1'000'000, .depth = 96}, decision_);
  }

  /// Sorted texts of what is concluded.
  std::vector<std::string> Decide() {
    Cycle();
    EXPECT_NE(decision_.status, sdk::Status::kFailed) << decision_.message;
    EXPECT_NE(decision_.status, sdk::Status::kInconsistent) << decision_.message;
    std::vector<std::string> texts;
    for (const auto& conclusion : decision_.conclusions) {
      texts.push_back(logic::ToString(conclusion.fact));
    }
    std::sort(texts.begin(), texts.end());
    return texts;
  }

  /// Indices of the facts that the layer refuses to let in.
  std::vector<std::size_t> Refused(std::string_view port, const std::vector<std::string>& batch) {
    std::vector<sdk::Refusal> refusals;
    reasoner_.object->Admit(latches_, PortOf(port), Read(batch), {}, refusals);
    std::vector<std::size_t> indices;
    for (const auto& refusal : refusals) indices.push_back(refusal.index);
    return indices;
  }

  const sdk::Decision& decision() const { return decision_; }

 private:
  std::size_t PortOf(std::string_view port) const {
    const auto found = std::find_if(latches_.begin(), latches_.end(),
                                    [&](const auto& latch) { return latch.port == port; });
    EXPECT_NE(found, latches_.end()) << port;
    return static_cast<std::size_t>(found - latches_.begin());
  }

  std::vector<logic::Fact> Read(const std::vector<std::string>& texts) {
    std::vector<logic::Fact> facts;
    for (const std::string& text : texts) {
      const auto read = logic::ReadTptpAtom(text, "test", symbols_);
      EXPECT_TRUE(read.atom.has_value()) << text;
      if (read.atom) facts.push_back(*read.atom);
    }
    return facts;
  }

  logic::SymbolTable symbols_;
  plugin::Registry registry_;
  plugin::Made<sdk::Layer> layer_;
  plugin::Made<sdk::Reasoner> reasoner_;
  std::vector<sdk::Latch> latches_;
  sdk::Decision decision_;
};

/// The name of a reasoner, for tests that every reasoner of a layer has to pass.
inline std::string ReasonerName(const ::testing::TestParamInfo<const char*>& reasoner) {
  return reasoner.param;
}

}  // namespace latchwork::test

#endif  // LATCHWORK_TESTS_PLUGINS_LAYER_MIND_H_

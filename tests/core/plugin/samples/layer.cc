// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/plugin.h"

namespace latchwork::samples {
namespace {

class SampleLayer : public sdk::Layer {
 public:
  const sdk::Contract& contract() const override { return contract_; }
  std::span<const sdk::ParameterSpec> parameters() const override { return {}; }
  std::vector<std::string> languages() const override { return {"sample"}; }
  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& parameters,
                     const std::filesystem::path& data,
                     logic::SymbolTable& symbols) const override {
    static_cast<void>(parameters), static_cast<void>(data), static_cast<void>(symbols);
    sdk::Body body;
    body.language = language;
    return body;
  }

 private:
  sdk::Contract contract_;
};

}  // namespace
}  // namespace latchwork::samples

// The name of the reasoner in plain.cc as well: kinds have names of their own.
LATCHWORK_PLUGIN(latchwork::samples::SampleLayer, "sample", "2.0", "a layer without ports")

// SPDX-License-Identifier: BSD-3-Clause
// Layer 1: turns a command into virtual objects.

#include <latchwork/sdk/contract_body.h>
#include <latchwork/sdk/plugin.h>
#include <latchwork/sdk/specs.h>

#include <string>
#include <vector>

namespace {

namespace logic = latchwork::logic;
namespace sdk = latchwork::sdk;

class Pusher final : public sdk::Layer {
 public:
  const sdk::Contract& contract() const override { return contract_; }
  std::span<const sdk::ParameterSpec> parameters() const override { return {}; }
  std::vector<std::string> languages() const override { return {"tptp"}; }

  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& /*parameters*/,
                     const std::filesystem::path& data,
                     logic::SymbolTable& symbols) const override {
    sdk::Body body = sdk::ContractBody(contract_, language, symbols);
    body.files = {data / "pusher.p"};
    for (sdk::Goal& goal : body.goals) goal.answers = sdk::Goal::Answers::kAll;
    for (const char* name : {"move_cmd", "pushed"}) {
      body.minimized.push_back({{symbols.Intern(name), 1}});
    }
    return body;
  }

 private:
  sdk::Contract contract_{
      .inputs = {{.name = "command",
                  .predicates = {{"move_cmd", {sdk::SymbolArgument("way")}, "what to leave"}},
                  .help = "what the user wants"}},
      .outputs = {{.name = "push",
                   .predicates = {{"pushed", {sdk::SymbolArgument("sector")}, "not to go there"}},
                   .help = "virtual objects for layer 0"}}};
};

}  // namespace

LATCHWORK_PLUGIN(Pusher, "pusher", "1.0", "layer 1: turns commands into virtual objects")

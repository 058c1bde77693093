// SPDX-License-Identifier: BSD-3-Clause
// Layer 0: keeps out of blocked sectors.

#include <latchwork/sdk/contract_body.h>
#include <latchwork/sdk/plugin.h>
#include <latchwork/sdk/specs.h>

#include <string>
#include <vector>

namespace {

namespace logic = latchwork::logic;
namespace sdk = latchwork::sdk;

class Keeper final : public sdk::Layer {
 public:
  const sdk::Contract& contract() const override { return contract_; }
  std::span<const sdk::ParameterSpec> parameters() const override { return {}; }
  std::vector<std::string> languages() const override { return {"tptp"}; }

  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& /*parameters*/,
                     const std::filesystem::path& data,
                     logic::SymbolTable& symbols) const override {
    sdk::Body body = sdk::ContractBody(contract_, language, symbols);
    body.files = {data / "keeper.p"};
    for (sdk::Goal& goal : body.goals) goal.answers = sdk::Goal::Answers::kAll;
    for (const char* name : {"object", "pushed", "blocked"}) {
      body.minimized.push_back({{symbols.Intern(name), 1}});
    }
    return body;
  }

 private:
  sdk::Contract contract_{
      .inputs = {{.name = "seen",
                  .predicates = {{"object", {sdk::SymbolArgument("sector")}, "stands there"}},
                  .help = "what the sensors see"},
                 {.name = "push",
                  .predicates = {{"pushed", {sdk::SymbolArgument("sector")}, "not to go there"}},
                  .help = "virtual objects, from above",
                  .optional = true}},
      .outputs = {{.name = "motion",
                   .predicates = {{"go", {sdk::SymbolArgument("sector")}, "is free"}},
                   .help = "where the robot may go"}}};
};

}  // namespace

LATCHWORK_PLUGIN(Keeper, "keeper", "1.0", "layer 0: keeps out of blocked sectors")

// SPDX-License-Identifier: BSD-3-Clause
// A layer written from the installed headers alone: it keeps its distance from the walls.

#include <latchwork/sdk/plugin.h>

#include <string>
#include <vector>

namespace {

namespace logic = latchwork::logic;
namespace sdk = latchwork::sdk;

class Corridor final : public sdk::Layer {
 public:
  const sdk::Contract& contract() const override { return contract_; }
  std::span<const sdk::ParameterSpec> parameters() const override { return parameters_; }
  std::vector<std::string> languages() const override { return {"tptp"}; }

  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& parameters,
                     const std::filesystem::path& data,
                     logic::SymbolTable& symbols) const override {
    const logic::Symbol turn = symbols.Intern("turn");
    sdk::Body body;
    body.language = language;
    body.files = {data / "corridor.p"};
    body.facts = sdk::ParameterFacts(parameters, symbols);
    body.inputs = {{symbols.Intern("wall"), 2}};
    body.goals.push_back({.pattern = logic::Atom(turn, {logic::Term::Var(0)}), .variables = 1});
    return body;
  }

 private:
  using Type = sdk::ArgumentType;
  sdk::Contract contract_{
      .inputs = {{.name = "walls",
                  .predicates =
                      {{"wall", {{"side", Type::kSymbol, ""}, {"distance", Type::kReal, "m"}}, ""}},
                  .help = "how far the walls are"}},
      .outputs = {{.name = "turn",
                   .predicates = {{"turn", {{"rate", Type::kReal, "rad/s"}}, ""}},
                   .help = "where to turn"}}};
  std::vector<sdk::ParameterSpec> parameters_{
      {.name = "clearance", .default_value = "0.6", .minimum = 0, .unit = "m", .help = "to keep"}};
};

}  // namespace

LATCHWORK_PLUGIN(Corridor, "corridor", "1.0", "keeps its distance from the walls")

// SPDX-License-Identifier: BSD-3-Clause
// A layer: drives towards a wall and stops before it.

#include <latchwork/sdk/plugin.h>

#include <string>
#include <vector>

namespace {

namespace logic = latchwork::logic;
namespace sdk = latchwork::sdk;

class Cruise final : public sdk::Layer {
 public:
  const sdk::Contract& contract() const override { return contract_; }
  std::span<const sdk::ParameterSpec> parameters() const override { return parameters_; }
  std::vector<std::string> languages() const override { return {"tptp", "cruise"}; }

  sdk::Body MakeBody(std::string_view language, const sdk::Parameters& parameters,
                     const std::filesystem::path& data,
                     logic::SymbolTable& symbols) const override {
    sdk::Body body;
    body.language = language;
    if (language == "tptp") body.files = {data / "cruise.p"};
    body.facts = sdk::ParameterFacts(parameters, symbols);  // speed(0.5), stop_distance(1.0)
    body.inputs = {{symbols.Intern("gap"), 1}};
    const logic::Atom goal(symbols.Intern("fwd"), {logic::Term::Var(0)});
    body.goals = {{.pattern = goal, .variables = 1}};
    return body;
  }

 private:
  using Type = sdk::ArgumentType;
  sdk::Contract contract_{
      .inputs = {{.name = "gap",
                  .predicates = {{"gap", {{"distance", Type::kReal, "m"}}, "to the wall ahead"}},
                  .help = "what is ahead"}},
      .outputs = {{.name = "drive",
                   .predicates = {{"fwd", {{"speed", Type::kReal, "m/s"}}, "how fast to drive"}},
                   .help = "for the wheels; silence stops them"}}};
  std::vector<sdk::ParameterSpec> parameters_{{.name = "speed",
                                               .default_value = "0.5",
                                               .minimum = 0,
                                               .maximum = 2,
                                               .unit = "m/s",
                                               .help = "how fast to drive"},
                                              {.name = "stop_distance",
                                               .default_value = "1.0",
                                               .minimum = 0,
                                               .unit = "m",
                                               .help = "how far from the wall to stop"}};
};

}  // namespace

LATCHWORK_PLUGIN(Cruise, "cruise", "1.0", "drives up to a wall")

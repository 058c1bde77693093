// SPDX-License-Identifier: BSD-3-Clause
// A world of two sectors: it says what is commanded, and is content when the robot goes somewhere.

#include <latchwork/sdk/plugin.h>
#include <latchwork/sdk/specs.h>

#include <string>
#include <utility>
#include <vector>

namespace {

namespace logic = latchwork::logic;
namespace sdk = latchwork::sdk;

class Sectors final : public sdk::World {
 public:
  const sdk::Contract& contract() const override { return contract_; }
  std::span<const sdk::ParameterSpec> parameters() const override { return parameters_; }
  std::span<const sdk::PredicateSpec> events() const override { return {}; }

  logic::Diagnostics Load(const sdk::WorldSetup& setup,
                          const sdk::Parameters& parameters) override {
    const logic::Term way =
        logic::Term::Constant(setup.symbols->Intern(parameters.Text("command")));
    command_ = logic::Fact(setup.symbols->Intern("move_cmd"), {way});
    return {};
  }
  void Observe(std::uint64_t, std::span<sdk::Batch> sensors) override {
    sensors[0].updated = sensors[1].updated = true;
    sensors[0].facts.clear();
    sensors[1].facts.assign(1, command_);
  }
  void Apply(std::uint64_t, std::span<const sdk::Batch> effectors) override {
    going_ = !effectors[0].facts.empty();
  }
  void Step(std::uint64_t) override {}
  logic::Diagnostics HandleEvent(std::uint64_t, const logic::Fact&) override { return {}; }
  sdk::Outcome outcome() const override {
    if (going_) return {sdk::Outcome::State::kReached, "the robot goes"};
    return {};
  }
  std::vector<std::pair<std::string, double>> Measures() const override { return {}; }
  std::vector<std::filesystem::path> Draw(const std::filesystem::path&) const override {
    return {};
  }

 private:
  sdk::Contract contract_{
      .inputs = {{.name = "motion",
                  .predicates = {{"go", {sdk::SymbolArgument("sector")}, "is free"}},
                  .help = "the wheels",
                  .optional = true}},
      .outputs = {{.name = "seen",
                   .predicates = {{"object", {sdk::SymbolArgument("sector")}, "stands there"}},
                   .help = "nothing stands anywhere"},
                  {.name = "command",
                   .predicates = {{"move_cmd", {sdk::SymbolArgument("way")}, "what to leave"}},
                   .help = "what the user wants"}}};
  std::vector<sdk::ParameterSpec> parameters_{
      sdk::ChoiceParameter("command", {"corner", "left", "right"}, "what to leave")};
  logic::Fact command_;
  bool going_ = false;
};

}  // namespace

LATCHWORK_PLUGIN(Sectors, "sectors", "1.0", "two sectors and a command")

// SPDX-License-Identifier: BSD-3-Clause
// A world: a straight track with a wall at its end, and a cart that knows how far it is.

#include <latchwork/sdk/plugin.h>
#include <latchwork/sdk/random.h>

#include <string>
#include <utility>
#include <vector>

namespace {

namespace logic = latchwork::logic;
namespace sdk = latchwork::sdk;

class Track final : public sdk::World {
 public:
  const sdk::Contract& contract() const override { return contract_; }
  std::span<const sdk::ParameterSpec> parameters() const override { return parameters_; }
  std::span<const sdk::PredicateSpec> events() const override { return events_; }

  logic::Diagnostics Load(const sdk::WorldSetup& setup,
                          const sdk::Parameters& parameters) override {
    gap_symbol_ = setup.symbols->Intern("gap");
    tick_seconds_ = setup.tick_seconds;
    const sdk::RandomStream random(setup.seed, "start");
    gap_ = parameters.Real("length") * random.Between(0.5, 1.0, 0);
    return {};
  }

  void Observe(std::uint64_t, std::span<sdk::Batch> sensors) override {
    sensors[0].updated = true;
    sensors[0].facts.assign(1, logic::Fact(gap_symbol_, {logic::Term::Real(gap_)}));
  }

  void Apply(std::uint64_t, std::span<const sdk::Batch> effectors) override {
    const std::vector<logic::Fact>& drive = effectors[0].facts;
    speed_ = drive.empty() ? 0 : drive[0].argument(0).number();
  }

  void Step(std::uint64_t) override {
    gap_ -= speed_ * tick_seconds_;
    driven_ += speed_ * tick_seconds_;
  }

  logic::Diagnostics HandleEvent(std::uint64_t, const logic::Fact& event) override {
    gap_ += event.argument(0).number();
    return {};
  }

  sdk::Outcome outcome() const override {
    if (gap_ <= 0) return {sdk::Outcome::State::kFailed, "collision with the wall"};
    if (driven_ > 0 && speed_ == 0) return {sdk::Outcome::State::kReached, "stopped at the wall"};
    return {};
  }
  std::vector<std::pair<std::string, double>> Measures() const override {
    return {{"distance_m", driven_}, {"gap_m", gap_}};
  }
  std::vector<std::filesystem::path> Draw(const std::filesystem::path&) const override {
    return {};
  }

 private:
  using Type = sdk::ArgumentType;
  sdk::Contract contract_{
      .inputs = {{.name = "drive",
                  .predicates = {{"fwd", {{"speed", Type::kReal, "m/s"}}, "how fast to drive"}},
                  .help = "the wheels",
                  .optional = true}},
      .outputs = {{.name = "gap",
                   .predicates = {{"gap", {{"distance", Type::kReal, "m"}}, "to the wall ahead"}},
                   .help = "a range finder, every tick"}}};
  std::vector<sdk::ParameterSpec> parameters_{{.name = "length",
                                               .default_value = "10",
                                               .minimum = 2,
                                               .unit = "m",
                                               .help = "of the track; the cart starts on its first "
                                                       "half"}};
  std::vector<sdk::PredicateSpec> events_{
      {"wall_moves", {{"distance", Type::kReal, "m"}}, "away from the cart"}};

  logic::Symbol gap_symbol_;
  double tick_seconds_ = 0;
  double gap_ = 0;
  double speed_ = 0;
  double driven_ = 0;
};

}  // namespace

LATCHWORK_PLUGIN(Track, "track", "1.0", "a cart on a track with a wall at its end")

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CART_POLE_CART_POLE_WORLD_H_
#define LATCHWORK_CART_POLE_CART_POLE_WORLD_H_

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/sdk/random.h"
#include "latchwork/sdk/world.h"
#include "worlds/cart_pole/cart_pole_picture.h"
#include "worlds/cart_pole/pole_dynamics.h"

namespace latchwork::cart_pole {

/// A pole on a cart on a track with ends. Ports, events and parameters: cart_pole_contract.h.
/// Thread rule: used by one thread.
class CartPoleWorld final : public sdk::World {
 public:
  CartPoleWorld();

  const sdk::Contract& contract() const override { return contract_; }
  std::span<const sdk::ParameterSpec> parameters() const override { return parameters_; }
  std::span<const sdk::PredicateSpec> events() const override { return events_; }

  logic::Diagnostics Load(const sdk::WorldSetup& setup, const sdk::Parameters& parameters) override;
  void Observe(std::uint64_t tick, std::span<sdk::Batch> sensors) override;
  void Apply(std::uint64_t tick, std::span<const sdk::Batch> effectors) override;
  void Step(std::uint64_t tick) override;
  logic::Diagnostics HandleEvent(std::uint64_t tick, const logic::Fact& event) override;

  sdk::Outcome outcome() const override { return outcome_; }
  std::vector<std::pair<std::string, double>> Measures() const override;
  std::vector<std::filesystem::path> Draw(const std::filesystem::path& folder) const override;

  /// For tests.
  const Motion& motion() const { return motion_; }

 private:
  struct Symbols {
    logic::Symbol pole_angle, pole_rate, cart_place, cart_speed, track_end, force_limit, force;
  };
  struct Limits {
    double keep_for = 60;
    double fallen = 0.5;
    double track_end = 2.4;
    double force = 10;
  };
  struct Noise {
    double angle = 0;
    double rate = 0;
    double place = 0;
    double speed = 0;
  };
  struct Tally {
    double seconds = 0;
    double greatest_angle = 0;
    double greatest_place = 0;
    double place_squared = 0;  ///< Sum over ticks.
    double force_used = 0;     ///< N s
    std::uint64_t pushes = 0;
    std::uint64_t ticks = 0;
  };

  void Start(const sdk::Parameters& parameters);
  void Push(double cart, double tip);
  void PushAtRandom(std::uint64_t tick);
  void Count();
  void Judge();

  sdk::Contract contract_;
  std::vector<sdk::ParameterSpec> parameters_;
  std::vector<sdk::PredicateSpec> events_;
  Symbols symbols_;
  std::optional<sdk::RandomStream> random_;
  CartPolePicture picture_;

  Plant plant_;
  Limits limits_;
  Noise noise_;
  double tick_seconds_ = 0.02;
  double pushes_ = 0;
  double push_strength_ = 0;

  Motion motion_;
  double force_ = 0;
  bool first_ = true;
  Tally tally_;
  sdk::Outcome outcome_;
};

}  // namespace latchwork::cart_pole

#endif  // LATCHWORK_CART_POLE_CART_POLE_WORLD_H_

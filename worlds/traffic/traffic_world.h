// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TRAFFIC_TRAFFIC_WORLD_H_
#define LATCHWORK_TRAFFIC_TRAFFIC_WORLD_H_

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/sdk/world.h"
#include "worlds/traffic/road.h"
#include "worlds/traffic/traffic_picture.h"
#include "worlds/traffic/traffic_sensors.h"

namespace latchwork::traffic {

/// A road of several lanes with other cars on it; the agent drives one to its exit. Ports, events
/// and parameters: traffic_contract.h. Thread rule: used by one thread.
class TrafficWorld final : public sdk::World {
 public:
  TrafficWorld();

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

  /// The road and its cars; for tests. Only after a successful Load.
  Road& road() { return *road_; }

 private:
  struct Counts {
    std::uint64_t ticks = 0;
    std::uint64_t trip_ticks = 0;
    std::int64_t arrived = 0;
    std::int64_t failed = 0;
    std::uint64_t collisions = 0;
    std::uint64_t others_touching = 0;
    std::uint64_t lane_changes = 0;
    std::uint64_t hard_brakings = 0;
    double distance = 0;
    double reward = 0;
    double least_headway = 99;
  };

  const Car& car() const { return road_->cars()[Road::kAgent]; }
  double Seconds(std::uint64_t ticks) const { return static_cast<double>(ticks) * tick_seconds_; }
  void SurpriseByBraking(std::uint64_t tick);
  void Brake(Car& car, double seconds) const;
  bool BrakeLeader(double seconds);
  bool BrakeNamed(const logic::Term& name, double seconds);
  void Judge();
  void Count(double braking_before);
  void CheckTrip();
  void CheckExit();
  void Arrive();
  void Fail(std::string message, double reward, bool place_anew);
  void BeginTrip();

  sdk::Contract contract_;
  std::vector<sdk::ParameterSpec> parameters_;
  std::vector<sdk::PredicateSpec> events_;
  std::optional<Road> road_;
  std::optional<TrafficSensors> sensors_;
  std::optional<sdk::RandomStream> surprises_;
  TrafficPicture picture_;
  logic::Symbol accelerate_, aim_;

  double tick_seconds_ = 0.1;
  std::uint64_t warm_up_ticks_ = 0;
  double exit_ = 0;
  double trip_seconds_ = 0;  ///< That a trip may take.
  double brakings_ = 0;
  std::int64_t trips_ = 1;
  bool end_at_failure_ = true;
  Sight sight_;

  double command_ = 0;
  TripState trip_;
  Counts counts_;
  sdk::Outcome outcome_;
};

}  // namespace latchwork::traffic

#endif  // LATCHWORK_TRAFFIC_TRAFFIC_WORLD_H_

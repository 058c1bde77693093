// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TRAFFIC_ROAD_H_
#define LATCHWORK_TRAFFIC_ROAD_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/random.h"
#include "worlds/traffic/car.h"
#include "worlds/traffic/driver.h"

namespace latchwork::traffic {

struct RoadSetup {
  double length = 2000;  ///< m, of the ring
  int lanes = 3;
  double density = 12;      ///< cars per kilometre and lane
  double trucks = 0.15;     ///< share of all cars
  double speed_limit = 30;  ///< m/s
  double dt = 0.1;          ///< s
  std::uint64_t seed = 1;
};

/// A ring of several lanes and the cars on it. Car 0 is the agent's. The others follow by the
/// intelligent driver model, change lanes by MOBIL, and each has speeds of its own liking.
class Road {
 public:
  static constexpr std::size_t kAgent = 0;

  Road(const RoadSetup& setup, logic::SymbolTable& symbols);

  /// Who is next in a lane, and how far it is from bumper to bumper; negative when side by side.
  struct Neighbour {
    std::size_t car = 0;
    double gap = 0;
  };
  std::optional<Neighbour> Ahead(std::size_t car, int lane) const;
  std::optional<Neighbour> Behind(std::size_t car, int lane) const;

  /// One step of `dt`. `command` (m/s^2) is what the agent does; without, its car drives like any
  /// other.
  void Step(std::uint64_t tick, std::optional<double> command);

  /// Puts the agent's car into the middle of the longest gap of any lane, as fast as the car
  /// behind.
  void PlaceAgent();

  const std::vector<Car>& cars() const { return cars_; }
  std::vector<Car>& cars() { return cars_; }
  const RoadSetup& setup() const { return setup_; }
  /// How far `to` is ahead of `from`, in [0, length).
  double Forward(double from, double to) const;
  /// The first car that the agent's touches.
  std::optional<std::size_t> Touched() const;
  /// Pairs of other cars that touch each other now.
  std::size_t TouchingOthers() const;
  /// How one car would drive behind whoever is ahead in all lanes that it occupies.
  double Follow(std::size_t car) const;

 private:
  void AddCars(int lane, logic::SymbolTable& symbols);
  Driver SomeDriver(std::uint64_t number, bool truck) const;
  bool Touch(const Car& a, const Car& b) const;
  double FollowIn(std::size_t car, int lane) const;
  void ConsiderLanes(std::size_t car, std::uint64_t tick);
  std::optional<double> GainIn(std::size_t car, int lane) const;

  RoadSetup setup_;
  sdk::RandomStream random_;
  std::vector<Car> cars_;
  std::vector<double> commands_;
};

}  // namespace latchwork::traffic

#endif  // LATCHWORK_TRAFFIC_ROAD_H_

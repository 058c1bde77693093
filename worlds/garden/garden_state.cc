// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/garden/garden_state.h"

#include <algorithm>
#include <cmath>

#include "latchwork/sdk/random.h"

namespace latchwork::garden {

namespace {

constexpr double kFirstHour = 6;
constexpr double kLastHour = 20;
constexpr double kRoof = 20;        // m2 that collect rain for the barrel
constexpr double kMomentEvery = 2;  // hours

std::vector<Bed> MakeBeds(std::uint64_t seed, int bed_count, int plants) {
  const sdk::RandomStream random(seed, "plants");
  std::vector<Bed> beds;
  for (int bed = 0; bed < bed_count; ++bed) {
    std::vector<Pumpkin> pumpkins(static_cast<std::size_t>(plants));
    for (std::size_t n = 0; n < pumpkins.size(); ++n) {
      const auto of_bed = static_cast<std::uint64_t>(bed);
      pumpkins[n].vigour = random.Between(0.85, 1.15, of_bed, 2 * n);
      pumpkins[n].weight = random.Between(0.15, 0.25, of_bed, 2 * n + 1);
    }
    beds.emplace_back(std::move(pumpkins));
  }
  return beds;
}

}  // namespace

GardenState::GardenState(std::uint64_t seed, int days, int bed_count, int plants,
                         const GardenerOptions& options, int portions)
    : weather(seed, days), beds(MakeBeds(seed, bed_count, plants)), gardener(options, portions) {}

bool GardenState::IsWorkingTime() const { return clock() >= kFirstHour && clock() < kLastHour; }

Air GardenState::AirNow() const {
  return {weather.Temperature(hour), weather.Light(hour), weather.Rain(hour)};
}

void GardenState::Step(std::optional<Task> task, double seconds) {
  const double hours = seconds / 3600;
  if (moments.empty() || hour >= moments.back().hour + kMomentEvery) Remember();
  gardener.Work(IsWorkingTime() ? task : std::nullopt, seconds, beds, barrel);
  const Air air = AirNow();
  for (Bed& bed : beds) bed.Step(hours, air);
  barrel.water += (barrel.spring + air.rain * kRoof) * hours;
  barrel.water = std::min(barrel.water, barrel.holds);
  seconds_ += seconds;
  hour = seconds_ / 3600;
}

void GardenState::Remember() {
  Moment moment;
  moment.hour = hour;
  moment.way = gardener.way();
  moment.sky = weather.SkyAt(hour);
  moment.temperature = weather.Temperature(hour);
  for (const Bed& bed : beds) {
    Moment::OfBed of_bed{bed.moisture(), bed.food(), bed.covered(), {}};
    for (const Pumpkin& p : bed.pumpkins()) {
      of_bed.weights.push_back(p.alive() ? p.weight : -p.weight);
    }
    moment.beds.push_back(std::move(of_bed));
  }
  moments.push_back(std::move(moment));
}

double GardenState::Weight() const {
  double sum = 0;
  for (const Bed& bed : beds) sum += bed.weight();
  return sum;
}

int GardenState::Alive() const {
  int alive = 0;
  for (const Bed& bed : beds) {
    const auto& plants = bed.pumpkins();
    alive += static_cast<int>(
        std::count_if(plants.begin(), plants.end(), [](const Pumpkin& p) { return p.alive(); }));
  }
  return alive;
}

int GardenState::Plants() const {
  int plants = 0;
  for (const Bed& bed : beds) plants += static_cast<int>(bed.pumpkins().size());
  return plants;
}

double GardenState::LeastHealth() const {
  double least = 1;
  for (const Bed& bed : beds) {
    for (const Pumpkin& p : bed.pumpkins()) least = std::min(least, p.health);
  }
  return least;
}

std::string GardenState::NameOf(std::size_t place) const {
  return place == kWell ? "well" : "b" + std::to_string(place + 1);
}

std::optional<std::size_t> GardenState::PlaceOf(std::string_view name) const {
  if (name == NameOf(kWell)) return kWell;
  for (std::size_t bed = 0; bed < beds.size(); ++bed) {
    if (name == NameOf(bed)) return bed;
  }
  return std::nullopt;
}

}  // namespace latchwork::garden

// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/garden/garden_sensors.h"

#include <algorithm>
#include <array>

#include "worlds/garden/garden_contract.h"

namespace latchwork::garden {

using logic::Fact;
using logic::Term;

GardenSensors::GardenSensors(double probe_noise, std::uint64_t seed, const GardenState& state,
                             logic::SymbolTable& symbols)
    : probe_noise_(probe_noise),
      probe_random_(seed, "probes"),
      bed_(symbols.Intern("bed")),
      day_(symbols.Intern("day")),
      hour_(symbols.Intern("hour")),
      working_(symbols.Intern("working")),
      sky_(symbols.Intern("sky")),
      sun_(symbols.Intern("sun")),
      cloud_(symbols.Intern("cloud")),
      rain_(symbols.Intern("rain")),
      temperature_(symbols.Intern("temperature")),
      rain_expected_(symbols.Intern("rain_expected")),
      low_expected_(symbols.Intern("low_expected")),
      soil_(symbols.Intern("soil")),
      covered_(symbols.Intern("covered")),
      at_(symbols.Intern("at")),
      well_(symbols.Intern("well")),
      food_(symbols.Intern("food")),
      pumpkin_(symbols.Intern("pumpkin")),
      tank_(symbols.Intern("tank")),
      barrel_(symbols.Intern("barrel")),
      portions_(symbols.Intern("portions")) {
  for (std::size_t bed = 0; bed < state.beds.size(); ++bed) {
    names_.push_back(Term::Constant(symbols.Intern(state.NameOf(bed))));
  }
}

void GardenSensors::Observe(std::uint64_t tick, const GardenState& state,
                            std::span<sdk::Batch> sensors) {
  for (std::size_t port = 0; port < sensors.size(); ++port) {
    sensors[port].updated =
        (port != kMap || tick == 0) && (port != kForecast || state.day() != said_day_);
    if (sensors[port].updated) sensors[port].facts.clear();
  }
  if (sensors[kMap].updated) SayMap(state, sensors[kMap].facts);
  SayClock(state, sensors[kClock].facts);
  SayWeather(state, sensors[kWeather].facts);
  if (sensors[kForecast].updated) SayForecast(state, sensors[kForecast].facts);
  SayBeds(tick, state, sensors[kBeds].facts);
  SayInspection(state, sensors[kInspection].facts);
  SayStock(state, sensors[kStock].facts);
  said_day_ = state.day();
}

void GardenSensors::SayMap(const GardenState& state, Facts& facts) const {
  for (std::size_t bed = 0; bed < names_.size(); ++bed) {
    facts.push_back(Fact(bed_, {names_[bed], Term::Real(state.gardener.WayTo(bed))}));
  }
}

void GardenSensors::SayClock(const GardenState& state, Facts& facts) const {
  facts.push_back(Fact(day_, {Term::Integer(state.day())}));
  facts.push_back(Fact(hour_, {Term::Real(state.clock())}));
  if (state.IsWorkingTime()) facts.push_back(Fact(working_, {}));
}

void GardenSensors::SayWeather(const GardenState& state, Facts& facts) const {
  const std::array<logic::Symbol, 3> skies = {sun_, cloud_, rain_};
  const auto sky = static_cast<std::size_t>(state.weather.SkyAt(state.hour));
  facts.push_back(Fact(sky_, {Term::Constant(skies.at(sky))}));
  facts.push_back(Fact(temperature_, {Term::Real(state.weather.Temperature(state.hour))}));
}

void GardenSensors::SayForecast(const GardenState& state, Facts& facts) const {
  const Forecast forecast = state.weather.ForecastAt(state.hour);
  facts.push_back(Fact(rain_expected_, {Term::Integer(0), Term::Real(forecast.rain_today)}));
  facts.push_back(Fact(rain_expected_, {Term::Integer(1), Term::Real(forecast.rain_tomorrow)}));
  facts.push_back(Fact(low_expected_, {Term::Real(forecast.low_tonight)}));
}

void GardenSensors::SayBeds(std::uint64_t tick, const GardenState& state, Facts& facts) const {
  for (std::size_t bed = 0; bed < names_.size(); ++bed) {
    const double noise = probe_noise_ * probe_random_.Gaussian(tick, bed);
    const double moisture = std::clamp(state.beds[bed].moisture() + noise, 0.0, 1.0);
    facts.push_back(Fact(soil_, {names_[bed], Term::Real(moisture)}));
    if (state.beds[bed].covered()) facts.push_back(Fact(covered_, {names_[bed]}));
  }
}

void GardenSensors::SayInspection(const GardenState& state, Facts& facts) const {
  const auto place = state.gardener.place(state.beds.size());
  if (!place) return;
  if (*place == kWell) {
    facts.push_back(Fact(at_, {Term::Constant(well_)}));
    return;
  }
  const Term& name = names_[*place];
  const Bed& bed = state.beds[*place];
  facts.push_back(Fact(at_, {name}));
  facts.push_back(Fact(food_, {name, Term::Real(bed.food())}));
  std::int64_t number = 0;
  for (const Pumpkin& p : bed.pumpkins()) {
    facts.push_back(Fact(
        pumpkin_, {name, Term::Integer(++number), Term::Real(p.weight), Term::Real(p.health)}));
  }
}

void GardenSensors::SayStock(const GardenState& state, Facts& facts) const {
  facts.push_back(Fact(tank_, {Term::Real(state.gardener.water())}));
  facts.push_back(Fact(barrel_, {Term::Real(state.barrel.water)}));
  facts.push_back(Fact(portions_, {Term::Integer(state.gardener.portions())}));
}

}  // namespace latchwork::garden

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_WORLD_H_
#define LATCHWORK_SDK_WORLD_H_

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/contract.h"
#include "latchwork/sdk/parameters.h"
#include "latchwork/sdk/undecided.h"

namespace latchwork::sdk {

struct WorldSetup {
  std::uint64_t seed = 0;
  double tick_seconds = 0.1;
  std::filesystem::path data;  ///< The folder with the plugin's own files.
  logic::SymbolTable* symbols = nullptr;
};

/// What one sensor said in this tick. A sensor that has nothing new sets `updated` to false: its
/// last batch stands.
struct Batch {
  bool updated = false;
  std::vector<logic::Fact> facts;
  Undecided undecided = {};  ///< Reaches latches only, never an effector.
};

struct Outcome {
  enum class State : std::uint8_t { kRunning, kReached, kFailed };
  State state = State::kRunning;
  std::string message;  ///< "reached r3_12", "collision with a wall at floor 2 (12.3, 4.5)".
};

/// What the agent lives in. Its contract's outputs are sensors, its inputs effectors. A run is a
/// function of (parameters, seed, effector facts, events): all randomness comes from RandomStream
/// with the seed of the setup. Order of calls: Load once and successfully; then for every tick k =
/// 0, 1, …: HandleEvent*, Observe, Apply, Step. Thread rule: used by one thread.
class World {
 public:
  virtual ~World() = default;

  virtual const Contract& contract() const = 0;
  virtual std::span<const ParameterSpec> parameters() const = 0;
  /// Predicates of the exogenous events that it understands (`out_of_order(e2)`).
  virtual std::span<const PredicateSpec> events() const = 0;

  virtual logic::Diagnostics Load(const WorldSetup& setup, const Parameters& parameters) = 0;
  /// Fills one batch per sensor, in contract order; the vectors are reused.
  virtual void Observe(std::uint64_t tick, std::span<Batch> sensors) = 0;
  /// What each effector is told in this tick, in contract order; an empty batch means that nobody
  /// commands it.
  virtual void Apply(std::uint64_t tick, std::span<const Batch> effectors) = 0;
  virtual void Step(std::uint64_t tick) = 0;
  /// Something that happens to the world from outside. The diagnostic says why it could not (no
  /// such door, …).
  virtual logic::Diagnostics HandleEvent(std::uint64_t tick, const logic::Fact& event) = 0;

  virtual Outcome outcome() const = 0;
  /// Figures of the run so far by name: "collisions", "distance_m", …
  virtual std::vector<std::pair<std::string, double>> Measures() const = 0;
  /// Draws what happened since Load into files of the folder; returns what was written. Needs no
  /// display.
  virtual std::vector<std::filesystem::path> Draw(const std::filesystem::path& folder) const = 0;
};

}  // namespace latchwork::sdk

#endif  // LATCHWORK_SDK_WORLD_H_

// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/report/floor_plan.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <span>
#include <system_error>
#include <utility>

#include "apps/compare/runs/run_plan.h"
#include "apps/compare/runs/run_queue.h"

namespace latchwork::compare {
namespace {

constexpr double kLongestDrawing = 30;  // s

/// The numbers of NAME="1 2 3"; false when there are not just so many.
bool ReadNumbers(std::string_view head, std::string_view name, std::span<double> numbers) {
  const std::string key = fmt::format(" {}=\"", name);
  const std::size_t at = head.find(key);
  if (at == std::string_view::npos) return false;
  std::string_view rest = head.substr(at + key.size());
  rest = rest.substr(0, rest.find('"'));
  for (double& number : numbers) {
    while (rest.starts_with(' ')) rest.remove_prefix(1);
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (error != std::errc()) return false;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  }
  return rest.empty();
}

/// "plan12.svg" is of floor 12.
std::optional<std::int64_t> FloorOf(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  if (!name.starts_with("plan") || !name.ends_with(".svg")) return std::nullopt;
  const std::string_view digits = std::string_view(name).substr(4, name.size() - 8);
  std::int64_t floor = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), floor);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return floor;
}

Building ReadBuilding(const std::filesystem::path& folder) {
  Building building;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const auto floor = FloorOf(entry.path());
    if (!floor) continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream),
                           std::istreambuf_iterator<char>()};
    if (auto plan = ReadPlan(text)) building.emplace(*floor, std::move(*plan));
  }
  return building;
}

/// Whether it came to its end, with the goal reached or not.
bool HasRun(Outcome outcome) {
  return outcome != Outcome::kTimedOut && outcome != Outcome::kCrashed &&
         outcome != Outcome::kInvalid;
}

/// A new folder that is gone with this object; empty where none can be made.
class Scratch {
 public:
  Scratch() {
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "latchwork-XXXXXX").string();
    if (!error && mkdtemp(name.data()) != nullptr) path_ = name;
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code error;
    if (!path_.empty()) std::filesystem::remove_all(path_, error);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

std::optional<FloorPlan> ReadPlan(std::string_view svg) {
  const std::size_t end = svg.find('>');
  const std::size_t close = svg.rfind("</svg>");
  if (!svg.starts_with("<svg ") || close == std::string_view::npos || end > close) {
    return std::nullopt;
  }
  std::array<double, 4> view{};
  std::array<double, 4> area{};
  const std::string_view head = svg.substr(0, end);
  if (!ReadNumbers(head, "viewBox", view) || !ReadNumbers(head, "data-area", area) ||
      !(area[2] > area[0]) || !(view[2] > 0) || !(view[3] > 0)) {
    return std::nullopt;
  }
  return FloorPlan{std::string(svg.substr(end + 1, close - end - 1)),
                   view[2],
                   view[3],
                   area[0],
                   area[3],
                   view[2] / (area[2] - area[0])};
}

std::map<std::string, Building> DrawBuildings(const Experiment& experiment, const Launch& launch,
                                              const std::atomic<bool>& stop) {
  std::map<std::string, Building> buildings;
  RunLimits limits = experiment.limits;
  limits.wall_seconds = std::min(limits.wall_seconds, kLongestDrawing);
  ForkServer server(launch);
  for (PlannedRun& run : PlanRuns(experiment)) {
    if (run.key.seed != experiment.first_seed) break;
    if (buildings.contains(run.key.scenario)) continue;
    const Scratch scratch;
    if (scratch.path().empty()) return buildings;
    run.arguments.insert(run.arguments.end(), {"--ticks", "1", "--out", scratch.path().string()});
    const auto record = MakeRun(server, {run, limits}, stop);
    if (!record) return buildings;
    Building building = ReadBuilding(scratch.path());
    if (building.empty() && !HasRun(record->outcome)) continue;
    buildings[run.key.scenario] = std::move(building);
  }
  return buildings;
}

}  // namespace latchwork::compare

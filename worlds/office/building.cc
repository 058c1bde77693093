// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/building.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <span>
#include <utility>

#include "latchwork/logic/tptp.h"

namespace latchwork::office {

namespace {

constexpr double kDoorZone = 0.30;
constexpr std::int64_t kTopFloor = 1000;

template <typename Items>
std::optional<std::size_t> FindByName(const Items& items, std::string_view name) {
  const auto found = std::find_if(items.begin(), items.end(),
                                  [&](const auto& item) { return item.name.name() == name; });
  if (found == items.end()) return std::nullopt;
  return static_cast<std::size_t>(found - items.begin());
}

/// Reads the atoms of a building in two passes: what has a name first, then what refers to names.
class BuildingReader {
 public:
  BuildingReader(std::filesystem::path folder, logic::TptpFile& file)
      : folder_(std::move(folder)), formulas_(file.formulas) {
    result_.diagnostics = std::move(file.diagnostics);
  }

  LoadedBuilding Read() {
    if (!result_.diagnostics.empty()) return std::move(result_);
    Pass({{"floor", 3, "iwn", &BuildingReader::AddFloor}});
    std::sort(building().floors.begin(), building().floors.end(),
              [](const Storey& a, const Storey& b) { return a.number < b.number; });
    Pass({{"landmark", 4, "winn", &BuildingReader::AddLandmark},
          {"room", 6, "winnnn", &BuildingReader::AddRoom},
          {"door", 6, "winnnn", &BuildingReader::AddDoor},
          {"elevator", 9, "wnnnnnnnn", &BuildingReader::AddElevator}});
    Pass({{"adjacent", 2, "ww", &BuildingReader::AddEdge},
          {"cab", 2, "ww", &BuildingReader::AddCab},
          {"lobby", 3, "wwi", &BuildingReader::AddLobby}});
    RefuseTheRest();
    CheckWhole();
    return std::move(result_);
  }

 private:
  using Terms = std::span<const logic::Term>;
  struct Reading {
    std::string_view name;
    std::size_t arity;
    std::string_view shape;  ///< w: a word, n: a number, i: a floor
    void (BuildingReader::*add)(Terms);
  };

  Building& building() { return result_.building; }

  void Fail(std::string message, std::string hint = {}) {
    result_.diagnostics.push_back({place_, std::move(message), std::move(hint), {}});
  }

  void Pass(std::initializer_list<Reading> readings) {
    done_.resize(formulas_.size(), false);
    for (std::size_t i = 0; i < formulas_.size(); ++i) {
      const auto& formula = formulas_[i].formula;
      if (formula.kind() != logic::Formula::Kind::kAtom) continue;
      const logic::Atom& atom = formula.atom();
      for (const Reading& reading : readings) {
        if (atom.predicate().name() != reading.name || atom.arity() != reading.arity) continue;
        done_[i] = true;
        place_ = formulas_[i].place;
        if (HasShape(atom, reading.shape)) (this->*reading.add)(atom.arguments());
      }
    }
  }

  bool HasShape(const logic::Atom& atom, std::string_view shape) {
    for (std::size_t i = 0; i < shape.size(); ++i) {
      if (Fits(atom.argument(i), shape[i])) continue;
      const std::string_view kind =
          shape[i] == 'w' ? "name" : (shape[i] == 'n' ? "number" : "floor: a whole number");
      Fail("argument " + std::to_string(i + 1) + " of '" + std::string(atom.predicate().name()) +
           "' must be a " + std::string(kind));
      return false;
    }
    return true;
  }

  static bool Fits(const logic::Term& term, char shape) {
    if (shape == 'w') return term.kind() == logic::Term::Kind::kConstant;
    if (shape == 'n') return term.is_number();
    return term.kind() == logic::Term::Kind::kInteger && std::abs(term.integer()) <= kTopFloor;
  }

  void RefuseTheRest() {
    static const std::vector<std::string> known{"floor", "landmark", "adjacent", "door",
                                                "room",  "elevator", "cab",      "lobby"};
    for (std::size_t i = 0; i < formulas_.size(); ++i) {
      if (done_[i]) continue;
      place_ = formulas_[i].place;
      const auto& formula = formulas_[i].formula;
      if (formula.kind() != logic::Formula::Kind::kAtom) {
        Fail("a building is described by ground unit clauses alone");
        continue;
      }
      const auto name = ToString(logic::NameOf(formula.atom()));
      const auto near = logic::NearestName(formula.atom().predicate().name(), known);
      Fail("'" + name + "' does not describe a building",
           near.empty() ? std::string() : "did you mean '" + std::string(near) + "'?");
    }
  }

  void CheckWhole() {
    if (!result_.diagnostics.empty()) return;
    if (building().floors.empty()) Fail("the building has no floor");
    for (const ElevatorShaft& shaft : building().elevators) {
      for (std::size_t i = 0; i < shaft.lobbies.size(); ++i) {
        if (shaft.lobbies[i] != kUnset) continue;
        Fail("elevator '" + std::string(shaft.name.name()) + "' has no lobby on floor " +
             std::to_string(building().floors[i].number));
      }
      if (shaft.cab_landmark == kUnset) {
        Fail("elevator '" + std::string(shaft.name.name()) + "' has no cab landmark");
      }
    }
  }

  std::optional<int> FloorOf(const logic::Term& term) {
    const auto floor = building().FindFloor(term.integer());
    if (!floor) Fail("there is no floor " + logic::ToString(term));
    return floor;
  }

  std::optional<std::size_t> LandmarkOf(const logic::Term& term) {
    const auto found = index_.find(term.symbol());
    if (found != index_.end()) return found->second;
    std::vector<std::string> names;
    for (const Landmark& landmark : building().landmarks) names.emplace_back(landmark.name.name());
    const auto near = logic::NearestName(term.symbol().name(), names);
    Fail("there is no landmark '" + std::string(term.symbol().name()) + "'",
         near.empty() ? std::string() : "did you mean '" + std::string(near) + "'?");
    return std::nullopt;
  }

  ElevatorShaft* ElevatorOf(const logic::Term& term) {
    const auto found = building().FindElevator(term.symbol().name());
    if (!found) Fail("there is no elevator '" + std::string(term.symbol().name()) + "'");
    return found ? &building().elevators[*found] : nullptr;
  }

  void AddFloor(Terms t) {
    const int number = static_cast<int>(t[0].integer());
    if (building().FindFloor(number)) return Fail("floor " + std::to_string(number) + " twice");
    auto loaded = LoadCells(folder_ / t[1].symbol().name(), t[2].number());
    if (!loaded.cells) return Fail(std::move(loaded.error));
    building().floors.push_back({number, FloorMap(*loaded.cells)});
  }

  void AddLandmark(Terms t) {
    const bool in_cab = t[1].integer() == 0;
    const auto floor = in_cab ? std::optional(-1) : FloorOf(t[1]);
    if (!floor) return;
    if (!index_.emplace(t[0].symbol(), building().landmarks.size()).second) {
      return Fail("landmark '" + std::string(t[0].symbol().name()) + "' twice");
    }
    building().landmarks.push_back({t[0].symbol(), *floor, {t[2].number(), t[3].number()}});
  }

  void AddRoom(Terms t) {
    const auto floor = FloorOf(t[1]);
    if (!floor) return;
    building().rooms.push_back(
        {t[0].symbol(), *floor, {t[2].number(), t[3].number(), t[4].number(), t[5].number()}});
  }

  void AddDoor(Terms t) {
    const auto floor = FloorOf(t[1]);
    if (!floor) return;
    const auto landmark = index_.find(t[0].symbol());
    if (landmark != index_.end()) building().landmarks[landmark->second].zone = kDoorZone;
    building().doors.push_back(
        {t[0].symbol(), *floor, {{t[2].number(), t[3].number()}, {t[4].number(), t[5].number()}}});
  }

  void AddElevator(Terms t) {
    ElevatorShaft shaft;
    shaft.name = t[0].symbol();
    shaft.cab = {t[1].number(), t[2].number(), t[3].number(), t[4].number()};
    shaft.door = {{t[5].number(), t[6].number()}, {t[7].number(), t[8].number()}};
    shaft.cab_landmark = kUnset;
    shaft.lobbies.assign(building().floors.size(), kUnset);
    building().elevators.push_back(std::move(shaft));
  }

  void AddEdge(Terms t) {
    const auto a = LandmarkOf(t[0]);
    const auto b = LandmarkOf(t[1]);
    if (!a || !b) return;
    if (building().landmarks[*a].floor != building().landmarks[*b].floor) {
      return Fail("adjacent landmarks lie on different floors");
    }
    building().edges.push_back({*a, *b});
  }

  void AddCab(Terms t) {
    ElevatorShaft* shaft = ElevatorOf(t[0]);
    const auto landmark = LandmarkOf(t[1]);
    if (shaft != nullptr && landmark) shaft->cab_landmark = *landmark;
  }

  void AddLobby(Terms t) {
    ElevatorShaft* shaft = ElevatorOf(t[0]);
    const auto landmark = LandmarkOf(t[1]);
    const auto floor = FloorOf(t[2]);
    if (shaft != nullptr && landmark && floor) {
      shaft->lobbies[static_cast<std::size_t>(*floor)] = *landmark;
    }
  }

  static constexpr std::size_t kUnset = static_cast<std::size_t>(-1);

  std::filesystem::path folder_;
  std::vector<logic::AnnotatedFormula>& formulas_;
  LoadedBuilding result_;
  std::vector<bool> done_;
  std::map<logic::Symbol, std::size_t> index_;
  logic::SourcePlace place_;
};

}  // namespace

std::optional<std::size_t> Building::FindLandmark(std::string_view name) const {
  return FindByName(landmarks, name);
}

std::optional<std::size_t> Building::FindDoor(std::string_view name) const {
  return FindByName(doors, name);
}

std::optional<std::size_t> Building::FindElevator(std::string_view name) const {
  return FindByName(elevators, name);
}

std::optional<int> Building::FindFloor(std::int64_t number) const {
  for (std::size_t i = 0; i < floors.size(); ++i) {
    if (floors[i].number == number) return static_cast<int>(i);
  }
  return std::nullopt;
}

LoadedBuilding ReadBuilding(const std::filesystem::path& file, logic::SymbolTable& symbols) {
  logic::TptpFile tptp = logic::ReadTptpFile(file, symbols);
  LoadedBuilding loaded = BuildingReader(file.parent_path(), tptp).Read();
  for (auto& diagnostic : loaded.diagnostics) {
    if (diagnostic.place.file.empty()) diagnostic.place.file = file.string();
  }
  return loaded;
}

LoadedBuilding ReadBareMap(const std::filesystem::path& file, double resolution,
                           const logic::SourcePlace& place) {
  LoadedBuilding loaded;
  auto cells = LoadCells(file, resolution);
  if (cells.cells) {
    loaded.building.floors.push_back({1, FloorMap(*cells.cells)});
  } else {
    loaded.diagnostics.push_back({place, std::move(cells.error), {}, {}});
  }
  return loaded;
}

}  // namespace latchwork::office

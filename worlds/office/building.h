// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_BUILDING_H_
#define LATCHWORK_OFFICE_BUILDING_H_

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/symbol.h"
#include "worlds/office/floor_map.h"
#include "worlds/office/geometry.h"

namespace latchwork::office {

/// A named place. `floor` is an index into Building::floors; -1: in a cab, wherever the cab is.
struct Landmark {
  logic::Symbol name;
  int floor = 0;
  Point place;
  double zone = 0.45;  ///< The robot is at the landmark when its centre comes this near, m.
};

struct Edge {
  std::size_t a = 0;
  std::size_t b = 0;
};

struct Door {
  logic::Symbol name;
  int floor = 0;
  Segment leaf;
};

struct Room {
  logic::Symbol name;
  int floor = 0;
  Rect area;
};

struct ElevatorShaft {
  logic::Symbol name;
  Rect cab;
  Segment door;
  std::size_t cab_landmark = 0;
  std::vector<std::size_t> lobbies;  ///< Landmark in front of the door, by floor index.
};

struct Storey {
  int number = 0;  ///< As people call it.
  FloorMap map;
};

/// A building as it stands: floors, landmarks and their graph, doors, rooms, elevators.
struct Building {
  std::vector<Storey> floors;
  std::vector<Landmark> landmarks;
  std::vector<Edge> edges;
  std::vector<Door> doors;
  std::vector<Room> rooms;
  std::vector<ElevatorShaft> elevators;

  std::optional<std::size_t> FindLandmark(std::string_view name) const;
  std::optional<std::size_t> FindDoor(std::string_view name) const;
  std::optional<std::size_t> FindElevator(std::string_view name) const;
  std::optional<int> FindFloor(std::int64_t number) const;
};

struct LoadedBuilding {
  Building building;
  logic::Diagnostics diagnostics;  ///< Not empty: `building` must not be used.
};

/// Reads a TPTP file of ground unit clauses: floor/3, landmark/4, adjacent/2, door/6, room/6,
/// elevator/9, cab/2, lobby/3 (their meaning stands at the head of data/building/building.p), and
/// the floors' maps beside it. Other clauses are refused, every mistake with its place.
LoadedBuilding ReadBuilding(const std::filesystem::path& file, logic::SymbolTable& symbols);

/// One floor from any map that LoadCells takes, without landmarks.
LoadedBuilding ReadBareMap(const std::filesystem::path& file, double resolution,
                           const logic::SourcePlace& place);

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_BUILDING_H_

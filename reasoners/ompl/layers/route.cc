// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/layers/route.h"

#include <algorithm>
#include <limits>

namespace latchwork::planning {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Dijkstra over the start, the goal and the fronts of the elevators. A way on foot is planned only
/// where its beeline would still be worth it.
class RouteSearch {
 public:
  RouteSearch(const JobSetup& setup, const Building& building, Legs& legs, Effort& effort)
      : setup_(&setup), building_(&building), legs_(&legs), effort_(&effort) {}

  FoundRoute Find(logic::Symbol from, logic::Symbol to) {
    Add(to);
    Add(from);
    nodes_[1].cost = 0.0;
    for (const Elevator& elevator : building_->elevators) {
      for (const logic::Symbol front : elevator.fronts) Add(front);
    }
    while (Node* const node = Cheapest()) {
      node->settled = true;
      if (node == &nodes_[0]) return {FoundPath::State::kFound, StagesTo(*node)};
      Ride(*node);
      Walk(*node);
    }
    return {is_cut_ ? FoundPath::State::kUnknown : FoundPath::State::kNone, {}};
  }

 private:
  struct Node {
    logic::Symbol landmark;
    Place place;
    double cost = kFar;
    bool settled = false;
    Stage stage;  ///< By which it is reached.
  };

  void Add(logic::Symbol landmark) {
    const auto place = setup_->map->landmarks.find(landmark);
    if (place == setup_->map->landmarks.end() || Find(landmark) != nullptr) return;
    nodes_.push_back({landmark, place->second, kFar, false, {}});
  }

  Node* Find(logic::Symbol landmark) {
    const auto found = std::find_if(nodes_.begin(), nodes_.end(),
                                    [&](const Node& node) { return node.landmark == landmark; });
    return found == nodes_.end() ? nullptr : &*found;
  }

  /// The first of equally cheap ones, or none.
  Node* Cheapest() {
    Node* best = nullptr;
    for (Node& node : nodes_) {
      if (node.settled || node.cost == kFar) continue;
      if (best == nullptr || node.cost < best->cost) best = &node;
    }
    return best;
  }

  void Reach(Node& node, double cost, Stage stage) {
    if (cost >= node.cost) return;
    node.cost = cost;
    node.stage = std::move(stage);
  }

  void Ride(const Node& from) {
    for (const Elevator& elevator : building_->elevators) {
      const bool in_cab = elevator.cab == from.landmark;
      const bool before = std::find(elevator.fronts.begin(), elevator.fronts.end(),
                                    from.landmark) != elevator.fronts.end();
      if (!in_cab && !(before && elevator.usable)) continue;
      for (const logic::Symbol front : elevator.fronts) {
        Node* const to = Find(front);
        if (to == nullptr || front == from.landmark) continue;
        if (!elevator.usable && elevator.at != to->place.floor) continue;
        Reach(*to, from.cost + setup_->ride_cost, {from.landmark, front, elevator.name, {}});
      }
    }
  }

  void Walk(const Node& from) {
    for (Node& to : nodes_) {
      if (to.settled || from.place.floor != to.place.floor || from.place.floor == 0) continue;
      const double least = from.cost + Distance(from.place.at, to.place.at);
      if (least >= to.cost || least >= nodes_[0].cost) continue;
      FoundPath found = legs_->Between(from.landmark, to.landmark, *effort_);
      is_cut_ = is_cut_ || found.state == FoundPath::State::kUnknown;
      if (found.state != FoundPath::State::kFound) continue;
      const double cost = from.cost + Length(found.path);
      Reach(to, cost, {from.landmark, to.landmark, {}, std::move(found.path)});
    }
  }

  std::vector<Stage> StagesTo(const Node& goal) {
    std::vector<Stage> stages;
    for (const Node* node = &goal; node->stage.from;) {
      stages.push_back(node->stage);
      node = Find(node->stage.from);
    }
    std::reverse(stages.begin(), stages.end());
    return stages;
  }

  const JobSetup* setup_;
  const Building* building_;
  Legs* legs_;
  Effort* effort_;
  std::vector<Node> nodes_;  ///< The goal, the start, the fronts.
  bool is_cut_ = false;
};

}  // namespace

FoundRoute FindRoute(const JobSetup& setup, const Building& building, Legs& legs,
                     logic::Symbol from, logic::Symbol to, Effort& effort) {
  if (from == to) return {FoundPath::State::kFound, {}};
  return RouteSearch(setup, building, legs, effort).Find(from, to);
}

}  // namespace latchwork::planning

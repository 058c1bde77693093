// SPDX-License-Identifier: BSD-3-Clause
//
// A path to the destination, kept until the robot strays from it; what pushes stands opposite the
// point of it a little ahead.
#include <cmath>
#include <numbers>
#include <optional>

#include "reasoners/ompl/layers/follow_path.h"
#include "reasoners/ompl/layers/job.h"

namespace latchwork::planning {
namespace {

using logic::Fact;
using logic::Term;

constexpr double kLeastLookahead = 0.3;  // m

double WrapAngle(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

double BodyNumber(const sdk::Body& body, std::string_view name, double otherwise) {
  for (const Fact& fact : body.facts) {
    if (fact.predicate().name() == name && fact.arity() == 1 && fact.argument(0).is_number()) {
      return fact.argument(0).number();
    }
  }
  return otherwise;
}

struct Pose {
  std::int64_t floor = 0;
  Point at;
  double heading = 0.0;
};

class SeekJob final : public Job {
 public:
  SeekJob(const JobSetup& setup, const sdk::Body& body, logic::SymbolTable& symbols)
      : setup_(setup),
        arrive_tolerance_(BodyNumber(body, "arrive_tolerance", 0.2)),
        push_distance_(BodyNumber(body, "push_distance", 1.0)),
        sector_width_(BodyNumber(body, "sector_width", 0.0)),
        curr_location_(symbols.Intern("curr_location")),
        curr_heading_(symbols.Intern("curr_heading")),
        curr_floor_(symbols.Intern("curr_floor")),
        move_cmd_(symbols.Intern("move_cmd")),
        object_(symbols.Intern("object")),
        distance_(symbols.Intern("distance")),
        direction_(symbols.Intern("direction")),
        push_object_(Term::Constant(symbols.Intern("push_object"))) {
    for (const auto& [number, map] : setup_.map->floors) {
      spaces_.emplace(number, FreeSpace(map, setup_.clearance));
    }
  }

  Verdict Decide(const LatchFacts& latches, Effort& effort) override {
    const std::optional<Pose> pose = PoseFrom(latches);
    const Fact* const command = latches.First({move_cmd_, 2});
    if (!pose || command == nullptr) return {};
    const Point to{command->argument(0).number(), command->argument(1).number()};
    if (Distance(pose->at, to) <= arrive_tolerance_) return {};
    const auto space = spaces_.find(pose->floor);
    if (space == spaces_.end()) {
      return {FoundPath::State::kNone, {}, "the map has no floor " + std::to_string(pose->floor)};
    }
    const FoundPath::State state = Plan(*pose, to, space->second, effort);
    if (state != FoundPath::State::kFound) return {state, {}, {}};
    return {state, Push(*pose, space->second), {}};
  }

 private:
  /// Without a word of the floor it is the lowest.
  std::optional<Pose> PoseFrom(const LatchFacts& latches) const {
    const Fact* const place = latches.First({curr_location_, 2});
    const Fact* const heading = latches.First({curr_heading_, 1});
    const Fact* const floor = latches.First({curr_floor_, 1});
    if (place == nullptr || heading == nullptr) return std::nullopt;
    return Pose{floor != nullptr ? floor->argument(0).integer() : spaces_.begin()->first,
                {place->argument(0).number(), place->argument(1).number()},
                heading->argument(0).number()};
  }

  bool PathFits(const Pose& pose, Point to) const {
    return path_.size() >= 2 && floor_ == pose.floor && to_ == to &&
           NearestOn(path_, pose.at).distance <= setup_.stray;
  }

  FoundPath::State Plan(const Pose& pose, Point to, const FreeSpace& space, Effort& effort) {
    if (PathFits(pose, to)) return FoundPath::State::kFound;
    FoundPath found = FindPath(space, {pose.at, pose.heading}, to, setup_.paths, effort);
    if (found.state == FoundPath::State::kUnknown) ++setup_.paths.attempt;
    path_ = std::move(found.path);
    floor_ = pose.floor;
    to_ = to;
    return found.state;
  }

  /// Rounded to the layer's sectors: sector 0 is centred ahead, halves round away from zero.
  double Rounded(double bearing) const {
    return sector_width_ > 0.0 ? std::round(bearing / sector_width_) * sector_width_ : bearing;
  }

  /// As far ahead on the path as the robot can go straight, up to the lookahead.
  Point Ahead(Point at, const FreeSpace& space) const {
    const double along = NearestOn(path_, at).along;
    for (double ahead = setup_.lookahead; ahead > kLeastLookahead; ahead /= 2.0) {
      const Point point = PointAt(path_, along + ahead);
      if (space.IsFree(at, point)) return point;
    }
    return PointAt(path_, along + kLeastLookahead);
  }

  std::vector<Fact> Push(const Pose& pose, const FreeSpace& space) const {
    const Point ahead = Ahead(pose.at, space);
    const double bearing =
        Rounded(WrapAngle(std::atan2(ahead.y - pose.at.y, ahead.x - pose.at.x) - pose.heading));
    const double opposite = bearing > 0.0 ? bearing - std::numbers::pi : bearing + std::numbers::pi;
    return {Fact(object_, {push_object_}),
            Fact(distance_, {push_object_, Term::Real(push_distance_)}),
            Fact(direction_, {push_object_, Term::Real(opposite)})};
  }

  JobSetup setup_;
  double arrive_tolerance_;
  double push_distance_;
  double sector_width_;
  logic::Symbol curr_location_, curr_heading_, curr_floor_, move_cmd_, object_, distance_,
      direction_;
  Term push_object_;
  std::map<std::int64_t, FreeSpace> spaces_;
  Path path_;
  std::int64_t floor_ = 0;
  Point to_;
};

}  // namespace

std::unique_ptr<Job> MakeSeekJob(const JobSetup& setup, const sdk::Body& body,
                                 logic::SymbolTable& symbols) {
  return std::make_unique<SeekJob>(setup, body, symbols);
}

}  // namespace latchwork::planning

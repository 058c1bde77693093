// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/paths/ompl_query.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/ProjectionEvaluator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <bit>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>

#include "latchwork/sdk/random.h"
#include "reasoners/ompl/paths/planner_table.h"

// Debian builds OMPL for any amd64; with wider vectors here, Eigen would align OMPL's objects
// differently on the two sides.
#ifdef __AVX__
#error "build reasoners/ompl without -mavx or -march=native, as OMPL itself was"
#endif

namespace latchwork::planning {
namespace {

namespace ob = ::ompl::base;
namespace og = ::ompl::geometric;

constexpr int kHeadings = 8;         // where any will do
constexpr const char* kRange = "2";  // m, of a tree's step
constexpr double kCellSize = 1.0;    // m
constexpr double kCurveStep = 0.1;   // m between the corners of a Reeds-Shepp path

/// OMPL gives every planner, sampler and tree its seed from one generator of the process.
std::mutex& SeedLock() {
  static std::mutex lock;
  return lock;
}

std::uint32_t SeedOf(const PlannerQuestion& question) {
  const sdk::RandomStream stream(question.settings.seed, "paths");
  const auto bits = [&](Point p, std::uint64_t draw) {
    return stream.Bits(
        std::bit_cast<std::uint64_t>(p.x) ^ std::rotl(std::bit_cast<std::uint64_t>(p.y), 17), draw);
  };
  const std::uint64_t draw = 2 * question.attempt;
  const std::uint64_t mixed = bits(question.from.at, draw) ^ bits(question.to, draw + 1);
  return static_cast<std::uint32_t>(mixed >> 33U) + 1U;
}

Point PlaceOf(const ob::State* state, SpaceKind kind) {
  if (kind == SpaceKind::kPlane) {
    const auto* const plane = state->as<ob::RealVectorStateSpace::StateType>();
    return {(*plane)[0], (*plane)[1]};
  }
  const auto* const pose = state->as<ob::SE2StateSpace::StateType>();
  return {pose->getX(), pose->getY()};
}

/// What KPIECE and its like divide into cells. OMPL's own for a plane stops at an assertion of
/// Eigen's.
class PlaneProjection final : public ob::ProjectionEvaluator {
 public:
  explicit PlaneProjection(const ob::StateSpace* space) : ProjectionEvaluator(space) {}

  unsigned getDimension() const override { return 2; }
  void defaultCellSizes() override { setCellSizes({kCellSize, kCellSize}); }
  void project(const ob::State* state, Eigen::Ref<Eigen::VectorXd> projection) const override {
    const Point place = PlaceOf(state, SpaceKind::kPlane);
    projection[0] = place.x;
    projection[1] = place.y;
  }
};

ob::StateSpacePtr MakeSpace(const PlannerQuestion& question) {
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0.0);
  bounds.setHigh(0, question.space.map().extent_x());
  bounds.setHigh(1, question.space.map().extent_y());
  if (question.settings.space == SpaceKind::kPlane) {
    auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
    plane->setBounds(bounds);
    return plane;
  }
  std::shared_ptr<ob::SE2StateSpace> poses;
  if (question.settings.space == SpaceKind::kReedsShepp) {
    poses = std::make_shared<ob::ReedsSheppStateSpace>(question.settings.turning_radius);
  } else {
    poses = std::make_shared<ob::SE2StateSpace>();
  }
  poses->setBounds(bounds);
  return poses;
}

/// Straight motions are checked as far as they go, without steps that could miss a wall.
class StraightMotions final : public ob::MotionValidator {
 public:
  StraightMotions(const ob::SpaceInformationPtr& space, const PlannerQuestion& question,
                  Effort& effort)
      : MotionValidator(space), question_(&question), effort_(&effort) {}

  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    if (!effort_->Spend()) return false;
    const SpaceKind kind = question_->settings.space;
    return question_->space.IsFree(PlaceOf(a, kind), PlaceOf(b, kind));
  }
  /// The last valid state is found by halving: to a hundredth of a cell of any floor.
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(a, b)) return true;
    const SpaceKind kind = question_->settings.space;
    double free = 0.0;
    double blocked = 1.0;
    for (int i = 0; i < 24; ++i) {
      const double middle = (free + blocked) / 2.0;
      const Point from = PlaceOf(a, kind);
      const bool is_free = question_->space.IsFree(from, Between(from, PlaceOf(b, kind), middle));
      (is_free ? free : blocked) = middle;
    }
    last_valid.second = free;
    if (last_valid.first != nullptr) {
      si_->getStateSpace()->interpolate(a, b, free, last_valid.first);
    }
    return false;
  }

 private:
  const PlannerQuestion* question_;
  Effort* effort_;
};

/// One question to one planner.
class Query {
 public:
  Query(const PlannerQuestion& question, Effort& effort)
      : question_(&question),
        effort_(&effort),
        space_(std::make_shared<ob::SpaceInformation>(MakeSpace(question))),
        problem_(std::make_shared<ob::ProblemDefinition>(space_)),
        stop_([this] {
          return !effort_->Spend() || effort_->limit() != sdk::Limit::kNone ||
                 effort_->spent() >= question_->effort_end;
        }) {
    SetChecks();
    SetEnds();
    const auto length = std::make_shared<ob::PathLengthOptimizationObjective>(space_);
    // Without a threshold optimizing planners never stop of themselves.
    length->setCostThreshold(question.settings.optimize ? ob::Cost(0.0) : length->infiniteCost());
    problem_->setOptimizationObjective(length);
  }

  Path Ask() {
    const ob::PlannerPtr planner = MakePlanner(question_->settings.planner, space_);
    planner->setProblemDefinition(problem_);
    // OMPL's own, a fifth of the floor's diagonal, seldom ends in the room where it begins.
    if (planner->params().hasParam("range")) planner->params().setParam("range", kRange);
    for (const auto& [name, value] : question_->settings.options) {
      planner->params().setParam(name, value);
    }
    planner->setup();
    planner->solve(stop_);
    if (!problem_->hasExactSolution()) return {};
    og::PathGeometric path(*problem_->getSolutionPath()->as<og::PathGeometric>());
    if (question_->settings.simplify) Simplify(path);
    return CornersOf(path);
  }

 private:
  void SetChecks() {
    const SpaceKind kind = question_->settings.space;
    space_->setStateValidityChecker([this, kind](const ob::State* state) {
      return effort_->Spend() && space_->satisfiesBounds(state) &&
             question_->space.IsFree(PlaceOf(state, kind));
    });
    if (kind == SpaceKind::kReedsShepp) {
      // OMPL's default, a hundredth of the floor's diagonal, cuts walls.
      space_->setStateValidityCheckingResolution(question_->space.map().resolution() / 2.0 /
                                                 space_->getMaximumExtent());
    } else {
      space_->setMotionValidator(std::make_shared<StraightMotions>(space_, *question_, *effort_));
    }
    space_->setup();
    if (kind == SpaceKind::kPlane) {
      const ob::StateSpacePtr& plane = space_->getStateSpace();
      plane->registerDefaultProjection(std::make_shared<PlaneProjection>(plane.get()));
    }
  }

  void SetEnds() {
    const auto goals = std::make_shared<ob::GoalStates>(space_);
    const int headings = question_->settings.space == SpaceKind::kPlane ? 1 : kHeadings;
    for (int i = 0; i < headings; ++i) {
      const double heading = 2.0 * std::numbers::pi * i / kHeadings - std::numbers::pi;
      AddStart(question_->from.heading.value_or(heading));
      ob::ScopedState<> state(space_);
      Set(state, question_->to, heading);
      goals->addState(state);
    }
    problem_->setGoal(goals);
  }

  /// Once each.
  void AddStart(double heading) {
    if (question_->from.heading && problem_->getStartStateCount() > 0) return;
    ob::ScopedState<> state(space_);
    Set(state, question_->from.at, heading);
    problem_->addStartState(state);
  }

  void Set(ob::ScopedState<>& state, Point place, double heading) const {
    if (question_->settings.space == SpaceKind::kPlane) {
      state->as<ob::RealVectorStateSpace::StateType>()->values[0] = place.x;
      state->as<ob::RealVectorStateSpace::StateType>()->values[1] = place.y;
      return;
    }
    auto* const pose = state->as<ob::SE2StateSpace::StateType>();
    pose->setXY(place.x, place.y);
    pose->setYaw(heading);
    space_->enforceBounds(state.get());
  }

  void Simplify(og::PathGeometric& path) {
    const og::PathGeometric raw(path);
    og::PathSimplifier simplifier(space_, problem_->getGoal());
    simplifier.simplify(path, stop_);
    if (!path.check()) path = raw;
  }

  Path CornersOf(og::PathGeometric& path) const {
    const SpaceKind kind = question_->settings.space;
    if (kind == SpaceKind::kReedsShepp) {
      path.interpolate(static_cast<unsigned>(std::ceil(path.length() / kCurveStep)) + 2U);
    }
    Path corners;
    for (const ob::State* const state : path.getStates()) corners.push_back(PlaceOf(state, kind));
    return corners;
  }

  const PlannerQuestion* question_;
  Effort* effort_;
  ob::SpaceInformationPtr space_;
  ob::ProblemDefinitionPtr problem_;
  ob::PlannerTerminationCondition stop_;
};

}  // namespace

Path AskPlanner(const PlannerQuestion& question, Effort& effort) {
  const std::lock_guard lock(SeedLock());
  ::ompl::msg::setLogLevel(::ompl::msg::LOG_NONE);
  ::ompl::RNG::setSeed(SeedOf(question));
  return Query(question, effort).Ask();
}

}  // namespace latchwork::planning

#include <algorithm>
#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/world/planners/RobotController.h"

namespace sim2d {
namespace {

constexpr double kHalfAhead = base::kPi / 3.0;  // people within this of the heading count
constexpr double kTurnOnSpot = 1.0;             // [rad]; above it the robot turns before it drives
constexpr double kOffPath = 1.0;                // [m]
constexpr double kBetweenPlans = 1.0;           // [s]

struct PursuitParameters {
  double lookahead = 0.6;     // [m]
  double slowDistance = 1.5;  // [m], gap to whoever is ahead
  double stopDistance = 0.5;  // [m]
};

ParameterTable<PursuitParameters> pursuitTable() {
  ParameterTable<PursuitParameters> table;
  table
      .add(&PursuitParameters::lookahead, "lookahead", "m", base::kPositive,
           "Distance along the path to the point that the robot steers to.", "Coulter 1992")
      .add(&PursuitParameters::slowDistance, "slow_distance", "m", base::kNotNegative,
           "Gap to somebody ahead below which the robot slows down.")
      .add(&PursuitParameters::stopDistance, "stop_distance", "m", base::kNotNegative,
           "Gap to somebody ahead at which the robot stops.");
  return table;
}

/// A* path, pure pursuit (Coulter 1992), slower for people ahead.
class Pursuit : public RobotController {
 public:
  Pursuit(const ResolvedRobot& robot, const PursuitParameters& parameters)
      : parameters_(parameters), robot_(robot) {}

  base::Twist2 command(const Observation& observation) override {
    if (needsPlan(observation)) {
      plan(observation);
    }
    if (path_.empty()) {
      return {};
    }
    const Vec2 target = lookAhead(observation);
    const Vec2 local = observation.pose.toLocal(target);
    const double bearing = base::headingOf(local);
    if (std::fabs(bearing) > kTurnOnSpot) {
      return {0.0, turnRate(bearing)};
    }
    const double distance = std::max(local.norm(), 1e-6);
    const double curvature = 2.0 * base::sin(bearing) / distance;
    double speed = robot_.maxVel * freedom(observation);
    speed = std::min(speed, std::sqrt(1.6 * robot_.maxAcc * restLength(observation.pose.position)));
    speed = std::min(speed, robot_.maxOmega / std::max(std::fabs(curvature), 1e-9));
    return {speed, std::clamp(speed * curvature, -robot_.maxOmega, robot_.maxOmega)};
  }

  std::vector<Vec2> path() const override { return path_; }
  bool takeReplanned() override { return std::exchange(replanned_, false); }

 private:
  bool needsPlan(const Observation& observation) {
    if (version_ != observation.navigation->version() || observation.goal != goal_) {
      return true;
    }
    if (observation.time - plannedAt_ < kBetweenPlans) {
      return false;
    }
    return path_.empty() ||
           (footOf(observation.pose.position).point - observation.pose.position).norm() >
               kOffPath ||
           !observation.obstacles->isVisible(observation.pose.position, lookAhead(observation));
  }

  void plan(const Observation& observation) {
    replanned_ = version_ >= 0 && observation.goal == goal_;
    path_ = observation.navigation->plan(observation.bodyRadius, observation.pose.position,
                                         observation.goal);
    goal_ = observation.goal;
    version_ = observation.navigation->version();
    plannedAt_ = observation.time;
  }

  /// The point of the path nearest to the robot: leg and how far along it.
  struct Foot {
    std::size_t leg = 0;
    Vec2 point = Vec2::Zero();
  };
  Foot footOf(const Vec2& position) const {
    Foot best{0, path_.front()};
    double least = (path_.front() - position).norm();
    for (std::size_t i = 0; i + 1 < path_.size(); ++i) {
      const Vec2 foot = closestOnSegment({path_[i], path_[i + 1]}, position);
      const double distance = (foot - position).norm();
      if (distance <= least) {
        least = distance;
        best = {i, foot};
      }
    }
    return best;
  }

  Vec2 lookAhead(const Observation& observation) const {
    const Foot foot = footOf(observation.pose.position);
    double rest = parameters_.lookahead;
    Vec2 from = foot.point;
    for (std::size_t i = foot.leg + 1; i < path_.size(); ++i) {
      const double length = (path_[i] - from).norm();
      if (length >= rest && length > 0.0) {
        return from + rest / length * (path_[i] - from);
      }
      rest -= length;
      from = path_[i];
    }
    return path_.back();
  }

  double restLength(const Vec2& position) const {
    return lengthOfWay(position, path_, footOf(position).leg + 1);
  }

  /// Fast enough to get round, slow enough to stop there.
  double turnRate(double bearing) const {
    const double rate =
        std::min(robot_.maxOmega, std::sqrt(1.6 * robot_.maxAlpha * std::fabs(bearing)));
    return bearing > 0.0 ? rate : -rate;
  }

  /// Share of the full speed that people ahead leave: 1 beyond the slow distance, 0 inside the stop
  /// distance.
  double freedom(const Observation& observation) const {
    double share = 1.0;
    for (const SeenBody& body : observation.bodies) {
      const double distance = (body.position - observation.pose.position).norm();
      const double gap = distance - body.radius - observation.bodyRadius;
      if (gap < parameters_.slowDistance &&
          isInView(observation.pose, body.position, distance + 1.0, kHalfAhead,
                   *observation.obstacles)) {
        const double width = std::max(parameters_.slowDistance - parameters_.stopDistance, 1e-9);
        share = std::min(share, std::clamp((gap - parameters_.stopDistance) / width, 0.0, 1.0));
      }
    }
    return share;
  }

  PursuitParameters parameters_;
  ResolvedRobot robot_;
  std::vector<Vec2> path_;
  Vec2 goal_ = Vec2::Zero();
  int version_ = -1;  // of the navigation map; -1: never planned
  double plannedAt_ = -1e9;
  bool replanned_ = false;
};

base::Result<std::shared_ptr<RobotController>> makePursuit(const ResolvedRobot& robot) {
  PursuitParameters parameters;
  pursuitTable().set(parameters, robot.plannerParameters);
  if (parameters.lookahead <= 0.0 || parameters.stopDistance < 0.0 ||
      parameters.slowDistance < parameters.stopDistance) {
    return base::within("robot '" + robot.name + "'", base::error("world.bad-pursuit"));
  }
  return std::shared_ptr<RobotController>(std::make_shared<Pursuit>(robot, parameters));
}

}  // namespace

void addPursuit(PlannerRegistry& to);
void addPursuit(PlannerRegistry& to) {
  to.add("pursuit", pursuitTable().specs(), makePursuit);
}

}  // namespace sim2d

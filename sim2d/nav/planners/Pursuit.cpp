#include <algorithm>
#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/base/Ranges.h"
#include "sim2d/nav/Observation.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/RobotRoute.h"

namespace sim2d {
namespace {

constexpr double kAheadHalfAngle = base::kPi / 3.0;  // half angle of the area ahead
constexpr double kPursuitTurnInPlaceAngle = 1.0;     // [rad]; above this the robot turns in place

struct PursuitParameters {
  double lookahead = 0.6;     // [m]
  double slowDistance = 1.5;  // [m], gap to the nearest person ahead
  double stopDistance = 0.5;  // [m]
};

base::ParameterTable<PursuitParameters> pursuitTable() {
  base::ParameterTable<PursuitParameters> table;
  table
      .add(&PursuitParameters::lookahead, "lookahead", "m", base::kLength,
           "Distance along the path to the target point.", "Coulter 1992")
      .add(&PursuitParameters::slowDistance, "slow_distance", "m", base::kDistance,
           "Gap to a person ahead below which the robot slows down.")
      .add(&PursuitParameters::stopDistance, "stop_distance", "m", base::kDistance,
           "Gap to a person ahead at which the robot stops.");
  return table;
}

/// A* path and pure pursuit (Coulter 1992); slows down for people ahead.
class Pursuit : public Planner {
 public:
  Pursuit(const RobotBody& body, const PursuitParameters& parameters)
      : parameters_(parameters),
        limits_(body.limits),
        reach_(circumscribedRadius(body.footprint)),
        turningRadius_(body.kinematics == Kinematics::Ackermann ? body.limits.turningRadius : 0.0) {
  }

  bool readsScan() const override { return false; }
  base::Result<BodyTwist> command(const Observation& observation) override {
    const Vec2& position = observation.pose.position;
    route_.update(observation, reach_, parameters_.lookahead);
    if (route_.isEmpty()) {
      return BodyTwist{};
    }
    const Vec2 local = observation.pose.toLocal(route_.pointAhead(position, parameters_.lookahead));
    const double bearing = base::headingOf(local);
    if (std::fabs(bearing) > kPursuitTurnInPlaceAngle && turningRadius_ == 0.0) {
      return BodyTwist{0.0, turnRate(bearing)};
    }
    const double curvature = curvatureTo(bearing, std::max(local.norm(), 1e-6));
    double speed = limits_.maxVel * allowedSpeedRatio(observation);
    speed = std::min(speed, std::sqrt(1.6 * limits_.maxAcc * route_.remainingLength(position)));
    speed = std::min(speed, limits_.maxOmega / std::max(std::fabs(curvature), 1e-9));
    return BodyTwist{speed, std::clamp(speed * curvature, -limits_.maxOmega, limits_.maxOmega)};
  }

  std::vector<Vec2> path() const override { return route_.points(); }
  bool takeReplanned() override { return route_.takeReplanned(); }

 private:
  /// Curvature of the arc through the point [1/m], limited by the steering; the maximum for points
  /// behind the robot.
  double curvatureTo(double bearing, double distance) const {
    const double curvature = 2.0 * base::sin(bearing) / distance;
    if (turningRadius_ == 0.0) {
      return curvature;
    }
    const double tightest = 1.0 / turningRadius_;
    return std::fabs(bearing) > base::kPi / 2.0 ? std::copysign(tightest, bearing)
                                                : std::clamp(curvature, -tightest, tightest);
  }

  /// Turn rate that allows stopping at the bearing.
  double turnRate(double bearing) const {
    const double rate =
        std::min(limits_.maxOmega, std::sqrt(1.6 * limits_.maxAlpha * std::fabs(bearing)));
    return bearing > 0.0 ? rate : -rate;
  }

  /// Fraction of the full speed allowed by people ahead: 1 beyond the slow distance, 0 within the
  /// stop distance.
  double allowedSpeedRatio(const Observation& observation) const {
    double share = 1.0;
    for (const TrackedBody& body : observation.bodies) {
      const double distance = (body.position - observation.pose.position).norm();
      const double gap = distance - body.radius - reach_;
      if (gap < parameters_.slowDistance &&
          isInView(observation.pose, body.position, distance + 1.0, kAheadHalfAngle,
                   *observation.obstacles)) {
        const double width = std::max(parameters_.slowDistance - parameters_.stopDistance, 1e-9);
        share = std::min(share, std::clamp((gap - parameters_.stopDistance) / width, 0.0, 1.0));
      }
    }
    return share;
  }

  PursuitParameters parameters_;
  DriveLimits limits_;
  double reach_;          // [m]
  double turningRadius_;  // [m]; 0: can turn in place
  RobotRoute route_;
};

base::Result<std::shared_ptr<Planner>> makePursuit(const PlannerSetup& setup) {
  PursuitParameters parameters;
  pursuitTable().set(parameters, setup.parameters);
  if (parameters.lookahead <= 0.0 || parameters.stopDistance < 0.0 ||
      parameters.slowDistance < parameters.stopDistance) {
    return withRobotName(setup.robot, {base::error("world.bad-pursuit")});
  }
  return std::shared_ptr<Planner>(std::make_shared<Pursuit>(setup.body, parameters));
}

}  // namespace

void addPursuit(PlannerRegistry& to);
void addPursuit(PlannerRegistry& to) {
  to.add("pursuit", pursuitTable().specs(), makePursuit,
         "Pure pursuit of the route (Coulter 1992); slows down for people ahead.");
}

}  // namespace sim2d

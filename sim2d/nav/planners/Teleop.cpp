#include "sim2d/nav/Teleop.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/base/Ranges.h"
#include "sim2d/nav/Motion.h"
#include "sim2d/nav/Planner.h"

namespace sim2d {
namespace {

constexpr double kTurnFirst = 1.0;         // [rad]; above it the robot turns before it drives
constexpr double kTeleopTick = 1e-9;       // [s], for sums of steps
constexpr double kTeleopThere = 0.05;      // [m] from the point; nearer it stands
constexpr double kTeleopBrakeShare = 0.8;  // of the way or turn on which it brakes
constexpr double kCircleShare = 1.02;      // of the turning circle: a point inside of it is passed

struct TeleopParameters {
  double speedShare = 1.0;
  double timeout = 0.5;  // [s]
};

base::ParameterTable<TeleopParameters> teleopTable() {
  base::ParameterTable<TeleopParameters> table;
  table
      .add(&TeleopParameters::speedShare, "speed_share", "", {0.0, 1.0, true},
           "Share of its full speed and turn rate that the robot uses at most.")
      .add(&TeleopParameters::timeout, "timeout", "s", base::kTime,
           "So long after the last word the robot stands; 0 = it goes on.");
  return table;
}

/// Drives as it is told: by velocities, which the drive's limits alone cut, or towards a point, by
/// an arc as in pure pursuit (Coulter 1992) and slow enough to stop there. Looks at nobody.
class Teleop : public TeleopPlanner {
 public:
  Teleop(const RobotBody& body, const TeleopParameters& parameters)
      : body_(body), timeout_(parameters.timeout) {
    DriveLimits& limits = body_.limits;
    limits.maxVel *= parameters.speedShare;
    limits.maxReverse *= parameters.speedShare;
    limits.maxOmega *= parameters.speedShare;
  }

  const std::shared_ptr<TeleopInput>& input() const override { return input_; }

  bool readsScan() const override { return false; }
  base::Result<BodyTwist> command(const Observation& observation) override {
    path_.clear();
    const TeleopInput::Wish wish = input_->newest();
    if (wish.number != heardNumber_) {
      heardNumber_ = wish.number;
      heardAt_ = observation.time;
    }
    if (timeout_ > 0.0 && observation.time - heardAt_ > timeout_ + kTeleopTick) {
      return BodyTwist{};
    }
    if (wish.kind == TeleopInput::Kind::Drive) {
      return feasible(body_, wish.twist);
    }
    if (wish.kind == TeleopInput::Kind::HeadFor) {
      path_ = {observation.pose.position, wish.point};
      return feasible(body_, towards(observation.pose.toLocal(wish.point)));
    }
    return BodyTwist{};
  }

  bool needsGoal() const override { return false; }
  std::vector<Vec2> path() const override { return path_; }

 private:
  /// To a point in robot frame.
  BodyTwist towards(const Vec2& point) const {
    const DriveLimits& limits = body_.limits;
    const double distance = point.norm();
    if (distance < kTeleopThere) {
      return {};
    }
    const double bearing = base::headingOf(point);
    const double speed =
        std::min(limits.maxVel, std::sqrt(2.0 * kTeleopBrakeShare * limits.maxAcc * distance));
    if (body_.kinematics == Kinematics::Ackermann) {
      return steered(point, speed);
    }
    if (std::fabs(bearing) > kTurnFirst) {
      const double rate = std::sqrt(2.0 * kTeleopBrakeShare * limits.maxAlpha * std::fabs(bearing));
      return {0.0, std::copysign(std::min(limits.maxOmega, rate), bearing)};
    }
    return onArc(speed, 2.0 * base::sin(bearing) / distance);
  }

  /// A car: at full lock where the point lies behind, and backwards where it lies inside of the
  /// turning circle.
  BodyTwist steered(const Vec2& point, double speed) const {
    const double radius = std::max(body_.limits.turningRadius, 1e-9) * kCircleShare;
    const Vec2 centre(0.0, std::copysign(radius, point.y()));
    if ((point - centre).norm() < body_.limits.turningRadius) {
      return {-std::min(speed, body_.limits.maxReverse), 0.0};
    }
    const double tightest = std::copysign(1.0 / radius, point.y());
    const double curvature = 2.0 * point.y() / point.squaredNorm();
    const bool isBehind = point.x() < 0.0;
    return onArc(speed, isBehind ? tightest : std::clamp(curvature, -1.0 / radius, 1.0 / radius));
  }

  BodyTwist onArc(double speed, double curvature) const {
    const double slowed =
        std::min(speed, body_.limits.maxOmega / std::max(std::fabs(curvature), 1e-9));
    return {slowed, slowed * curvature};
  }

  RobotBody body_;  // with the limits that may be used
  double timeout_;  // [s]
  std::shared_ptr<TeleopInput> input_ = std::make_shared<TeleopInput>();
  std::uint64_t heardNumber_ = 0;
  double heardAt_ = 0.0;  // [s]
  std::vector<Vec2> path_;
};

base::Result<std::shared_ptr<Planner>> makeTeleop(const PlannerSetup& setup,
                                                  TeleopParameters parameters) {
  teleopTable().set(parameters, setup.parameters);
  return std::shared_ptr<Planner>(std::make_shared<Teleop>(setup.body, parameters));
}

}  // namespace

void addTeleop(PlannerRegistry& to);
void addTeleop(PlannerRegistry& to) {
  to.add(
      "teleop", teleopTable().specs(),
      [](const PlannerSetup& setup) { return makeTeleop(setup, {}); },
      "Stands until somebody drives it by hand. Looks at nobody.");
  TeleopParameters ofRos2;
  ofRos2.timeout = 1.0;  // as a driver of Nav2 waits for /cmd_vel
  to.add(
      "ros2", teleopTable().specs(ofRos2),
      [ofRos2](const PlannerSetup& setup) { return makeTeleop(setup, ofRos2); },
      "Driven by /cmd_vel of ROS 2, with run --ros2; else it stands.");
}

}  // namespace sim2d

#include "sim2d/nav/Teleop.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/base/Ranges.h"
#include "sim2d/nav/DriveKinematics.h"
#include "sim2d/nav/Planner.h"

namespace sim2d {
namespace {

constexpr double kTurnInPlaceAngle = 1.0;     // [rad]; above this the robot turns in place
constexpr double kTeleopTimeRounding = 1e-9;  // [s], rounding of accumulated steps
constexpr double kArrivalDistance = 0.05;  // [m]; within this distance of the point it stands still
constexpr double kBrakingFraction = 0.8;   // fraction of the maximum deceleration used
constexpr double kTurningRadiusFactor = 1.02;  // factor on the turning radius

struct TeleopParameters {
  double speedShare = 1.0;
  double timeout = 0.5;  // [s]
};

base::ParameterTable<TeleopParameters> teleopTable() {
  base::ParameterTable<TeleopParameters> table;
  table
      .add(&TeleopParameters::speedShare, "speed_share", "", {0.0, 1.0, true},
           "Share of the maximum speed and turn rate that the robot uses at most.")
      .add(&TeleopParameters::timeout, "timeout", "s", base::kTime,
           "Time after the last command after which the robot stops; 0: it continues.");
  return table;
}

/// Follows external commands: velocities, limited by the drive only, or a target point, approached
/// on an arc as in pure pursuit (Coulter 1992) and slow enough to stop there. Ignores people.
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
    const TeleopInput::Command wish = input_->latest();
    if (wish.number != lastNumber_) {
      lastNumber_ = wish.number;
      lastCommandTime_ = observation.time;
    }
    if (timeout_ > 0.0 && observation.time - lastCommandTime_ > timeout_ + kTeleopTimeRounding) {
      return BodyTwist{};
    }
    if (wish.kind == TeleopInput::Kind::Drive) {
      return clampedToLimits(body_, wish.twist);
    }
    if (wish.kind == TeleopInput::Kind::DriveTo) {
      path_ = {observation.pose.position, wish.point};
      return clampedToLimits(body_, towards(observation.pose.toLocal(wish.point)));
    }
    return BodyTwist{};
  }

  bool needsGoal() const override { return false; }
  std::vector<Vec2> path() const override { return path_; }

 private:
  /// Command towards a point in robot frame.
  BodyTwist towards(const Vec2& point) const {
    const DriveLimits& limits = body_.limits;
    const double distance = point.norm();
    if (distance < kArrivalDistance) {
      return {};
    }
    const double bearing = base::headingOf(point);
    const double speed =
        std::min(limits.maxVel, std::sqrt(2.0 * kBrakingFraction * limits.maxAcc * distance));
    if (body_.kinematics == Kinematics::Ackermann) {
      return carCommand(point, speed);
    }
    if (std::fabs(bearing) > kTurnInPlaceAngle) {
      const double rate = std::sqrt(2.0 * kBrakingFraction * limits.maxAlpha * std::fabs(bearing));
      return {0.0, std::copysign(std::min(limits.maxOmega, rate), bearing)};
    }
    return onArc(speed, 2.0 * base::sin(bearing) / distance);
  }

  /// Command of a car: full lock if the point lies behind, backward if it lies inside the turning
  /// circle.
  BodyTwist carCommand(const Vec2& point, double speed) const {
    const double radius = std::max(body_.limits.turningRadius, 1e-9) * kTurningRadiusFactor;
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

  RobotBody body_;  // with the limits to be used
  double timeout_;  // [s]
  std::shared_ptr<TeleopInput> input_ = std::make_shared<TeleopInput>();
  std::uint64_t lastNumber_ = 0;
  double lastCommandTime_ = 0.0;  // [s]
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
      "Manual drive: stands still until the user drives it. Ignores people.");
  TeleopParameters ros2Parameters;
  ros2Parameters.timeout = 1.0;  // same timeout as Nav2 drivers of /cmd_vel
  to.add(
      "ros2", teleopTable().specs(ros2Parameters),
      [ros2Parameters](const PlannerSetup& setup) { return makeTeleop(setup, ros2Parameters); },
      "Driven by the ROS 2 topic /cmd_vel with run --ros2; otherwise it stands still.");
}

void TeleopInput::post(Command wish) {
  const std::lock_guard<std::mutex> lock(mutex_);
  wish.number = command_.number + 1;
  command_ = wish;
}

void TeleopInput::drive(const BodyTwist& twist) {
  Command wish;
  wish.kind = Kind::Drive;
  wish.twist = twist;
  post(wish);
}

void TeleopInput::driveTo(const Vec2& point) {
  Command wish;
  wish.kind = Kind::DriveTo;
  wish.point = point;
  post(wish);
}

void TeleopInput::release() {
  post({});
}

TeleopInput::Command TeleopInput::latest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return command_;
}

}  // namespace sim2d

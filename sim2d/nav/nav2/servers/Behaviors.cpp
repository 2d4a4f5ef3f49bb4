#include "sim2d/nav/nav2/servers/Behaviors.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/nav/Observation.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

namespace sim2d::nav2 {
namespace {

constexpr double kBehaviorClock = 1e-9;  // [s], rounding of times
constexpr double kTurnReached = 1e-6;    // [rad]

BehaviorStep behaviorRuns(const BodyTwist& twist) {
  BehaviorStep step;
  step.twist = twist;
  return step;
}
BehaviorStep behaviorSucceeded() {
  BehaviorStep step;
  step.status = BehaviorStatus::Succeeded;
  return step;
}
BehaviorStep behaviorFailed(BehaviorError error, std::string words) {
  BehaviorStep step;
  step.status = BehaviorStatus::Failed;
  step.error = error;
  step.words = std::move(words);
  return step;
}

bool isAllowanceOver(double time, double start, double allowance) {
  return allowance > 0.0 && time - start > allowance + kBehaviorClock;
}

int simulationCycles(const BehaviorParameters& parameters) {
  constexpr double kMax = 10000.0;  // cycles of a simulation
  return static_cast<int>(
      std::clamp(parameters.cycleFrequency * parameters.simulateAheadTime, 0.0, kMax));
}

}  // namespace

DriveParameters driveDefaults(Distro distro) {
  return distro >= Distro::Kilted ? DriveParameters{2.5, -2.5, 0.10} : DriveParameters{};
}

const std::vector<Nav2Key<BehaviorParameters>>& behaviorKeys() {
  using P = BehaviorParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"cycle_frequency", &P::cycleFrequency, "Hz", "Cycles of a behaviour per second."},
      {"behavior_plugins", &P::behaviorPlugins, "", "Names of the behaviours."},
      {"simulate_ahead_time", &P::simulateAheadTime, "s",
       "Time for which behaviours are simulated ahead."},
      {"max_rotational_vel", &P::maxRotationalVel, "rad/s", "Spin: maximum turn rate."},
      {"min_rotational_vel", &P::minRotationalVel, "rad/s", "Spin: minimum turn rate."},
      {"rotational_acc_lim", &P::rotationalAccLim, "rad/s²",
       "Spin: angular deceleration before the end."},
      {"projection_time", &P::projectionTime, "s",
       "Assisted teleop: time that is simulated ahead."},
      {"simulation_time_step", &P::simulationTimeStep, "s",
       "Assisted teleop: time step of that simulation."},
  };
  return kKeys;
}

const std::vector<Nav2Key<DriveParameters>>& driveKeys() {
  using P = DriveParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"acceleration_limit", &P::accelerationLimit, "m/s²", "Acceleration; 0: unlimited.",
       kHumble | kSinceKilted},
      {"deceleration_limit", &P::decelerationLimit, "m/s²",
       "Deceleration, at most 0; 0: unlimited.", kHumble | kSinceKilted},
      {"minimum_speed", &P::minimumSpeed, "m/s", "Minimum speed.", kHumble | kSinceKilted},
  };
  return kKeys;
}

base::Diagnostics problemsOf(const BehaviorParameters& parameters) {
  constexpr double kMaxFrequency = 1000.0, kMaxLookahead = 100.0;
  base::Diagnostics problems;
  ParameterChecks checks(problems);
  checks.require("cycle_frequency", parameters.cycleFrequency,
                 {{0.0, kMaxFrequency, true}, "above 0, up to 1000 Hz"});
  checks.require("simulate_ahead_time", parameters.simulateAheadTime,
                 {{0.0, kMaxLookahead}, "0 to 100 s"});
  return problems;
}

base::Diagnostics problemsOf(const DriveParameters& parameters, const std::string& name) {
  base::Diagnostics problems;
  ParameterChecks checks(problems, name + ".");
  checks.require(parameters.accelerationLimit >= 0.0, "acceleration_limit", "0 or more");
  checks.require(parameters.decelerationLimit <= 0.0, "deceleration_limit", "0 or less");
  return problems;
}

const std::vector<IgnoredKey>& ignoredBehaviorKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"local_costmap_topic", "behaviours read the published local costmap", kSinceJazzy},
      {"global_costmap_topic", "behaviours read the published local costmap", kSinceJazzy},
      {"costmap_topic", "behaviours read the published local costmap", kHumble},
      {"local_footprint_topic", "the footprint is that of the costmap", kSinceJazzy},
      {"global_footprint_topic", "the footprint is that of the costmap", kSinceJazzy},
      {"footprint_topic", "the footprint is that of the costmap", kHumble},
      {"local_frame", "behaviours use the frame of the local costmap", kSinceJazzy},
      {"global_frame", "behaviours use the frame of the local costmap"},
      {"robot_base_frame", "all base frames of a robot are identical"},
      {"transform_tolerance", "TF is not used"},
      {"cmd_vel_teleop", "ROS topics are not used"},
      {"enable_stamped_cmd_vel", "ROS topics are not used"},
      {"use_sim_time", "time is always simulated"},
      {"introspection_mode", "ROS services are not used"},
  };
  return kKeys;
}

std::uint16_t behaviorCode(BehaviorKind kind, BehaviorError error) {
  const int action = 700 + 10 * static_cast<int>(kind);
  const bool isBackUp = kind == BehaviorKind::BackUp;  // BackUp swaps the last two codes
  switch (error) {
    case BehaviorError::None:
      return 0;
    case BehaviorError::Timeout:
      return static_cast<std::uint16_t>(action + 1);
    case BehaviorError::CollisionAhead:
      return static_cast<std::uint16_t>(action + (isBackUp ? 4 : 3));
    case BehaviorError::InvalidInput:
      return static_cast<std::uint16_t>(action + (isBackUp ? 3 : 4));
  }
  return static_cast<std::uint16_t>(action);
}

bool isBehaviorBlocked(const BehaviorInput& input, const Pose2& pose) {
  return !input.costmap.worldToCell(pose.position) ||
         footprintCost(input.costmap, input.footprint, pose) >= kLethal;
}

Spin::Spin(const BehaviorParameters& parameters, const Goal& goal, double time, const Pose2& pose)
    : parameters_(parameters), goal_(goal), start_(time), heading_(pose.heading) {}

BehaviorStep Spin::cycle(const BehaviorInput& input) {
  if (isAllowanceOver(input.time, start_, goal_.timeAllowance)) {
    return behaviorFailed(BehaviorError::Timeout,
                          "Exceeded time allowance before reaching the Spin goal - Exiting Spin");
  }
  double turn = input.pose.heading - heading_;
  if (std::fabs(turn) > base::kPi) {
    turn = std::copysign(2.0 * base::kPi - std::fabs(turn), heading_);
  }
  turned_ += turn;
  heading_ = input.pose.heading;
  const double left = std::fabs(goal_.angle) - std::fabs(turned_);
  if (left < kTurnReached) {
    return behaviorSucceeded();
  }
  const double fastest = std::sqrt(2.0 * parameters_.rotationalAccLim * left);
  const double speed =
      std::min(std::max(fastest, parameters_.minRotationalVel), parameters_.maxRotationalVel);
  BodyTwist twist;
  twist.angular = std::copysign(speed, goal_.angle);
  if (input.isCollisionChecked && !isFree(input, twist.angular)) {
    return behaviorFailed(BehaviorError::CollisionAhead, "Collision Ahead - Exiting Spin");
  }
  return behaviorRuns(twist);
}

/// As in Nav2 the simulation is limited to the angle turned so far.
bool Spin::isFree(const BehaviorInput& input, double omega) const {
  for (int i = 0; i < simulationCycles(parameters_); ++i) {
    const double ahead = omega * (i / parameters_.cycleFrequency);
    if (std::fabs(turned_) - std::fabs(ahead) <= 0.0) {
      break;
    }
    if (isBehaviorBlocked(input, {input.pose.position, input.pose.heading + ahead})) {
      return false;
    }
  }
  return true;
}

DriveStraight::Goal DriveStraight::backUp(const Goal& goal) {
  return {-std::fabs(goal.distance), -std::fabs(goal.speed), goal.timeAllowance};
}

DriveStraight::DriveStraight(const BehaviorParameters& parameters, const DriveParameters& drive,
                             const Goal& goal, double time, const Pose2& pose)
    : parameters_(parameters), drive_(drive), goal_(goal), start_(time), from_(pose.position) {}

BehaviorStep DriveStraight::cycle(const BehaviorInput& input) {
  if ((goal_.distance > 0.0) != (goal_.speed > 0.0)) {
    return behaviorFailed(BehaviorError::InvalidInput, "Speed and command sign did not match");
  }
  if (isAllowanceOver(input.time, start_, goal_.timeAllowance)) {
    return behaviorFailed(
        BehaviorError::Timeout,
        "Exceeded time allowance before reaching the DriveOnHeading goal - Exiting "
        "DriveOnHeading");
  }
  driven_ = (input.pose.position - from_).norm();
  const double left = std::fabs(goal_.distance) - driven_;
  if (left <= 0.0) {
    return behaviorSucceeded();
  }
  BodyTwist twist;
  twist.linear = speedFor(left);
  if (input.isCollisionChecked && !isFree(input, twist.linear, left)) {
    return behaviorFailed(BehaviorError::CollisionAhead,
                          "Collision Ahead - Exiting DriveOnHeading");
  }
  speed_ = twist.linear;
  return behaviorRuns(twist);
}

double DriveStraight::speedFor(double left) const {
  const double sign = goal_.speed > 0.0 ? 1.0 : -1.0;
  double speed = std::fabs(goal_.speed);
  if (drive_.accelerationLimit != 0.0 && drive_.decelerationLimit != 0.0) {
    const double last = std::fabs(speed_);
    speed = std::clamp(speed, last + drive_.decelerationLimit / parameters_.cycleFrequency,
                       last + drive_.accelerationLimit / parameters_.cycleFrequency);
    speed = std::min(speed, std::sqrt(-2.0 * drive_.decelerationLimit * left));
  }
  return sign * std::max(speed, drive_.minimumSpeed);
}

bool DriveStraight::isFree(const BehaviorInput& input, double speed, double left) const {
  for (int i = 0; i < simulationCycles(parameters_); ++i) {
    const double ahead = speed * (i / parameters_.cycleFrequency);
    if (left - std::fabs(ahead) <= 0.0) {
      break;
    }
    if (isBehaviorBlocked(input, {input.pose.ahead(ahead), input.pose.heading})) {
      return false;
    }
  }
  return true;
}

BehaviorStep Wait::cycle(const BehaviorInput& input) const {
  BehaviorStep step = input.time < end_ - kBehaviorClock ? behaviorRuns({}) : behaviorSucceeded();
  step.hasTwist = step.status != BehaviorStatus::Running;
  return step;
}

BehaviorStep AssistedTeleop::cycle(const BehaviorInput& input,
                                   const BodyTwist& teleopCommand) const {
  if (isAllowanceOver(input.time, start_, timeAllowance_)) {
    return behaviorFailed(
        BehaviorError::Timeout,
        "Exceeded time allowance before reaching the AssistedTeleop goal - Exiting "
        "AssistedTeleop");
  }
  const double step = parameters_.simulationTimeStep;
  Pose2 pose = input.pose;
  for (int i = 1; i * step < parameters_.projectionTime - kBehaviorClock; ++i) {
    const Vec2 ahead = pose.direction();
    pose.position +=
        step * (teleopCommand.linear * ahead + teleopCommand.lateral * Vec2(-ahead.y(), ahead.x()));
    pose.heading += step * teleopCommand.angular;
    if (isBehaviorBlocked(input, pose)) {
      const double factor = i == 1 ? 0.0 : i * step / parameters_.projectionTime;
      return behaviorRuns({factor * teleopCommand.linear, factor * teleopCommand.angular,
                           factor * teleopCommand.lateral});
    }
  }
  return behaviorRuns(teleopCommand);
}

void BehaviorServer::start(const Behavior& behavior, BehaviorKind kind, double time) {
  behavior_.emplace(behavior);
  kind_ = kind;
  start_ = time;
  lastCycle_ = -1;
  code_ = 0;
}

void BehaviorServer::spin(const Spin::Goal& goal, double time, const Pose2& pose) {
  start(Spin(parameters_, goal, time, pose), BehaviorKind::Spin, time);
}

void BehaviorServer::backUp(const DriveStraight::Goal& goal, double time, const Pose2& pose) {
  start(DriveStraight(parameters_, backUp_, DriveStraight::backUp(goal), time, pose),
        BehaviorKind::BackUp, time);
}

void BehaviorServer::driveOnHeading(const DriveStraight::Goal& goal, double time,
                                    const Pose2& pose) {
  start(DriveStraight(parameters_, driveOnHeading_, goal, time, pose), BehaviorKind::DriveOnHeading,
        time);
}

void BehaviorServer::wait(double duration, double time) {
  start(Wait(duration, time), BehaviorKind::Wait, time);
}

void BehaviorServer::assistedTeleop(double timeAllowance, double time) {
  start(AssistedTeleop(parameters_, timeAllowance, time), BehaviorKind::AssistedTeleop, time);
}

std::optional<BehaviorStep> BehaviorServer::update(const BehaviorInput& input,
                                                   const BodyTwist& teleopCommand) {
  if (!behavior_) {
    return std::nullopt;
  }
  const std::int64_t cycle = eventIndexAt(input.time - start_, parameters_.cycleFrequency);
  if (cycle <= lastCycle_) {
    return std::nullopt;
  }
  lastCycle_ = cycle;
  const BehaviorStep step = std::visit(
      [&input, &teleopCommand](auto& behavior) {
        if constexpr (std::is_same_v<std::decay_t<decltype(behavior)>, AssistedTeleop>) {
          return behavior.cycle(input, teleopCommand);
        } else {
          return behavior.cycle(input);
        }
      },
      *behavior_);
  if (step.status != BehaviorStatus::Running) {
    behavior_.reset();
    code_ = behaviorCode(kind_, step.error);
  }
  return step;
}

}  // namespace sim2d::nav2

#include "sim2d/nav/nav2/servers/Behaviors.h"

#include <algorithm>
#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/nav/Observation.h"

namespace sim2d::nav2 {
namespace {

constexpr double kBehaviorClock = 1e-9;  // [s], rounding of times
constexpr double kTurnReached = 1e-6;    // [rad]

BehaviorStep behaviorRuns(const BodyTwist& twist) {
  return {BehaviorStatus::Running, true, twist, BehaviorError::None, {}};
}
BehaviorStep behaviorSucceeded() {
  return {BehaviorStatus::Succeeded, true, {}, BehaviorError::None, {}};
}
BehaviorStep behaviorFailed(BehaviorError error, const char* words) {
  return {BehaviorStatus::Failed, true, {}, error, words};
}

bool isAllowanceOver(double time, double start, double allowance) {
  return allowance > 0.0 && time - start > allowance + kBehaviorClock;
}

/// Whether the footprint is free at the poses of the next cycles, up to `left` at `speed` (lengths
/// or angles); `poseAfter(distance)`.
template <class PoseAfter>
bool isMotionFree(const BehaviorParameters& parameters, const BehaviorInput& input, double speed,
                  double left, const PoseAfter& poseAfter) {
  constexpr double kMax = 10000.0;  // cycles of a simulation
  const int cycles = static_cast<int>(
      std::clamp(parameters.cycleFrequency * parameters.simulateAheadTime, 0.0, kMax));
  for (int i = 0; i < cycles; ++i) {
    const double ahead = speed * (i / parameters.cycleFrequency);
    if (left - std::fabs(ahead) <= 0.0) {
      break;
    }
    if (isBehaviorBlocked(input, poseAfter(ahead))) {
      return false;
    }
  }
  return true;
}

}  // namespace

DriveParameters driveDefaults(Distro distro) {
  return distro >= Distro::Kilted ? DriveParameters{2.5, -2.5, 0.10} : DriveParameters{};
}

Nav2Keys<BehaviorParameters> behaviorKeys() {
  using P = BehaviorParameters;
  return {
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
}

Nav2Keys<DriveParameters> driveKeys() {
  using P = DriveParameters;
  return onlyIn<Nav2Key<P>>(
      kHumble | kSinceKilted,
      {
          {"acceleration_limit", &P::accelerationLimit, "m/s²", "Acceleration; 0: unlimited."},
          {"deceleration_limit", &P::decelerationLimit, "m/s²",
           "Deceleration, at most 0; 0: unlimited."},
          {"minimum_speed", &P::minimumSpeed, "m/s", "Minimum speed."},
      });
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

IgnoredKeys ignoredBehaviorKeys() {
  return {
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
  };
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
  // As in Nav2 the simulation is limited to the angle turned so far.
  const auto poseAfter = [&input](double angle) -> Pose2 {
    return {input.pose.position, input.pose.heading + angle};
  };
  if (input.isCollisionChecked &&
      !isMotionFree(parameters_, input, twist.angular, std::fabs(turned_), poseAfter)) {
    return behaviorFailed(BehaviorError::CollisionAhead, "Collision Ahead - Exiting Spin");
  }
  return behaviorRuns(twist);
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
  const auto poseAfter = [&input](double distance) -> Pose2 {
    return {input.pose.ahead(distance), input.pose.heading};
  };
  if (input.isCollisionChecked &&
      !isMotionFree(parameters_, input, twist.linear, left, poseAfter)) {
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

BehaviorStep Wait::cycle(const BehaviorInput& input) const {
  BehaviorStep step = input.time < end_ - kBehaviorClock ? behaviorRuns({}) : behaviorSucceeded();
  step.hasTwist = step.status != BehaviorStatus::Running;
  return step;
}

BehaviorStep AssistedTeleop::cycle(const BehaviorInput& input) const {
  if (isAllowanceOver(input.time, start_, timeAllowance_)) {
    return behaviorFailed(
        BehaviorError::Timeout,
        "Exceeded time allowance before reaching the AssistedTeleop goal - Exiting "
        "AssistedTeleop");
  }
  const double step = parameters_.simulationTimeStep;
  const BodyTwist& command = input.teleop;
  Pose2 pose = input.pose;
  for (int i = 1; i * step < parameters_.projectionTime - kBehaviorClock; ++i) {
    const Vec2 ahead = pose.direction();
    pose.position +=
        step * (command.linear * ahead + command.lateral * Vec2(-ahead.y(), ahead.x()));
    pose.heading += step * command.angular;
    if (isBehaviorBlocked(input, pose)) {
      const double factor = i == 1 ? 0.0 : i * step / parameters_.projectionTime;
      return behaviorRuns(
          {factor * command.linear, factor * command.angular, factor * command.lateral});
    }
  }
  return behaviorRuns(command);
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

std::optional<BehaviorStep> BehaviorServer::update(const BehaviorInput& input) {
  if (!behavior_) {
    return std::nullopt;
  }
  const std::int64_t cycle = eventIndexAt(input.time - start_, parameters_.cycleFrequency);
  if (cycle <= lastCycle_) {
    return std::nullopt;
  }
  lastCycle_ = cycle;
  const BehaviorStep step =
      std::visit([&input](auto& behavior) { return behavior.cycle(input); }, *behavior_);
  if (step.status != BehaviorStatus::Running) {
    behavior_.reset();
    code_ = behaviorCode(kind_, step.error);
  }
  return step;
}

Nav2Keys<WaypointFollowerParameters> waypointFollowerKeys() {
  using P = WaypointFollowerParameters;
  return {{"waypoint_task_executor_plugin", &P::taskPlugin, "", "Name of the task at each goal."}};
}

IgnoredKeys ignoredWaypointFollowerKeys() {
  return {{"global_frame_id", "the frames are identical", kSinceJazzy},
          {"loop_rate", "goals are checked in every time step"},
          {"stop_on_failure", "a robot stops when its tree has failed"}};
}

Nav2Keys<WaypointTaskParameters> waypointTaskKeys(WaypointTask task) {
  using P = WaypointTaskParameters;
  Nav2Keys<P> keys = {{"enabled", &P::enabled, "", "Whether the task is executed."}};
  if (task == WaypointTask::Wait) {
    keys.push_back({"waypoint_pause_duration", &P::pauseDuration, "ms",
                    "Time for which the robot waits at the goal."});
  } else if (task != WaypointTask::Photo) {
    keys.push_back({"timeout", &P::inputTimeout, "s", "Maximum wait for an input."});
  }
  return keys;
}

IgnoredKeys ignoredWaypointTaskKeys() {
  return {{"image_topic", "a photo is an event of the run"},
          {"save_dir", "a photo is an event of the run"},
          {"image_format", "a photo is an event of the run"},
          {"input_topic", "ROS topics are not used: no input is received"}};
}

double waypointTaskDuration(const WaypointTaskParameters& task) {
  constexpr double kMillisecond = 1e-3;  // [s]
  if (!task.enabled) {
    return 0.0;
  }
  switch (task.kind) {
    case WaypointTask::Wait:
      return kMillisecond * task.pauseDuration;
    case WaypointTask::Input:
      return task.inputTimeout;
    default:
      return 0.0;
  }
}

}  // namespace sim2d::nav2

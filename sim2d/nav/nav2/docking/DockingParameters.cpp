#include "sim2d/nav/nav2/docking/DockingParameters.h"

#include <limits>

namespace sim2d::nav2 {
namespace {

template <class P>
Nav2Keys<P> controllerKeys() {
  return {
      {"controller.k_phi", &P::kPhi, "", "Control law: ratio of the slow and fast subsystems."},
      {"controller.k_delta", &P::kDelta, "1/m", "Control law: gain of the heading."},
      {"controller.beta", &P::beta, "", "Control law: amount of slowdown in curves."},
      {"controller.lambda", &P::lambda, "", "Control law: sharpness of that slowdown."},
      {"controller.v_linear_min", &P::minLinear, "m/s", "Minimum speed."},
      {"controller.v_linear_max", &P::maxLinear, "m/s", "Maximum speed."},
      {"controller.v_angular_max", &P::maxAngular, "rad/s", "Maximum turn rate."},
      {"controller.slowdown_radius", &P::slowdownRadius, "m",
       "Distance to the target below which the robot slows down."},
      {"controller.deceleration_max", &P::maxDeceleration, "m/s²",
       "Deceleration with which the robot can stop at the target.", kSinceLyrical},
      {"controller.rotate_to_heading_angular_vel", &P::rotationSpeed, "rad/s",
       "Turn rate of rotation in place."},
      {"controller.rotate_to_heading_max_angular_accel", &P::rotationAcceleration, "rad/s²",
       "Angular acceleration of rotation in place."},
      {"controller.use_collision_detection", &P::usesCollisionDetection, "",
       "Whether commands that lead into obstacles are rejected."},
      {"controller.projection_time", &P::projectionTime, "s",
       "Time for which commands are simulated to detect collisions."},
      {"controller.simulation_time_step", &P::simulationTimeStep, "s",
       "Time step of that simulation."},
      {"controller.dock_collision_threshold", &P::dockCollisionThreshold, "m",
       "Distance to the dock within which collisions are ignored."},
  };
}

IgnoredKeys ignoredControllerKeys() {
  return {{"controller.costmap_topic", "the local costmap is used"},
          {"controller.footprint_topic", "the footprint of the local costmap is used"},
          {"controller.transform_tolerance", "TF is not used"},
          {"base_frame", "the frames are identical"},
          {"fixed_frame", "the frames are identical"},
          {"odom_topic", "ROS topics are not used", kSinceKilted},
          {"odom_duration", "speeds are those of the odometry", kSinceLyrical}};
}

// The following server exists since Lyrical; some of its keys were ported back to Jazzy.
constexpr unsigned kFollowingDistros = kJazzy | kSinceLyrical;

constexpr double kUnlimited = std::numeric_limits<double>::max();
constexpr NumberRange kAboveZero{{0.0, kUnlimited, true}, "above 0"};
constexpr NumberRange kZeroOrMore{{0.0, kUnlimited}, "0 or more"};
constexpr NumberRange kShare{{0.0, 1.0}, "0 to 1"};
constexpr NumberRange kCommandRate{{0.0, 1000.0, true}, "above 0, up to 1000 Hz"};

void checkController(const DockControllerParameters& parameters, ParameterChecks& checks) {
  checks.require("controller.slowdown_radius", parameters.slowdownRadius, kAboveZero);
  checks.require("controller.v_linear_max", parameters.maxLinear, kAboveZero);
  checks.require("controller.v_linear_min", parameters.minLinear, kZeroOrMore);
  checks.require("controller.v_angular_max", parameters.maxAngular, kAboveZero);
  checks.require("controller.deceleration_max", parameters.maxDeceleration, kAboveZero);
  checks.require("controller.projection_time", parameters.projectionTime,
                 {{0.0, 100.0}, "0 to 100 s"});
  checks.require("controller.simulation_time_step", parameters.simulationTimeStep,
                 {{0.01, 100.0}, "0.01 to 100 s"});
  checks.require("controller.rotate_to_heading_max_angular_accel", parameters.rotationAcceleration,
                 kAboveZero);
}

}  // namespace

Nav2Keys<DockingServerParameters> dockingServerKeys() {
  using P = DockingServerParameters;
  const Nav2Keys<P> own = {
      {"controller_frequency", &P::controllerFrequency, "Hz", "Rate of commands."},
      {"initial_perception_timeout", &P::initialPerceptionTimeout, "s",
       "Maximum time to detect the dock before the approach."},
      {"wait_charge_timeout", &P::waitChargeTimeout, "s", "Maximum wait for charging to begin."},
      {"dock_approach_timeout", &P::dockApproachTimeout, "s", "Maximum duration of the approach."},
      {"rotate_to_dock_timeout", &P::rotateToDockTimeout, "s",
       "Maximum duration of the rotation to the dock.", kSinceKilted},
      {"undock_linear_tolerance", &P::undockLinearTolerance, "m",
       "Distance to the staging pose within which the robot has undocked."},
      {"undock_angular_tolerance", &P::undockAngularTolerance, "rad",
       "Maximum heading difference to the staging pose."},
      {"rotation_angular_tolerance", &P::rotationAngularTolerance, "rad",
       "Angle within which the rotation to the dock ends.", kSinceKilted},
      {"dock_prestaging_tolerance", &P::dockPrestagingTolerance, "m",
       "Distance to the staging pose within which the robot does not drive there first."},
      {"max_retries", &P::maxRetries, "", "Maximum number of repetitions of a failed approach."},
      {"dock_backwards", &P::dockBackwards, "", "Whether the robot docks backwards.",
       kJazzy | kKilted},
      {"dock_plugins", &P::dockPlugins, "", "Names of the dock plugins."},
      {"docks", &P::docks, "", "Names of the docks."},
      {"dock_database", &P::dockDatabase, "", "File with docks that replaces the key docks."},
  };
  return onlyIn(kSinceJazzy, joinedKeys<P>(own, controllerKeys<P>()));
}

IgnoredKeys ignoredDockingServerKeys() {
  IgnoredKeys keys = ignoredControllerKeys();
  keys.push_back({"navigator_bt_xml", "planner and controller of the file drive to the dock"});
  return onlyIn(kSinceJazzy, keys);
}

Nav2Keys<DockPluginParameters> nonChargingDockKeys() {
  using P = DockPluginParameters;
  return onlyIn<Nav2Key<P>>(
      kSinceJazzy,
      {{"staging_x_offset", &P::stagingXOffset, "m",
        "Distance of the staging pose in front of the dock."},
       {"staging_yaw_offset", &P::stagingYawOffset, "rad",
        "Heading of the staging pose relative to the dock."},
       {"docking_threshold", &P::dockingThreshold, "m",
        "Distance to the dock's pose within which the robot is docked."},
       {"use_external_detection_pose", &P::usesDetection, "",
        "Whether the robot approaches the detected pose of the dock."},
       {"external_detection_timeout", &P::detectionTimeout, "s", "Older detections are ignored."},
       {"filter_coef", &P::filterCoef, "", "Weight of a new detection."},
       {"dock_direction", &P::direction, "", "forward or backward.", kSinceKilted},
       {"rotate_to_dock", &P::rotatesToDock, "",
        "Whether the robot turns around at the staging pose to dock backwards.", kSinceKilted}});
}

Nav2Keys<DockPluginParameters> dockPluginKeys() {
  using P = DockPluginParameters;
  const Nav2Keys<P> own = {
      {"charging_threshold", &P::chargingThreshold, "A",
       "Current above which the robot is charging."},
      {"use_battery_status", &P::usesBatteryStatus, "",
       "Whether the battery state determines that the robot is charging; else it is "
       "charging when docked."},
  };
  return joinedKeys<P>(onlyIn(kSinceJazzy, own), nonChargingDockKeys());
}

IgnoredKeys ignoredDockPluginKeys() {
  static constexpr const char* kDetection = "a detection is the pose of the dock itself";
  static constexpr const char* kStall = "docks do not block robots: docking_threshold is used";
  return onlyIn<IgnoredKey>(
      kSinceJazzy, {{"external_detection_translation_x", kDetection},
                    {"external_detection_translation_y", kDetection},
                    {"external_detection_rotation_roll", kDetection},
                    {"external_detection_rotation_pitch", kDetection},
                    {"external_detection_rotation_yaw", kDetection},
                    {"use_stall_detection", kStall},
                    {"stall_joint_names", kStall},
                    {"stall_velocity_threshold", kStall},
                    {"stall_effort_threshold", kStall},
                    {"detector_service_name", "ROS services are not used", kSinceLyrical},
                    {"detector_service_timeout", "ROS services are not used", kSinceLyrical},
                    {"subscribe_toggle", "ROS topics are not used", kSinceLyrical}});
}

Nav2Keys<FollowingServerParameters> followingServerKeys() {
  using P = FollowingServerParameters;
  const Nav2Keys<P> own = {
      {"controller_frequency", &P::controllerFrequency, "Hz", "Rate of commands."},
      {"desired_distance", &P::desiredDistance, "m", "Distance to the object."},
      {"detection_timeout", &P::detectionTimeout, "s", "Older detections are ignored."},
      {"rotate_to_object_timeout", &P::rotateToObjectTimeout, "s",
       "Maximum duration of the search."},
      {"static_object_timeout", &P::staticObjectTimeout, "s",
       "Time after which following a standing object succeeds; negative: never."},
      {"linear_tolerance", &P::linearTolerance, "m",
       "Distance to the object's pose within which the robot stands still."},
      {"angular_tolerance", &P::angularTolerance, "rad",
       "Maximum heading difference to the object's pose."},
      {"max_retries", &P::maxRetries, "", "Maximum number of searches for a lost object."},
      {"skip_orientation", &P::skipOrientation, "", "Whether the object's heading is ignored."},
      {"search_by_rotating", &P::searchByRotating, "", "Whether the robot rotates to search."},
      {"search_angle", &P::searchAngle, "rad", "Angle of the search to either side."},
      {"filter_coef", &P::filterCoef, "", "Weight of a new detection."},
  };
  return onlyIn(kFollowingDistros, joinedKeys<P>(own, controllerKeys<P>()));
}

IgnoredKeys ignoredFollowingServerKeys() {
  IgnoredKeys keys = ignoredControllerKeys();
  for (IgnoredKey& key : keys) {
    key.distros = kFollowingDistros;
  }
  return keys;
}

base::Diagnostics problemsOf(const DockingServerParameters& parameters) {
  base::Diagnostics problems;
  ParameterChecks checks(problems);
  checks.require("controller_frequency", parameters.controllerFrequency, kCommandRate);
  checks.require("undock_linear_tolerance", parameters.undockLinearTolerance, kAboveZero);
  checks.require("undock_angular_tolerance", parameters.undockAngularTolerance, kAboveZero);
  checkController(parameters, checks);
  return problems;
}

base::Diagnostics problemsOf(const FollowingServerParameters& parameters) {
  base::Diagnostics problems;
  ParameterChecks checks(problems);
  checks.require("controller_frequency", parameters.controllerFrequency, kCommandRate);
  checks.require("desired_distance", parameters.desiredDistance, kZeroOrMore);
  checks.require("filter_coef", parameters.filterCoef, kShare);
  checkController(parameters, checks);
  return problems;
}

base::Diagnostics problemsOf(const DockPluginParameters& plugin) {
  base::Diagnostics problems;
  ParameterChecks checks(problems, plugin.name + ".");
  checks.require("filter_coef", plugin.filterCoef, kShare);
  checks.require(plugin.direction == "forward" || plugin.direction == "backward", "dock_direction",
                 "forward or backward");
  return problems;
}

}  // namespace sim2d::nav2

#include "sim2d/nav/nav2/docking/DockingParameters.h"

#include <cstddef>
#include <limits>
#include <utility>

namespace sim2d::nav2 {
namespace {

template <class P>
std::vector<Nav2Key<P>> controllerKeys() {
  return {
      {"controller.k_phi", &P::kPhi, "", "Of the control law: slow against fast subsystem.",
       kSinceJazzy},
      {"controller.k_delta", &P::kDelta, "1/m", "Of the control law: gain of the heading.",
       kSinceJazzy},
      {"controller.beta", &P::beta, "", "Of the control law: speed lost in curves.", kSinceJazzy},
      {"controller.lambda", &P::lambda, "", "Of the control law: sharpness of that loss.",
       kSinceJazzy},
      {"controller.v_linear_min", &P::minLinear, "m/s", "Lowest speed.", kSinceJazzy},
      {"controller.v_linear_max", &P::maxLinear, "m/s", "Highest speed.", kSinceJazzy},
      {"controller.v_angular_max", &P::maxAngular, "rad/s", "Highest turn rate.", kSinceJazzy},
      {"controller.slowdown_radius", &P::slowdownRadius, "m",
       "Distance to the target from which the robot slows down.", kSinceJazzy},
      {"controller.deceleration_max", &P::maxDeceleration, "m/s²",
       "Deceleration with which the robot can stop at the target.", kSinceLyrical},
      {"controller.rotate_to_heading_angular_vel", &P::rotationSpeed, "rad/s",
       "Turn rate on the spot.", kSinceJazzy},
      {"controller.rotate_to_heading_max_angular_accel", &P::rotationAcceleration, "rad/s²",
       "Angular acceleration on the spot.", kSinceJazzy},
      {"controller.use_collision_detection", &P::usesCollisionDetection, "",
       "Whether commands that lead into obstacles fail.", kSinceJazzy},
      {"controller.projection_time", &P::projectionTime, "s", "How far ahead collisions count.",
       kSinceJazzy},
      {"controller.simulation_time_step", &P::simulationTimeStep, "s", "Step of that simulation.",
       kSinceJazzy},
      {"controller.dock_collision_threshold", &P::dockCollisionThreshold, "m",
       "Collisions this near to the dock do not count.", kSinceJazzy},
  };
}

template <class P>
std::vector<Nav2Key<P>> with(std::vector<Nav2Key<P>> keys, const std::vector<Nav2Key<P>>& more) {
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

std::vector<IdleKey> controllerIdleKeys() {
  return {{"controller.costmap_topic", "the local costmap counts", kSinceJazzy},
          {"controller.footprint_topic", "the footprint of the local costmap counts", kSinceJazzy},
          {"controller.transform_tolerance", "no TF here", kSinceJazzy},
          {"base_frame", "frames coincide here", kSinceJazzy},
          {"fixed_frame", "frames coincide here", kSinceJazzy},
          {"odom_topic", "no topics here", kSinceKilted},
          {"odom_duration", "speeds are those of the odometry", kSinceLyrical}};
}

constexpr double kAlways = std::numeric_limits<double>::max();

/// Values of the keys that must be within their ranges.
template <class P>
struct Limit {
  const char* key;
  double P::*member;
  double low, high;
  bool isAbove;  // low itself is not allowed
  const char* wanted;
};

template <class P, std::size_t n>
void check(const P& parameters, const Limit<P> (&limits)[n], base::Diagnostics& problems) {
  for (const Limit<P>& limit : limits) {
    const double value = parameters.*limit.member;
    const bool isFine =
        (limit.isAbove ? value > limit.low : value >= limit.low) && value <= limit.high;
    if (!isFine) {
      problems.push_back(base::error("nav2.bad-parameter", {limit.key, limit.wanted}));
    }
  }
}

void checkController(const DockControllerParameters& parameters, base::Diagnostics& problems) {
  using P = DockControllerParameters;
  static constexpr Limit<P> kLimits[] = {
      {"controller.slowdown_radius", &P::slowdownRadius, 0.0, kAlways, true, "above 0"},
      {"controller.v_linear_max", &P::maxLinear, 0.0, kAlways, true, "above 0"},
      {"controller.v_linear_min", &P::minLinear, 0.0, kAlways, false, "0 or more"},
      {"controller.v_angular_max", &P::maxAngular, 0.0, kAlways, true, "above 0"},
      {"controller.deceleration_max", &P::maxDeceleration, 0.0, kAlways, true, "above 0"},
      {"controller.projection_time", &P::projectionTime, 0.0, 100.0, false, "0 to 100 s"},
      {"controller.simulation_time_step", &P::simulationTimeStep, 0.01, 100.0, false,
       "0.01 to 100 s"},
      {"controller.rotate_to_heading_max_angular_accel", &P::rotationAcceleration, 0.0, kAlways,
       true, "above 0"}};
  check(parameters, kLimits, problems);
}

}  // namespace

GracefulParameters lawOf(const DockControllerParameters& controller) {
  GracefulParameters law;
  law.kPhi = controller.kPhi;
  law.kDelta = controller.kDelta;
  law.beta = controller.beta;
  law.lambda = controller.lambda;
  law.minLinear = controller.minLinear;
  law.maxLinear = controller.maxLinear;
  law.maxAngular = controller.maxAngular;
  law.slowdownRadius = controller.slowdownRadius;
  law.maxDeceleration = controller.maxDeceleration;
  return law;
}

const std::vector<Nav2Key<DockingServerParameters>>& dockingServerKeys() {
  using P = DockingServerParameters;
  static const std::vector<Nav2Key<P>> kKeys = with<P>(
      {{"controller_frequency", &P::controllerFrequency, "Hz", "Rate of commands.", kSinceJazzy},
       {"initial_perception_timeout", &P::initialPerceptionTimeout, "s",
        "How long the dock is looked for before the approach.", kSinceJazzy},
       {"wait_charge_timeout", &P::waitChargeTimeout, "s",
        "How long the robot waits for the charge to begin.", kSinceJazzy},
       {"dock_approach_timeout", &P::dockApproachTimeout, "s", "Longest approach.", kSinceJazzy},
       {"rotate_to_dock_timeout", &P::rotateToDockTimeout, "s", "Longest turn to the dock.",
        kSinceKilted},
       {"undock_linear_tolerance", &P::undockLinearTolerance, "m",
        "This near to the staging pose the robot has undocked.", kSinceJazzy},
       {"undock_angular_tolerance", &P::undockAngularTolerance, "rad",
        "Its heading there differs by less.", kSinceJazzy},
       {"rotation_angular_tolerance", &P::rotationAngularTolerance, "rad",
        "A turn to the dock ends within this angle.", kSinceKilted},
       {"dock_prestaging_tolerance", &P::dockPrestagingTolerance, "m",
        "This near to the staging pose the robot does not drive there first.", kSinceJazzy},
       {"max_retries", &P::maxRetries, "", "How often an approach that failed is repeated.",
        kSinceJazzy},
       {"dock_backwards", &P::dockBackwards, "", "Whether the robot backs in.", kJazzy | kKilted},
       {"dock_plugins", &P::dockPlugins, "", "Names of the classes of docks.", kSinceJazzy},
       {"docks", &P::docks, "", "Names of the docks.", kSinceJazzy},
       {"dock_database", &P::dockDatabase, "", "A file with docks, instead of docks.",
        kSinceJazzy}},
      controllerKeys<P>());
  return kKeys;
}

const std::vector<IdleKey>& idleDockingServerKeys() {
  static const std::vector<IdleKey> kKeys = [] {
    std::vector<IdleKey> keys = controllerIdleKeys();
    keys.push_back(
        {"navigator_bt_xml", "planner and controller of the file drive to the dock", kSinceJazzy});
    return keys;
  }();
  return kKeys;
}

namespace {

std::vector<Nav2Key<DockPluginParameters>> everyDockKeys() {
  using P = DockPluginParameters;
  return {{"staging_x_offset", &P::stagingXOffset, "m", "Staging pose ahead of the dock's pose.",
           kSinceJazzy},
          {"staging_yaw_offset", &P::stagingYawOffset, "rad",
           "Heading of the staging pose against the dock's.", kSinceJazzy},
          {"docking_threshold", &P::dockingThreshold, "m",
           "This near to the dock's pose the robot is docked.", kSinceJazzy},
          {"use_external_detection_pose", &P::usesDetection, "",
           "Whether the robot approaches the dock that it detects.", kSinceJazzy},
          {"external_detection_timeout", &P::detectionTimeout, "s",
           "Older detections do not count.", kSinceJazzy},
          {"filter_coef", &P::filterCoef, "", "Weight of a new detection.", kSinceJazzy},
          {"dock_direction", &P::direction, "", "forward or backward.", kSinceKilted},
          {"rotate_to_dock", &P::rotatesToDock, "",
           "Whether the robot turns round at the staging pose to back in.", kSinceKilted}};
}

}  // namespace

const std::vector<Nav2Key<DockPluginParameters>>& dockPluginKeys() {
  using P = DockPluginParameters;
  static const std::vector<Nav2Key<P>> kKeys =
      with<P>({{"charging_threshold", &P::chargingThreshold, "A",
                "The robot is charged when the current is above this.", kSinceJazzy},
               {"use_battery_status", &P::usesBatteryStatus, "",
                "Whether the battery shows that the robot is charged; else it is when docked.",
                kSinceJazzy}},
              everyDockKeys());
  return kKeys;
}

const std::vector<Nav2Key<DockPluginParameters>>& parkingDockKeys() {
  static const std::vector<Nav2Key<DockPluginParameters>> kKeys = everyDockKeys();
  return kKeys;
}

const std::vector<IdleKey>& idleDockPluginKeys() {
  static constexpr const char* kDetection = "a detection is the pose of the dock itself";
  static constexpr const char* kStall = "docks do not block robots: docking_threshold counts";
  static const std::vector<IdleKey> kKeys = {
      {"external_detection_translation_x", kDetection, kSinceJazzy},
      {"external_detection_translation_y", kDetection, kSinceJazzy},
      {"external_detection_rotation_roll", kDetection, kSinceJazzy},
      {"external_detection_rotation_pitch", kDetection, kSinceJazzy},
      {"external_detection_rotation_yaw", kDetection, kSinceJazzy},
      {"use_stall_detection", kStall, kSinceJazzy},
      {"stall_joint_names", kStall, kSinceJazzy},
      {"stall_velocity_threshold", kStall, kSinceJazzy},
      {"stall_effort_threshold", kStall, kSinceJazzy},
      {"detector_service_name", "no services here", kSinceLyrical},
      {"detector_service_timeout", "no services here", kSinceLyrical},
      {"subscribe_toggle", "no topics here", kSinceLyrical}};
  return kKeys;
}

const std::vector<Nav2Key<FollowingServerParameters>>& followingServerKeys() {
  using P = FollowingServerParameters;
  // The package exists since Lyrical; some of its keys were ported back to Jazzy.
  constexpr unsigned kHere = kJazzy | kSinceLyrical;
  static const std::vector<Nav2Key<P>> kKeys = [] {
    std::vector<Nav2Key<P>> keys = {
        {"controller_frequency", &P::controllerFrequency, "Hz", "Rate of commands.", kHere},
        {"desired_distance", &P::desiredDistance, "m", "Distance to the object.", kHere},
        {"detection_timeout", &P::detectionTimeout, "s", "Older detections do not count.", kHere},
        {"rotate_to_object_timeout", &P::rotateToObjectTimeout, "s", "Longest search.", kHere},
        {"static_object_timeout", &P::staticObjectTimeout, "s",
         "Success when the object has stood for so long; below 0: never.", kHere},
        {"linear_tolerance", &P::linearTolerance, "m", "The robot stands within this distance.",
         kHere},
        {"angular_tolerance", &P::angularTolerance, "rad", "Its heading there differs by less.",
         kHere},
        {"max_retries", &P::maxRetries, "", "How often an object that was lost is looked for.",
         kHere},
        {"skip_orientation", &P::skipOrientation, "", "Whether the object's heading is ignored.",
         kHere},
        {"search_by_rotating", &P::searchByRotating, "", "Whether the robot turns to search.",
         kHere},
        {"search_angle", &P::searchAngle, "rad", "How far it turns, to either side.", kHere},
        {"filter_coef", &P::filterCoef, "", "Weight of a new detection.", kHere}};
    for (Nav2Key<P> key : controllerKeys<P>()) {
      key.distros &= kHere;
      keys.push_back(key);
    }
    return keys;
  }();
  return kKeys;
}

const std::vector<IdleKey>& idleFollowingServerKeys() {
  static const std::vector<IdleKey> kKeys = [] {
    std::vector<IdleKey> keys = controllerIdleKeys();
    for (IdleKey& key : keys) {
      key.distros = kJazzy | kSinceLyrical;
    }
    return keys;
  }();
  return kKeys;
}

base::Diagnostics problemsOf(const DockingServerParameters& parameters) {
  using P = DockingServerParameters;
  static constexpr Limit<P> kLimits[] = {
      {"controller_frequency", &P::controllerFrequency, 0.0, 1000.0, true,
       "above 0, up to 1000 Hz"},
      {"undock_linear_tolerance", &P::undockLinearTolerance, 0.0, kAlways, true, "above 0"},
      {"undock_angular_tolerance", &P::undockAngularTolerance, 0.0, kAlways, true, "above 0"}};
  base::Diagnostics problems;
  check(parameters, kLimits, problems);
  checkController(parameters, problems);
  return problems;
}

base::Diagnostics problemsOf(const FollowingServerParameters& parameters) {
  using P = FollowingServerParameters;
  static constexpr Limit<P> kLimits[] = {
      {"controller_frequency", &P::controllerFrequency, 0.0, 1000.0, true,
       "above 0, up to 1000 Hz"},
      {"desired_distance", &P::desiredDistance, 0.0, kAlways, false, "0 or more"},
      {"filter_coef", &P::filterCoef, 0.0, 1.0, false, "0 to 1"}};
  base::Diagnostics problems;
  check(parameters, kLimits, problems);
  checkController(parameters, problems);
  return problems;
}

base::Diagnostics problemsOf(const DockPluginParameters& plugin) {
  base::Diagnostics problems;
  if (!(plugin.filterCoef >= 0.0 && plugin.filterCoef <= 1.0)) {
    problems.push_back(base::error("nav2.bad-parameter", {plugin.name + ".filter_coef", "0 to 1"}));
  }
  if (plugin.direction != "forward" && plugin.direction != "backward") {
    problems.push_back(base::error("nav2.bad-parameter",
                                   {plugin.name + ".dock_direction", "forward or backward"}));
  }
  return problems;
}

}  // namespace sim2d::nav2

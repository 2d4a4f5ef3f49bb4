#include "sim2d/nav/nav2/mppi/CriticSettings.h"

#include <utility>
#include <vector>

namespace sim2d::nav2 {
namespace {

constexpr char kEnabled[] = "whether it is asked";
constexpr char kPower[] = "what it costs is raised to this power";
constexpr char kWeight[] = "factor of what it costs";

/// The keys that nearly every critic has, and its own.
template <class Settings>
std::vector<Nav2Key<Settings>> criticKeys(std::vector<Nav2Key<Settings>> own,
                                          bool hasWeight = true) {
  std::vector<Nav2Key<Settings>> keys = {
      {"enabled", static_cast<bool Settings::*>(&Settings::isEnabled), "", kEnabled},
      {"cost_power", static_cast<int Settings::*>(&Settings::power), "", kPower},
  };
  if (hasWeight) {
    keys.push_back(
        {"cost_weight", static_cast<double Settings::*>(&Settings::weight), "", kWeight});
  }
  keys.insert(keys.end(), own.begin(), own.end());
  return keys;
}

constexpr char kUntilNear[] = "it is asked until the goal is nearer";
constexpr char kOnceNear[] = "it is asked once the goal is nearer";
constexpr char kFootprint[] = "collisions by the edges of the footprint, not by its centre";
constexpr char kOffset[] = "so many points of the path beyond the one reached furthest";

}  // namespace

MppiCriticSettings criticSettingsOf(Distro distro) {
  MppiCriticSettings settings;
  if (distro == Distro::Humble) {
    settings.cost.pointStep = 1;
    settings.obstacles.collisionCost = 1e4;
    settings.pathAngle.weight = 2.0;
    settings.pathAngle.mostAngle = 1.2;
  }
  return settings;
}

const std::vector<Nav2Key<ConstraintSettings>>& constraintKeys() {
  static const auto kKeys = criticKeys<ConstraintSettings>({});
  return kKeys;
}

const std::vector<Nav2Key<CostSettings>>& costCriticKeys() {
  using P = CostSettings;
  static const auto kKeys = criticKeys<P>({
      {"critical_cost", &P::criticalCost, "", "of a pose with near_collision_cost or more"},
      {"collision_cost", &P::collisionCost, "", "of a trajectory that collides"},
      {"near_goal_distance", &P::nearGoalDistance, "m", "nearer to the goal costs are forgiven"},
      {"near_collision_cost", &P::nearCollisionCost, "", "costs of cells that are critical",
       kSinceJazzy},
      {"consider_footprint", &P::considersFootprint, "", kFootprint},
      {"trajectory_point_step", &P::pointStep, "", "steps between poses that are looked at",
       kSinceJazzy},
  });
  return kKeys;
}

const std::vector<Nav2Key<ObstaclesSettings>>& obstaclesCriticKeys() {
  using P = ObstaclesSettings;
  static const auto kKeys = criticKeys<P>(
      {
          {"repulsion_weight", &P::repulsionWeight, "", "factor of being near obstacles"},
          {"critical_weight", &P::criticalWeight, "", "factor of being within the margin"},
          {"collision_cost", &P::collisionCost, "", "of a trajectory that collides"},
          {"collision_margin_distance", &P::marginDistance, "m", "nearer is critical"},
          {"near_goal_distance", &P::nearGoalDistance, "m", "nearer to the goal nothing repels"},
          {"consider_footprint", &P::considersFootprint, "", kFootprint},
          {"cost_scaling_factor", &P::costScaling, "1/m", "as that of the inflation layer",
           kHumble},
          {"inflation_radius", &P::inflationRadius, "m", "as that of the inflation layer", kHumble},
      },
      false);
  return kKeys;
}

const std::vector<Nav2Key<GoalSettings>>& goalCriticKeys() {
  using P = GoalSettings;
  static const auto kKeys =
      criticKeys<P>({{"threshold_to_consider", &P::threshold, "m", kOnceNear}});
  return kKeys;
}

const std::vector<Nav2Key<GoalAngleSettings>>& goalAngleKeys() {
  using P = GoalAngleSettings;
  static const auto kKeys = criticKeys<P>({
      {"threshold_to_consider", &P::threshold, "m", kOnceNear},
      {"symmetric_yaw_tolerance", &P::isSymmetric, "", "facing backwards is accepted too"},
  });
  return kKeys;
}

const std::vector<Nav2Key<PathAlignSettings>>& pathAlignKeys() {
  using P = PathAlignSettings;
  static const auto kKeys = criticKeys<P>({
      {"threshold_to_consider", &P::threshold, "m", kUntilNear},
      {"offset_from_furthest", &P::offsetFromFurthest, "",
       "it is asked once so many points of the path are reached"},
      {"trajectory_point_step", &P::pointStep, "", "steps between poses that are looked at"},
      {"max_path_occupancy_ratio", &P::mostOccupied, "",
       "it is not asked when more of the path is blocked"},
      {"use_path_orientations", &P::usesOrientations, "", "headings count as well"},
  });
  return kKeys;
}

const std::vector<Nav2Key<PathFollowSettings>>& pathFollowKeys() {
  using P = PathFollowSettings;
  static const auto kKeys = criticKeys<P>({
      {"threshold_to_consider", &P::threshold, "m", kUntilNear},
      {"offset_from_furthest", &P::offsetFromFurthest, "", kOffset},
  });
  return kKeys;
}

const std::vector<Nav2Key<PathAngleSettings>>& pathAngleKeys() {
  using P = PathAngleSettings;
  static const auto kKeys = criticKeys<P>({
      {"threshold_to_consider", &P::threshold, "m", kUntilNear},
      {"offset_from_furthest", &P::offsetFromFurthest, "", kOffset},
      {"max_angle_to_furthest", &P::mostAngle, "rad", "it is asked when the robot looks past it"},
      {"mode", &P::mode, "", "0: forward, 1: either end, 2: the way the path looks", kSinceJazzy},
      {"forward_preference", &P::isForwardPreferred, "", "false: either end is as good", kHumble},
  });
  return kKeys;
}

const std::vector<Nav2Key<PreferForwardSettings>>& preferForwardKeys() {
  using P = PreferForwardSettings;
  static const auto kKeys =
      criticKeys<P>({{"threshold_to_consider", &P::threshold, "m", kUntilNear}});
  return kKeys;
}

const std::vector<Nav2Key<TwirlingSettings>>& twirlingKeys() {
  static const auto kKeys = criticKeys<TwirlingSettings>({});
  return kKeys;
}

const std::vector<Nav2Key<DeadbandSettings>>& deadbandKeys() {
  using P = DeadbandSettings;
  static const auto kKeys = criticKeys<P>({
      {"deadband_velocities", &P::velocities, "m/s, m/s, rad/s",
       "vx, vy and wz that the base cannot drive below"},
  });
  return kKeys;
}

const std::vector<IdleKey>& criticIdleKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"inflation_layer_name", "there is one inflation layer here"},
  };
  return kKeys;
}

}  // namespace sim2d::nav2

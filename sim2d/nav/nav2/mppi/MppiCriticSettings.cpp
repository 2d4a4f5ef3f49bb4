#include "sim2d/nav/nav2/mppi/MppiCriticSettings.h"

#include <utility>
#include <vector>

namespace sim2d::nav2 {
namespace {

constexpr char kCriticEnabled[] = "whether the critic is enabled";
constexpr char kPower[] = "exponent of the cost";
constexpr char kWeight[] = "factor of the cost";

/// Common keys of the critics, followed by the critic's own.
template <class Settings>
std::vector<Nav2Key<Settings>> criticKeys(const std::vector<Nav2Key<Settings>>& own,
                                          bool hasWeight = true) {
  std::vector<Nav2Key<Settings>> keys = {
      {"enabled", static_cast<bool Settings::*>(&Settings::isEnabled), "", kCriticEnabled},
      {"cost_power", static_cast<int Settings::*>(&Settings::power), "", kPower},
  };
  if (hasWeight) {
    keys.push_back(
        {"cost_weight", static_cast<double Settings::*>(&Settings::weight), "", kWeight});
  }
  appendKeys(keys, own);
  return keys;
}

constexpr char kUntilNear[] = "distance to the goal above which the critic is active";
constexpr char kOnceNear[] = "distance to the goal below which the critic is active";
constexpr char kFootprint[] = "checks the edges of the footprint for collisions, not its centre";
constexpr char kOffset[] = "number of path points beyond the furthest point reached";

}  // namespace

MppiCriticSettings criticSettingsOf(Distro distro) {
  MppiCriticSettings settings;
  if (distro == Distro::Humble) {
    settings.cost.pointStep = 1;
    settings.obstacles.collisionCost = 1e4;
    settings.pathAngle.weight = 2.0;
    settings.pathAngle.maxAngleToFurthest = 1.2;
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
      {"critical_cost", &P::criticalCost, "", "cost of a pose with near_collision_cost or more"},
      {"collision_cost", &P::collisionCost, "", "cost of a trajectory that collides"},
      {"near_goal_distance", &P::nearGoalDistance, "m",
       "distance to the goal within which costs are ignored"},
      {"near_collision_cost", &P::nearCollisionCost, "", "cell cost from which a pose is critical",
       kSinceJazzy},
      {"consider_footprint", &P::considersFootprint, "", kFootprint},
      {"trajectory_point_step", &P::pointStep, "", "step between evaluated poses", kSinceJazzy},
  });
  return kKeys;
}

const std::vector<Nav2Key<ObstaclesSettings>>& obstaclesCriticKeys() {
  using P = ObstaclesSettings;
  static const auto kKeys = criticKeys<P>(
      {
          {"repulsion_weight", &P::repulsionWeight, "", "factor of the cost near obstacles"},
          {"critical_weight", &P::criticalWeight, "", "factor of the cost within the margin"},
          {"collision_cost", &P::collisionCost, "", "cost of a trajectory that collides"},
          {"collision_margin_distance", &P::marginDistance, "m",
           "distance to obstacles within which a pose is critical"},
          {"near_goal_distance", &P::nearGoalDistance, "m",
           "distance to the goal within which obstacles do not repel"},
          {"consider_footprint", &P::considersFootprint, "", kFootprint},
          {"cost_scaling_factor", &P::costScaling, "1/m",
           "must be equal to that of the inflation layer", kHumble},
          {"inflation_radius", &P::inflationRadius, "m",
           "must be equal to that of the inflation layer", kHumble},
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
      {"symmetric_yaw_tolerance", &P::isSymmetric, "", "the opposite heading is accepted too"},
  });
  return kKeys;
}

const std::vector<Nav2Key<PathAlignSettings>>& pathAlignKeys() {
  using P = PathAlignSettings;
  static const auto kKeys = criticKeys<P>({
      {"threshold_to_consider", &P::threshold, "m", kUntilNear},
      {"offset_from_furthest", &P::offsetFromFurthest, "",
       "number of reached path points from which the critic is active"},
      {"trajectory_point_step", &P::pointStep, "", "step between evaluated poses"},
      {"max_path_occupancy_ratio", &P::maxPathOccupancyRatio, "",
       "share of the blocked path above which the critic is inactive"},
      {"use_path_orientations", &P::usesOrientations, "", "evaluates headings too"},
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
      {"max_angle_to_furthest", &P::maxAngleToFurthest, "rad",
       "heading difference above which the critic is active"},
      {"mode", &P::mode, "", "0: forward, 1: either direction, 2: the path's headings",
       kSinceJazzy},
      {"forward_preference", &P::isForwardPreferred, "", "false: both directions are equivalent",
       kHumble},
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
       "vx, vy and wz below which the base cannot move"},
  });
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredCriticKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"inflation_layer_name", "this program uses a single inflation layer"},
  };
  return kKeys;
}

}  // namespace sim2d::nav2

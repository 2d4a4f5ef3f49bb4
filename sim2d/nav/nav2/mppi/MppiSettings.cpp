#include "sim2d/nav/nav2/mppi/MppiSettings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/mppi/MppiKernel.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"

namespace sim2d::nav2 {
namespace {

constexpr int kMaxTrajectories = 50000;
constexpr double kMaxPoints = 5000000;  // of all trajectories and iterations of a call

/// Main: the block of a motion model.
struct MotionModelSettings {
  std::string plugin;
  double minTurningRadius = 0.2;  // [m]
};

const std::vector<Nav2Key<MotionModelSettings>>& motionModelKeys() {
  using P = MotionModelSettings;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"plugin", &P::plugin, "",
       "class of the motion model, for example "
       "mppi::DiffDriveMotionModel",
       kSinceLyrical},
      {"min_turning_r", &P::minTurningRadius, "m", "minimum turning radius (Ackermann)",
       kSinceLyrical},
  };
  return kKeys;
}

constexpr std::array<const char*, 3> kMotionModels = {"DiffDrive", "Omni", "Ackermann"};
/// Lyrical and main: names of their blocks; these need no plugin key.
constexpr std::array<const char*, 3> kMotionBlocks = {"diff_drive", "omni", "ackermann"};

const std::vector<Nav2Key<MppiSettings>>& mppiKeys() {
  using P = MppiSettings;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"time_steps", &P::timeSteps, "", "time steps of a trajectory, 2 to 200"},
      {"model_dt", &P::modelDt, "s", "duration of a time step, at least the controller's period"},
      {"batch_size", &P::batchSize, "", "number of trajectories"},
      {"iteration_count", &P::iterationCount, "", "updates per call"},
      {"temperature", &P::temperature, "",
       "smaller values give more weight to the trajectories with the lowest cost"},
      {"gamma", &P::gamma, "", "larger values keep the controls closer to the last sequence"},
      {"vx_max", &P::vxMax, "m/s", "maximum forward speed"},
      {"vx_min", &P::vxMin, "m/s", "minimum speed; negative: backwards"},
      {"vy_max", &P::vyMax, "m/s", "maximum lateral speed (Omni)"},
      {"wz_max", &P::wzMax, "rad/s", "maximum turn rate"},
      {"ax_max", &P::axMax, "m/s²", "maximum forward acceleration", kSinceJazzy},
      {"ax_min", &P::axMin, "m/s²", "maximum deceleration, negative", kSinceJazzy},
      {"ay_max", &P::ayMax, "m/s²", "maximum lateral acceleration", kSinceJazzy},
      {"ay_min", &P::ayMin, "m/s²", "maximum lateral deceleration, negative", kSinceJazzy},
      {"az_max", &P::azMax, "rad/s²", "maximum angular acceleration", kSinceJazzy},
      {"vx_std", &P::vxStd, "m/s", "standard deviation of the noise on the forward speed"},
      {"vy_std", &P::vyStd, "m/s", "standard deviation of the noise on the lateral speed (Omni)"},
      {"wz_std", &P::wzStd, "rad/s", "standard deviation of the noise on the turn rate"},
      {"motion_model", &P::motionModel, "",
       "DiffDrive, Omni or Ackermann; since Lyrical: the block with the plugin"},
      {"AckermannConstraints.min_turning_r", &P::minTurningRadius, "m",
       "minimum turning radius (Ackermann)", kUntilKilted},
      {"retry_attempt_limit", &P::retryAttemptLimit, "",
       "maximum number of retries after failures"},
      {"regenerate_noises", &P::regeneratesNoises, "",
       "false: the same noise until the next reset"},
      {"open_loop", &P::isOpenLoop, "", "starts from the last command, not from the measured speed",
       kJazzy | kSinceLyrical},
      {"reset_period", &P::resetPeriod, "s", "time without a call after which the state is reset",
       kHumble},
      {"model_delay_vx", &P::vxDelay, "s", "delay until a command takes effect", kSinceLyrical},
      {"model_delay_vy", &P::vyDelay, "s", "delay until a command takes effect", kSinceLyrical},
      {"model_delay_wz", &P::wzDelay, "s", "delay until a command takes effect", kSinceLyrical},
      {"clamp_raw_controls", &P::clampsRawControls, "",
       "averages the controls after applying the limits, not the sampled ones", kSinceLyrical},
      {"sgf_order", &P::sgfOrder, "",
       "order of the Savitzky-Golay filter; 1: mean of nine, 2: "
       "quadratic",
       kSinceLyrical},
      {"critics", &P::critics, "", "critics that score trajectories, in this order"},
      {"TrajectoryValidator.collision_lookahead_time", &P::collisionLookahead, "s",
       "time for which the optimal trajectory must not collide", kSinceLyrical},
      {"TrajectoryValidator.consider_footprint", &P::validatesFootprint, "",
       "checks the edges of the footprint for collisions, not its centre", kSinceLyrical},
      {"max_robot_pose_search_dist", &P::searchDistance, "m",
       "length of the path that is searched for the robot; 0: half the costmap", kUntilKilted},
      {"prune_distance", &P::pruneDistance, "m", "length of the path that is used", kUntilKilted},
      {"enforce_path_inversion", &P::enforcesInversion, "",
       "the path is cut at its first cusp until the robot reaches it", kUntilKilted},
      {"inversion_xy_tolerance", &P::inversionXyTolerance, "m", "position tolerance at the cusp",
       kUntilKilted},
      {"inversion_yaw_tolerance", &P::inversionYawTolerance, "rad", "heading tolerance at the cusp",
       kUntilKilted},
  };
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredMppiKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"transform_tolerance", "TF is not used", kUntilKilted},
      {"visualize", "the window draws the evaluated trajectories"},
      {"publish_optimal_trajectory", "ROS topics are not used", kSinceKilted},
      {"publish_critics_stats", "ROS topics are not used", kKilted},
      {"critic_index_to_visualize", "the window shows all critics", kSinceLyrical},
      {"TrajectoryVisualizer.trajectory_step", "the window chooses what it draws"},
      {"TrajectoryVisualizer.time_step", "the window chooses what it draws"},
      {"TrajectoryValidator.plugin", "this program uses a single validator", kSinceLyrical},
  };
  return kKeys;
}

MppiSettings mppiDefaults(Distro distro) {
  MppiSettings settings;
  settings.motionModel = distro >= Distro::Lyrical ? kMotionBlocks[0] : kMotionModels[0];
  return settings;
}

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

/// The keys of a critic without keys of its own.
std::vector<Nav2Key<CommonCriticSettings>> keysOf(const CommonCriticSettings& /*critic*/) {
  return criticKeys<CommonCriticSettings>({});
}

std::vector<Nav2Key<CostSettings>> keysOf(const CostSettings& /*critic*/) {
  using P = CostSettings;
  return criticKeys<P>({
      {"critical_cost", &P::criticalCost, "", "cost of a pose with near_collision_cost or more"},
      {"collision_cost", &P::collisionCost, "", "cost of a trajectory that collides"},
      {"near_goal_distance", &P::nearGoalDistance, "m",
       "distance to the goal within which costs are ignored"},
      {"near_collision_cost", &P::nearCollisionCost, "", "minimum cell cost of a critical pose",
       kSinceJazzy},
      {"consider_footprint", &P::considersFootprint, "", kFootprint},
      {"trajectory_point_step", &P::pointStep, "", "step between evaluated poses", kSinceJazzy},
  });
}

std::vector<Nav2Key<ObstaclesSettings>> keysOf(const ObstaclesSettings& /*critic*/) {
  using P = ObstaclesSettings;
  return criticKeys<P>(
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
}

std::vector<Nav2Key<GoalSettings>> keysOf(const GoalSettings& /*critic*/) {
  using P = GoalSettings;
  return criticKeys<P>({{"threshold_to_consider", &P::threshold, "m", kOnceNear}});
}

std::vector<Nav2Key<GoalAngleSettings>> keysOf(const GoalAngleSettings& /*critic*/) {
  using P = GoalAngleSettings;
  return criticKeys<P>({
      {"threshold_to_consider", &P::threshold, "m", kOnceNear},
      {"symmetric_yaw_tolerance", &P::isSymmetric, "", "the opposite heading is also accepted"},
  });
}

std::vector<Nav2Key<PathAlignSettings>> keysOf(const PathAlignSettings& /*critic*/) {
  using P = PathAlignSettings;
  return criticKeys<P>({
      {"threshold_to_consider", &P::threshold, "m", kUntilNear},
      {"offset_from_furthest", &P::offsetFromFurthest, "",
       "minimum number of reached path points for the critic to be active"},
      {"trajectory_point_step", &P::pointStep, "", "step between evaluated poses"},
      {"max_path_occupancy_ratio", &P::maxPathOccupancyRatio, "",
       "share of the blocked path above which the critic is inactive"},
      {"use_path_orientations", &P::usesOrientations, "", "evaluates headings too"},
  });
}

std::vector<Nav2Key<PathFollowSettings>> keysOf(const PathFollowSettings& /*critic*/) {
  using P = PathFollowSettings;
  return criticKeys<P>({
      {"threshold_to_consider", &P::threshold, "m", kUntilNear},
      {"offset_from_furthest", &P::offsetFromFurthest, "", kOffset},
  });
}

std::vector<Nav2Key<PathAngleSettings>> keysOf(const PathAngleSettings& /*critic*/) {
  using P = PathAngleSettings;
  return criticKeys<P>({
      {"threshold_to_consider", &P::threshold, "m", kUntilNear},
      {"offset_from_furthest", &P::offsetFromFurthest, "", kOffset},
      {"max_angle_to_furthest", &P::maxAngleToFurthest, "rad",
       "heading difference above which the critic is active"},
      {"mode", &P::mode, "", "0: forward, 1: either direction, 2: the path's headings",
       kSinceJazzy},
      {"forward_preference", &P::isForwardPreferred, "", "false: both directions are equivalent",
       kHumble},
  });
}

std::vector<Nav2Key<PreferForwardSettings>> keysOf(const PreferForwardSettings& /*critic*/) {
  using P = PreferForwardSettings;
  return criticKeys<P>({{"threshold_to_consider", &P::threshold, "m", kUntilNear}});
}

std::vector<Nav2Key<DeadbandSettings>> keysOf(const DeadbandSettings& /*critic*/) {
  using P = DeadbandSettings;
  return criticKeys<P>({
      {"deadband_velocities", &P::velocities, "m/s, m/s, rad/s",
       "vx, vy and wz below which the base cannot move"},
  });
}

/// "DiffDrive" -> "mppi::DiffDriveMotionModel".
std::string motionPluginOf(const std::string& model) {
  return "mppi::" + model + "MotionModel";
}

constexpr NumberRange kPositiveNumber{{std::numeric_limits<double>::min(), 1e6}, "greater than 0"};
constexpr NumberRange kZeroOrMoreNumber{{0.0, 1e6}, "0 or more"};
constexpr NumberRange kZeroOrLessNumber{{-1e6, 0.0}, "0 or less"};
constexpr NumberRange kDeviation{{0.0, 100.0}, "0 to 100"};

void checkCount(ParameterChecks& checks, const std::string& key, int value, int least, int most) {
  checks.within(key, value, {static_cast<double>(least), static_cast<double>(most)},
                std::to_string(least) + " to " + std::to_string(most));
}

/// Checked only if each of the three counts is valid.
void checkWork(const MppiSettings& settings, base::Diagnostics& problems) {
  const double points =
      static_cast<double>(settings.batchSize) * settings.timeSteps * settings.iterationCount;
  if (!base::hasErrors(problems) && !(points <= kMaxPoints)) {
    problems.push_back(base::error(
        "nav2.too-much-work", {"batch_size", settings.batchSize, "time_steps and iteration_count",
                               points, "points per call", kMaxPoints}));
  }
}

/// Checks the values that the motion model reads; other values have no effect.
void checkMotion(const MppiConfiguration& mppi, ParameterChecks& checks) {
  const MppiSettings& settings = mppi.settings;
  if (mppi.motion == MppiMotion::Omni) {
    checks.within("vy_max", settings.vyMax, kZeroOrMoreNumber);
    checks.within("ay_max", settings.ayMax, kZeroOrMoreNumber);
    checks.within("ay_min", settings.ayMin, kZeroOrLessNumber);
    checks.within("vy_std", settings.vyStd, kDeviation);
    checks.within("model_delay_vy", settings.vyDelay, kZeroOrMoreNumber);
  } else if (mppi.motion == MppiMotion::Ackermann) {
    const std::string block =
        mppi.distro >= Distro::Lyrical ? settings.motionModel : "AckermannConstraints";
    checks.within(block + ".min_turning_r", settings.minTurningRadius, kPositiveNumber);
  }
}

void checkOptimizer(const MppiSettings& settings, ParameterChecks& checks,
                    base::Diagnostics& problems) {
  checkCount(checks, "time_steps", settings.timeSteps, 2, kMaxMppiSteps);
  checkCount(checks, "batch_size", settings.batchSize, 1, kMaxTrajectories);
  checkCount(checks, "iteration_count", settings.iterationCount, 1, 1000);
  checkWork(settings, problems);
  checkCount(checks, "retry_attempt_limit", settings.retryAttemptLimit, 0, 1000);
  checkCount(checks, "sgf_order", settings.sgfOrder, 1, 2);
  checks.within("model_dt", settings.modelDt, kPositiveNumber);
  checks.within("temperature", settings.temperature, kPositiveNumber);
  checks.within("gamma", settings.gamma, kZeroOrMoreNumber);
  checks.within("vx_max", settings.vxMax, kPositiveNumber);
  checks.within("wz_max", settings.wzMax, kZeroOrMoreNumber);
  const double mostBack = settings.vxMax > 0.0 ? settings.vxMax : 1e6;  // else vx_max is invalid
  checks.within("vx_min", settings.vxMin, {-1e6, mostBack}, "vx_max or less");
  checks.within("ax_max", settings.axMax, kZeroOrMoreNumber);
  checks.within("az_max", settings.azMax, kZeroOrMoreNumber);
  checks.within("ax_min", settings.axMin, kZeroOrLessNumber);
  checks.within("vx_std", settings.vxStd, kDeviation);
  checks.within("wz_std", settings.wzStd, kDeviation);
  checks.within("model_delay_vx", settings.vxDelay, kZeroOrMoreNumber);
  checks.within("model_delay_wz", settings.wzDelay, kZeroOrMoreNumber);
  checks.within("TrajectoryValidator.collision_lookahead_time", settings.collisionLookahead,
                kZeroOrMoreNumber);
  checks.within("prune_distance", settings.pruneDistance, kPositiveNumber);
}

void checkFinite(const Nav2ParameterBlock& block, base::Diagnostics& problems) {
  for (const auto& [key, value] : block) {
    const double* number = std::get_if<double>(&value);
    if (number != nullptr && !std::isfinite(*number)) {
      problems.push_back(base::error("nav2.wrong-value", {key, *number, "a finite number"}));
    }
  }
}

void checkCritics(const MppiCriticSettings& critics, ParameterChecks& checks) {
  visitCritics(critics, [&](const char* name, const auto& critic) {
    const std::string prefix = std::string(name) + ".";
    checkCount(checks, prefix + "cost_power", critic.power, 0, 100);
    checks.within(prefix + "cost_weight", critic.weight, {-1e9, 1e9}, "a finite number");
  });
  checkCount(checks, "CostCritic.trajectory_point_step", critics.cost.pointStep, 1, kMaxMppiSteps);
  checkCount(checks, "PathAlignCritic.trajectory_point_step", critics.pathAlign.pointStep, 1,
             kMaxMppiSteps);
  checkCount(checks, "PathAlignCritic.offset_from_furthest", critics.pathAlign.offsetFromFurthest,
             0, kMaxTrajectories);
  checkCount(checks, "PathFollowCritic.offset_from_furthest", critics.pathFollow.offsetFromFurthest,
             0, kMaxTrajectories);
  checkCount(checks, "PathAngleCritic.offset_from_furthest", critics.pathAngle.offsetFromFurthest,
             0, kMaxTrajectories);
  checkCount(checks, "PathAngleCritic.mode", critics.pathAngle.mode, 0, 2);
  checks.within("VelocityDeadbandCritic.deadband_velocities (size)",
                static_cast<double>(critics.deadband.velocities.size()), {3.0, 3.0}, "3");
}

std::vector<std::string> knownCritics() {
  MppiCriticSettings settings;
  std::vector<std::string> names;
  visitCritics(settings,
               [&](const char* name, const auto& /*critic*/) { names.emplace_back(name); });
  return names;
}

/// Misspelt critics are errors; those of other packages are removed from the list.
void checkCriticNames(std::vector<std::string>& critics, base::Diagnostics& problems) {
  const std::vector<std::string> known = knownCritics();
  const auto isOther = [&](const std::string& name) {
    if (std::find(known.begin(), known.end(), name) != known.end()) {
      return false;
    }
    const bool isWrong = isMisspelt(name, known);
    problems.push_back(
        isWrong ? unknownPlugin(name, known)
                : base::warning("nav2.left-out", {name, name, "the critic is not re-implemented"}));
    return !isWrong;
  };
  critics.erase(std::remove_if(critics.begin(), critics.end(), isOther), critics.end());
}

/// Sets the motion model; in main the key names a block with the plugin.
void readMotion(const Nav2ParameterBlock& block, MppiConfiguration& mppi,
                base::Diagnostics& problems) {
  std::string model = mppi.settings.motionModel;
  std::vector<std::string> known(kMotionModels.begin(), kMotionModels.end());
  if (mppi.distro >= Distro::Lyrical) {
    const std::string prefix = model + ".";
    MotionModelSettings given =
        applyBlock(MotionModelSettings(), motionModelKeys(), block, mppi.distro, problems, prefix);
    mppi.settings.minTurningRadius = given.minTurningRadius;
    const auto named = std::find(kMotionBlocks.begin(), kMotionBlocks.end(), model);
    if (given.plugin.empty() && named != kMotionBlocks.end()) {
      mppi.motion = static_cast<MppiMotion>(named - kMotionBlocks.begin());
      return;
    }
    if (!given.plugin.empty()) {
      model = normalizedPluginClass(given.plugin);
      std::transform(known.begin(), known.end(), known.begin(), motionPluginOf);
    }
  }
  const auto found = std::find(known.begin(), known.end(), model);
  if (found == known.end()) {
    problems.push_back(
        isMisspelt(model, known) || model.find(':') == std::string::npos
            ? unknownPlugin(model, known)
            : base::warning("nav2.treated-as", {"motion_model", model, known.front(),
                                                "its package is not re-implemented"}));
    return;
  }
  mppi.motion = static_cast<MppiMotion>(found - known.begin());
}

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

base::Result<MppiConfiguration> readMppi(const Nav2ParameterBlock& block, Distro distro) {
  base::Diagnostics problems;
  MppiConfiguration mppi;
  mppi.distro = distro;
  mppi.settings = applyBlock(mppiDefaults(distro), mppiKeys(), block, distro, problems);
  mppi.critics = criticSettingsOf(distro);
  visitCritics(mppi.critics, [&](const char* name, auto& critic) {
    critic = applyBlock(critic, keysOf(critic), block, distro, problems, std::string(name) + ".");
  });
  invertPositiveDecelerations({{"ax_min", &mppi.settings.axMin}, {"ay_min", &mppi.settings.ayMin}},
                              problems);
  readMotion(block, mppi, problems);
  checkFinite(block, problems);
  ParameterChecks checks(problems);
  checkOptimizer(mppi.settings, checks, problems);
  checkMotion(mppi, checks);
  checkCritics(mppi.critics, checks);
  checkCriticNames(mppi.settings.critics, problems);
  if (mppi.settings.critics.empty()) {
    problems.push_back(base::warning("nav2.mppi-no-critics"));
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::move(mppi), std::move(problems)};
}

Nav2KeyTable mppiKeysOf(const Nav2ParameterBlock& block, Distro distro) {
  Nav2KeyTable keys = keyTableOf(mppiKeys(), mppiDefaults(distro), ignoredMppiKeys());
  base::Diagnostics ignored;  // reported when the controller is created
  const MppiSettings given = applyBlock(mppiDefaults(distro), mppiKeys(), block, distro, ignored);
  if (distro >= Distro::Lyrical) {
    addKeyRows(keys, motionModelKeys(), MotionModelSettings(), given.motionModel + ".");
  }
  const MppiCriticSettings critics = criticSettingsOf(distro);
  visitCritics(critics, [&](const char* name, const auto& critic) {
    const auto table = keysOf(critic);
    const std::string prefix = std::string(name) + ".";
    const auto& listed = given.critics;
    if (std::find(listed.begin(), listed.end(), name) != listed.end()) {
      addKeyRows(keys, table, critic, prefix);
      const bool isCost = prefix == "CostCritic.";
      if (isCost || prefix == "ObstaclesCritic.") {
        keys.ignored.push_back({prefix + "inflation_layer_name",
                                "this program uses a single inflation layer",
                                isCost ? kAllDistros : kSinceJazzy});
      }
      return;
    }
    for (const auto& key : table) {
      keys.ignored.push_back(
          {prefix + key.name, std::string(name) + " is not in critics", key.distros});
    }
  });
  const std::vector<std::string> known = knownCritics();
  for (const std::string& name : given.critics) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      keys.ignored.push_back({name + ".", "the critic is not re-implemented"});
    }
  }
  return keys;
}

MppiShift mppiShiftOf(double period, double modelDt) {
  constexpr double kSame = 1e-6;  // [s]
  if (period + kSame < modelDt) {
    return MppiShift::Keeps;
  }
  return std::abs(period - modelDt) < kSame ? MppiShift::Shifts : MppiShift::Refused;
}

}  // namespace sim2d::nav2

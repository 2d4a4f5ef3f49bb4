#include "sim2d/nav/nav2/control/dwb/DwbParameters.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/dwb/DwbController.h"
#include "sim2d/nav/nav2/control/dwb/DwbTrajectory.h"

namespace sim2d::nav2 {

const std::vector<Nav2Key<DwbParameters>>& dwbKeys() {
  using P = DwbParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"min_vel_x", &P::minVelX, "m/s", "minimum forward velocity; negative: backwards"},
      {"max_vel_x", &P::maxVelX, "m/s", "maximum forward velocity"},
      {"min_vel_y", &P::minVelY, "m/s", "minimum velocity to the left"},
      {"max_vel_y", &P::maxVelY, "m/s", "maximum velocity to the left"},
      {"max_vel_theta", &P::maxVelTheta, "rad/s", "maximum angular velocity in both directions"},
      {"min_speed_xy", &P::minSpeedXy, "m/s",
       "minimum speed of samples that turn slower than min_speed_theta; negative: no limit"},
      {"max_speed_xy", &P::maxSpeedXy, "m/s", "maximum speed; negative: no limit"},
      {"min_speed_theta", &P::minSpeedTheta, "rad/s",
       "minimum turn rate of samples that are slower than min_speed_xy; negative: no limit"},
      {"acc_lim_x", &P::accLimX, "m/s^2", "forward acceleration"},
      {"acc_lim_y", &P::accLimY, "m/s^2", "acceleration to the left"},
      {"acc_lim_theta", &P::accLimTheta, "rad/s^2", "angular acceleration"},
      {"decel_lim_x", &P::decelLimX, "m/s^2", "forward deceleration, negative"},
      {"decel_lim_y", &P::decelLimY, "m/s^2", "lateral deceleration, negative"},
      {"decel_lim_theta", &P::decelLimTheta, "rad/s^2", "angular deceleration, negative"},
      {"trajectory_generator_name", &P::generator, "",
       "dwb_plugins::StandardTrajectoryGenerator or dwb_plugins::LimitedAccelGenerator"},
      {"sim_time", &P::simTime, "s", "simulated time of a trajectory"},
      {"sim_period", &P::simPeriod, "s",
       "samples velocities that are reachable within this time (LimitedAccelGenerator); 0: one "
       "cycle"},
      {"vx_samples", &P::vxSamples, "", "number of forward velocity samples"},
      {"vy_samples", &P::vySamples, "", "number of lateral velocity samples"},
      {"vtheta_samples", &P::vthetaSamples, "", "number of angular velocity samples"},
      {"discretize_by_time", &P::discretizesByTime, "",
       "poses of a trajectory at equal times, not distances"},
      {"time_granularity", &P::timeGranularity, "s", "time between poses"},
      {"linear_granularity", &P::linearGranularity, "m", "distance between poses"},
      {"angular_granularity", &P::angularGranularity, "rad", "rotation between poses"},
      {"include_last_point", &P::includesLastPoint, "", "the last pose is included twice"},
      {"limit_vel_cmd_in_traj", &P::limitsCommand, "",
       "the command is the velocity that is reachable in the first step"},
      {"critics", &P::critics, "", "critics that score trajectories, in this order"},
      {"default_critic_namespaces", &P::criticNamespaces, "",
       "namespaces in which critics are searched by name; none: dwb_critics"},
      {"short_circuit_trajectory_evaluation", &P::shortCircuits, "",
       "stops scoring a trajectory whose cost exceeds the best one"},
      {"trans_stopped_velocity", &P::transStoppedVelocity, "m/s",
       "lower speeds count as standing (RotateToGoal)"},
      {"xy_goal_tolerance", &P::xyGoalTolerance, "m",
       "distance to the goal within which the robot brakes and rotates (RotateToGoal)"},
      {"prune_plan", &P::prunesPlan, "", "removes poses of the path that the robot has passed",
       kUntilKilted},
      {"prune_distance", &P::pruneDistance, "m",
       "maximum distance of the path's first pose from the robot", kUntilKilted},
      {"forward_prune_distance", &P::forwardPruneDistance, "m",
       "distance ahead of the robot at which the path is cut", kUntilKilted},
      {"shorten_transformed_plan", &P::shortensPlan, "", "cuts the path at forward_prune_distance",
       kUntilKilted},
  };
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredDwbKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"debug_trajectory_details", "the log is not used: the window shows trajectories"},
      {"transform_tolerance", "TF is not used", kUntilKilted},
      {"publish_evaluation", "ROS topics are not used"},
      {"publish_global_plan", "ROS topics are not used", kUntilKilted},
      {"publish_transformed_plan", "ROS topics are not used", kUntilKilted},
      {"publish_local_plan", "ROS topics are not used"},
      {"publish_trajectories", "ROS topics are not used"},
      {"publish_cost_grid_pc", "ROS topics are not used"},
      {"marker_lifetime", "ROS topics are not used"},
      {"odom_topic", "ROS topics are not used", kUntilKilted},
      {"controller_frequency", "that of the server is used", kSinceLyrical},
      {"path_length_tolerance", "always 1 m, as in Nav2, whose name of this key lacks a dot",
       kSinceLyrical},
  };
  return kKeys;
}

/// Creates a DwbController from a block of parameters.
namespace {

using GeneratorKind = TrajectoryGenerator::Kind;
constexpr char kStandardGenerator[] = "dwb_plugins::StandardTrajectoryGenerator";
constexpr char kLimitedGenerator[] = "dwb_plugins::LimitedAccelGenerator";

std::vector<std::string> namespacesOf(const DwbParameters& parameters) {
  return parameters.criticNamespaces.empty() ? std::vector<std::string>{"dwb_critics"}
                                             : parameters.criticNamespaces;
}

/// The class of a critic: its key `class`, else its name.
std::string criticClass(const Nav2ParameterBlock& block, const std::string& name) {
  const auto given = block.find(name + ".class");
  const auto* text = given == block.end() ? nullptr : std::get_if<std::string>(&given->second);
  return text != nullptr ? *text : name;
}

/// Maximum number of poses of one trajectory.
double maxPoses(const DwbParameters& p) {
  const double speed =
      std::abs(p.maxVelX) + std::abs(p.minVelX) + std::abs(p.maxVelY) + std::abs(p.minVelY);
  return p.simTime * (1.0 / p.timeGranularity + speed / p.linearGranularity +
                      std::abs(p.maxVelTheta) / p.angularGranularity);
}

void checkWorkload(const DwbParameters& p, base::Diagnostics& problems) {
  constexpr double kMaxSteps = 10000.0, kMaxSamples = 100000.0;
  constexpr double kMaxPoses = 10000000.0;  // of all trajectories of a cycle
  const double steps = maxPoses(p);
  if (!(steps < kMaxSteps)) {
    problems.push_back(base::error("nav2.too-much-work",
                                   {"sim_time", p.simTime, "the granularities and velocities",
                                    std::round(steps), "poses of a trajectory", kMaxSteps}));
  }
  const std::pair<const char*, int> counts[] = {{"vx_samples", p.vxSamples},
                                                {"vy_samples", p.vySamples},
                                                {"vtheta_samples", p.vthetaSamples}};
  double samples = 1.0;
  auto most = counts[0];
  for (const auto& count : counts) {
    samples *= std::max(2, count.second);  // fewer are raised to 2
    most = count.second > most.second ? count : most;
  }
  if (samples > kMaxSamples) {
    problems.push_back(
        base::error("nav2.too-much-work", {most.first, most.second, "the samples of the other axes",
                                           samples, "trajectories", kMaxSamples}));
  } else if (steps < kMaxSteps && samples * steps > kMaxPoses) {
    problems.push_back(base::error("nav2.too-much-work",
                                   {"sim_time", p.simTime, "the granularities and samples",
                                    std::round(samples * steps), "poses in a cycle", kMaxPoses}));
  }
}

/// Limits that depend on several parameters are checked only if each of them is valid.
void checkDwbNumbers(const DwbParameters& p, base::Diagnostics& problems) {
  constexpr base::Range kFine{1e-4, 1000.0}, kFast{-1000.0, 1000.0};
  ParameterChecks checks(problems);
  bool areValid = checks.within("sim_time", p.simTime, kFine, "0.0001 to 1000 s");
  areValid &= checks.within("time_granularity", p.timeGranularity, kFine, "0.0001 to 1000 s");
  areValid &= checks.within("linear_granularity", p.linearGranularity, kFine, "0.0001 to 1000 m");
  areValid &=
      checks.within("angular_granularity", p.angularGranularity, kFine, "0.0001 to 1000 rad");
  areValid &= checks.within("min_vel_x", p.minVelX, kFast, "within 1000 m/s");
  areValid &= checks.within("max_vel_x", p.maxVelX, kFast, "within 1000 m/s");
  areValid &= checks.within("min_vel_y", p.minVelY, kFast, "within 1000 m/s");
  areValid &= checks.within("max_vel_y", p.maxVelY, kFast, "within 1000 m/s");
  areValid &= checks.within("max_vel_theta", p.maxVelTheta, kFast, "within 1000 rad/s");
  if (areValid) {
    checkWorkload(p, problems);
  }
}

GeneratorKind generatorKind(const std::string& name, base::Diagnostics& problems) {
  const std::string plugin = normalizedPluginClass(name);
  const std::vector<std::string> known = {kStandardGenerator, kLimitedGenerator};
  if (plugin != kStandardGenerator && plugin != kLimitedGenerator) {
    problems.push_back(isMisspelt(plugin, known)
                           ? unknownPlugin(name, known)
                           : base::warning("nav2.treated-as",
                                           {"trajectory_generator_name", name, kStandardGenerator,
                                            "its package is not re-implemented"}));
  }
  return plugin == kLimitedGenerator ? GeneratorKind::LimitedAccel : GeneratorKind::Standard;
}

/// The class that Nav2 looks up first: a bare name that is no critic of Nav2 belongs to the first
/// other namespace, if there is one.
std::string fullCriticName(const std::string& plugin, const DwbParameters& parameters) {
  if (plugin.find(':') != std::string::npos || plugin.find('/') != std::string::npos) {
    return plugin;
  }
  for (const std::string& space : namespacesOf(parameters)) {
    if (space != "dwb_critics") {
      return base::join({space, plugin}, "::");
    }
  }
  return "dwb_critics::" + plugin;
}

DwbController::NamedCritic makeCritic(const std::string& name, const ControllerSetup& setup,
                                      const DwbParameters& parameters,
                                      base::Diagnostics& problems) {
  const std::string plugin = criticClass(setup.block, name);
  const DwbCriticType* type = dwbCriticType(plugin, namespacesOf(parameters));
  if (type == nullptr) {
    std::vector<std::string> known;
    for (const DwbCriticType& each : dwbCriticTypes()) {
      known.emplace_back(each.plugin);
    }
    const std::string wanted = fullCriticName(plugin, parameters);
    problems.push_back(
        isMisspelt(wanted, known)
            ? unknownPlugin(wanted, known)
            : base::warning("nav2.left-out", {name, plugin, "its package is not re-implemented"}));
    return {name, nullptr};
  }
  const auto values = applyBlock(DwbCriticParameters(), type->keys, setup.block, setup.distro,
                                 problems, name + ".");
  if (values.aggregation != "last" && values.aggregation != "sum" &&
      values.aggregation != "product") {
    problems.push_back(base::error(
        "nav2.wrong-value",
        {name + ".aggregation_type", "'" + values.aggregation + "'", "last, sum or product"}));
  }
  constexpr double kMaxPointDistance = 1000.0;  // [m]
  ParameterChecks(problems, name + ".")
      .within("forward_point_distance", values.forwardPointDistance,
              {-kMaxPointDistance, kMaxPointDistance}, "within 1000 m");
  return {name, type->make({values, parameters, setup.distro})};
}

base::Result<std::unique_ptr<Controller>> makeDwb(const ControllerSetup& setup) {
  base::Diagnostics problems;
  DwbController::Setup made;
  made.parameters = applyBlock(DwbParameters(), dwbKeys(), setup.block, setup.distro, problems);
  made.distro = setup.distro;
  made.frequency = setup.frequency;
  if (setup.distro >= Distro::Lyrical) {
    DwbParameters& p = made.parameters;  // earlier branches use them unchanged
    invertPositiveDecelerations({{"decel_lim_x", &p.decelLimX},
                                 {"decel_lim_y", &p.decelLimY},
                                 {"decel_lim_theta", &p.decelLimTheta}},
                                problems);
  }
  checkDwbNumbers(made.parameters, problems);
  made.generator = generatorKind(made.parameters.generator, problems);
  if (setup.block.count("critics") == 0) {
    problems.push_back(base::error("nav2.missing-key", {"critics"}));
  }
  for (const std::string& name : made.parameters.critics) {
    DwbController::NamedCritic critic = makeCritic(name, setup, made.parameters, problems);
    if (critic.critic != nullptr) {
      made.critics.push_back(std::move(critic));
    }
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::make_unique<DwbController>(std::move(made)), std::move(problems)};
}

Nav2KeyTable dwbKeysOf(const Nav2ParameterBlock& given, Distro distro) {
  Nav2KeyTable keys = keyTableOf(dwbKeys(), DwbParameters(), ignoredDwbKeys());
  base::Diagnostics ignored;  // reported by makeDwb
  const auto parameters = applyBlock(DwbParameters(), dwbKeys(), given, distro, ignored);
  for (const std::string& name : parameters.critics) {
    keys.rows.push_back({name + ".class", Nav2Value(name), "", "class of the critic"});
    const DwbCriticType* type = dwbCriticType(criticClass(given, name), namespacesOf(parameters));
    if (type != nullptr) {
      addKeyRows(keys, type->keys, DwbCriticParameters(), name + ".");
    } else {
      keys.ignored.push_back({name + ".", "the critic is not re-implemented"});
    }
  }
  return keys;
}

}  // namespace

ControllerType dwbController() {
  return {"dwb_core::DWBLocalPlanner", dwbKeysOf, makeDwb};
}

}  // namespace sim2d::nav2

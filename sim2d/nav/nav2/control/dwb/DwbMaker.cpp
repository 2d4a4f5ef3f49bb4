#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/dwb/DwbController.h"
#include "sim2d/nav/nav2/control/dwb/VelocitySamples.h"

/// Makes a DwbController of a block of parameters.
namespace sim2d::nav2 {
namespace {

using GeneratorKind = TrajectoryGenerator::Kind;
constexpr char kStandardGenerator[] = "dwb_plugins::StandardTrajectoryGenerator";
constexpr char kLimitedGenerator[] = "dwb_plugins::LimitedAccelGenerator";

std::vector<std::string> namespacesOf(const DwbParameters& parameters) {
  return parameters.criticNamespaces.empty() ? std::vector<std::string>{"dwb_critics"}
                                             : parameters.criticNamespaces;
}

/// The class of a critic: its key `class`, else its name.
std::string criticClass(const Nav2Block& block, const std::string& name) {
  const auto given = block.find(name + ".class");
  const auto* text = given == block.end() ? nullptr : std::get_if<std::string>(&given->second);
  return text != nullptr ? *text : name;
}

/// At most, of one trajectory.
double stepsOf(const DwbParameters& p) {
  const double speed =
      std::abs(p.maxVelX) + std::abs(p.minVelX) + std::abs(p.maxVelY) + std::abs(p.minVelY);
  return p.simTime * (1.0 / p.timeGranularity + speed / p.linearGranularity +
                      std::abs(p.maxVelTheta) / p.angularGranularity);
}

void checkAmount(const DwbParameters& p, base::Diagnostics& problems) {
  constexpr double kMostSteps = 10000.0, kMostSamples = 100000.0;
  constexpr double kMostPoses = 10000000.0;  // of all trajectories of a cycle
  const double steps = stepsOf(p);
  if (!(steps < kMostSteps)) {
    problems.push_back(base::error("nav2.too-much-work",
                                   {"sim_time", p.simTime, "its granularities and velocities",
                                    std::round(steps), "poses of a trajectory", kMostSteps}));
  }
  const std::pair<const char*, int> counts[] = {{"vx_samples", p.vxSamples},
                                                {"vy_samples", p.vySamples},
                                                {"vtheta_samples", p.vthetaSamples}};
  double samples = 1.0;
  auto most = counts[0];
  for (const auto& count : counts) {
    samples *= std::max(2, count.second);  // fewer are none
    most = count.second > most.second ? count : most;
  }
  if (samples > kMostSamples) {
    problems.push_back(
        base::error("nav2.too-much-work", {most.first, most.second, "the samples of the other axes",
                                           samples, "trajectories", kMostSamples}));
  } else if (steps < kMostSteps && samples * steps > kMostPoses) {
    problems.push_back(base::error("nav2.too-much-work",
                                   {"sim_time", p.simTime, "its granularities and samples",
                                    std::round(samples * steps), "poses in a cycle", kMostPoses}));
  }
}

/// A number that must be in a range of its own, independent of the others.
struct DwbLimit {
  const char* key;
  double value, low, high;
  const char* wanted;
};

/// Limits that are computed from several numbers are only checked when each of them is valid.
void checkDwbNumbers(const DwbParameters& p, base::Diagnostics& problems) {
  constexpr double kFine = 1e-4, kFast = 1000.0;
  const DwbLimit limits[] = {
      {"sim_time", p.simTime, kFine, 1000.0, "0.0001 to 1000 s"},
      {"time_granularity", p.timeGranularity, kFine, 1000.0, "0.0001 to 1000 s"},
      {"linear_granularity", p.linearGranularity, kFine, 1000.0, "0.0001 to 1000 m"},
      {"angular_granularity", p.angularGranularity, kFine, 1000.0, "0.0001 to 1000 rad"},
      {"min_vel_x", p.minVelX, -kFast, kFast, "within 1000 m/s"},
      {"max_vel_x", p.maxVelX, -kFast, kFast, "within 1000 m/s"},
      {"min_vel_y", p.minVelY, -kFast, kFast, "within 1000 m/s"},
      {"max_vel_y", p.maxVelY, -kFast, kFast, "within 1000 m/s"},
      {"max_vel_theta", p.maxVelTheta, -kFast, kFast, "within 1000 rad/s"}};
  bool isSound = true;
  for (const DwbLimit& limit : limits) {
    if (!(limit.value >= limit.low && limit.value <= limit.high)) {
      problems.push_back(base::error("nav2.wrong-value", {limit.key, limit.value, limit.wanted}));
      isSound = false;
    }
  }
  if (isSound) {
    checkAmount(p, problems);
  }
}

/// Main turns them round; before, Nav2 takes them as they are.
void mendDecelerations(DwbParameters& p, base::Diagnostics& problems) {
  const std::pair<const char*, double*> limits[] = {{"decel_lim_x", &p.decelLimX},
                                                    {"decel_lim_y", &p.decelLimY},
                                                    {"decel_lim_theta", &p.decelLimTheta}};
  for (const auto& [key, limit] : limits) {
    if (*limit > 0.0) {
      problems.push_back(base::warning("nav2.positive-deceleration", {key, *limit}));
      *limit = -*limit;
    }
  }
}

GeneratorKind generatorKind(const std::string& name, base::Diagnostics& problems) {
  const std::string plugin = pluginName(name);
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

/// The class that Nav2 would look for first: a bare name of no critic of Nav2 lies in the first
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
  const auto values =
      filled(DwbCriticParameters(), type->keys, setup.block, setup.distro, problems, name + ".");
  if (values.aggregation != "last" && values.aggregation != "sum" &&
      values.aggregation != "product") {
    problems.push_back(base::error(
        "nav2.wrong-value",
        {name + ".aggregation_type", "'" + values.aggregation + "'", "last, sum or product"}));
  }
  constexpr double kFarthestPoint = 1000.0;  // [m]
  if (!(std::abs(values.forwardPointDistance) <= kFarthestPoint)) {
    problems.push_back(base::error(
        "nav2.wrong-value",
        {name + ".forward_point_distance", values.forwardPointDistance, "within 1000 m"}));
  }
  return {name, type->make({values, parameters, setup.distro})};
}

base::Result<std::unique_ptr<Controller>> makeDwb(const ControllerSetup& setup) {
  base::Diagnostics problems;
  DwbController::Setup made;
  made.parameters = filled(DwbParameters(), dwbKeys(), setup.block, setup.distro, problems);
  made.distro = setup.distro;
  made.frequency = setup.frequency;
  if (setup.distro >= Distro::Lyrical) {
    mendDecelerations(made.parameters, problems);
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

Nav2Keys dwbKeysOf(const Nav2Block& given, Distro distro) {
  Nav2Keys keys;
  addRows(keys, dwbKeys(), DwbParameters());
  addIdle(keys, dwbIdleKeys());
  base::Diagnostics ignored;  // the maker tells them
  const auto parameters = filled(DwbParameters(), dwbKeys(), given, distro, ignored);
  for (const std::string& name : parameters.critics) {
    keys.rows.push_back({name + ".class", Nav2Value(name), "", "class of the critic"});
    const DwbCriticType* type = dwbCriticType(criticClass(given, name), namespacesOf(parameters));
    if (type != nullptr) {
      addRows(keys, type->keys, DwbCriticParameters(), name + ".");
    }
  }
  return keys;
}

}  // namespace

void addDwb(ControllerRegistry& registry) {
  ControllerType type;
  type.plugin = "dwb_core::DWBLocalPlanner";
  type.help = "Tries velocities and takes the one whose trajectory its critics find cheapest.";
  type.keys = dwbKeysOf;
  type.make = makeDwb;
  registry.add(std::move(type));
}

}  // namespace sim2d::nav2

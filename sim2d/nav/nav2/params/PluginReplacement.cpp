#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <utility>
#include <variant>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/GoalCheckers.h"
#include "sim2d/nav/nav2/control/PathHandler.h"
#include "sim2d/nav/nav2/params/NodeReader.h"
#include "sim2d/nav/nav2/params/RosValue.h"
#include "sim2d/nav/nav2/params/ServerParameterReader.h"

namespace sim2d::nav2 {
namespace {

constexpr char kRotationShim[] = "nav2_rotation_shim_controller::RotationShimController";
constexpr char kOtherPackage[] = "its package is not re-implemented";

/// The value of a key if it has this type; null otherwise.
template <class T>
const T* valueAt(const Nav2ParameterBlock& block, const std::string& key) {
  const auto found = block.find(key);
  return found == block.end() ? nullptr : std::get_if<T>(&found->second);
}

std::optional<std::string> stringAt(const Nav2ParameterBlock& block, const std::string& key) {
  const auto* const text = valueAt<std::string>(block, key);
  return text != nullptr ? std::optional(*text) : std::nullopt;
}

std::vector<std::string> stringListAt(const Nav2ParameterBlock& block, const std::string& key,
                                      const std::string& defaults) {
  const auto* const names = valueAt<std::vector<std::string>>(block, key);
  return names != nullptr ? *names : std::vector<std::string>{defaults};
}

/// A string that replaces another value at its position in the file.
base::YamlNode stringNodeAt(const GivenParameter* given, const std::string& text, int line) {
  base::YamlNode node = base::stringNode(text);
  node.line = given != nullptr ? given->value->line : line;
  node.column = given != nullptr ? given->value->column : 0;
  return node;
}

void setPluginClass(NodeReader& node, const std::string& key, const std::string& substitute) {
  const GivenParameter* const given = node.parameters().find(key);
  base::YamlNode value = stringNodeAt(given, substitute, node.line());
  std::string file = given != nullptr ? given->file : node.parameters().file;
  node.markUsed(key);
  node.supply(key, std::move(value), std::move(file));
}

/// The absolute value of the first nonzero number among `keys`; marks its key as used.
std::optional<double> firstNumber(NodeReader& node, const std::string& prefix,
                                  const Nav2ParameterBlock& block,
                                  std::initializer_list<const char*> keys) {
  for (const char* const key : keys) {
    const double* const number = valueAt<double>(block, key);
    if (number != nullptr && std::isfinite(*number) && std::abs(*number) > 0.0) {
      node.markUsed(prefix + key);
      return std::abs(*number);
    }
  }
  return std::nullopt;
}

/// Limits of the replaced controller, all >= 0.
struct ControllerLimits {
  double maxForward = 0.5;           // maximum speed [m/s]
  double maxReverse = 0.0;           // maximum reverse speed [m/s]
  double maxAngular = 1.0;           // maximum angular speed [rad/s]
  double acceleration = 2.5;         // [m/s²]
  double angularAcceleration = 3.2;  // maximum angular acceleration [rad/s²]
  double turningRadius = 0.0;        // of a car [m]; 0: it can rotate in place
  double goalTolerance = 0.25;       // of the goal checker [m]
};

/// A re-implemented controller, and why it is the nearest one.
struct SubstituteController {
  std::string plugin;
  std::string why;
};

constexpr char kDwb[] = "dwb_core::DWBLocalPlanner";
constexpr char kMppi[] = "nav2_mppi_controller::MPPIController";
constexpr char kPursuit[] =
    "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController";
constexpr char kGraceful[] = "nav2_graceful_controller::GracefulController";

/// Part of a class name in lower case, and the controller it suggests.
struct NamePart {
  const char* part;
  const char* plugin;
  const char* why;
};
constexpr char kLimitsKept[] = "it is not re-implemented; the limits of velocity are kept";
constexpr char kKeysKept[] = "it is not re-implemented; the keys that both have are kept";
constexpr std::array<NamePart, 9> kNameParts = {{{"teb", kMppi, kLimitsKept},
                                                 {"mppi", kMppi, kKeysKept},
                                                 {"mpc", kMppi, kLimitsKept},
                                                 {"graceful", kGraceful, kKeysKept},
                                                 {"pursuit", kPursuit, kKeysKept},
                                                 {"stanley", kPursuit, kLimitsKept},
                                                 {"pathfollow", kPursuit, kLimitsKept},
                                                 {"path_follow", kPursuit, kLimitsKept},
                                                 {"dwb", kDwb, kKeysKept}}};

/// Builds a YAML map with one "key: value" per line.
class YamlLines {
 public:
  YamlLines& add(const char* key, double value) { return add(key, base::formatDecimals(value, 1)); }
  YamlLines& add(const char* key, int value) { return add(key, std::to_string(value)); }
  YamlLines& add(const char* key, const std::string& value) {
    text_ += std::string(key) + ": " + value + "\n";
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string dwbTemplate(const ControllerLimits& limits) {
  return YamlLines()
      .add("min_vel_x", -limits.maxReverse)
      .add("max_vel_x", limits.maxForward)
      .add("max_vel_theta", limits.maxAngular)
      .add("min_speed_xy", 0.0)
      .add("max_speed_xy", limits.maxForward)
      .add("min_speed_theta", 0.0)
      .add("acc_lim_x", limits.acceleration)
      .add("acc_lim_theta", limits.angularAcceleration)
      .add("decel_lim_x", -limits.acceleration)
      .add("decel_lim_theta", -limits.angularAcceleration)
      .add("vx_samples", 20)
      .add("vtheta_samples", 20)
      .add("sim_time", 1.7)
      .add("linear_granularity", 0.05)
      .add("angular_granularity", 0.025)
      .add("critics",
           "[RotateToGoal, Oscillation, BaseObstacle, GoalAlign, PathAlign, PathDist, GoalDist]")
      .add("BaseObstacle.scale", 0.02)
      .add("PathAlign.scale", 32.0)
      .add("PathAlign.forward_point_distance", 0.1)
      .add("GoalAlign.scale", 24.0)
      .add("GoalAlign.forward_point_distance", 0.1)
      .add("PathDist.scale", 32.0)
      .add("GoalDist.scale", 24.0)
      .add("RotateToGoal.scale", 32.0)
      .add("xy_goal_tolerance", base::formatDecimals(limits.goalTolerance, 1))
      .text();
}

/// The values of Nav2's example file, with steps no shorter than the controller's period.
std::string mppiTemplate(Distro distro, const ControllerLimits& limits, double rate) {
  constexpr double kStep = 0.05, kHorizon = 2.8;  // [s]
  constexpr int kMinSteps = 10, kMax = 100;
  const double step = rate > 0.0 ? std::max(kStep, 1.0 / rate) : kStep;
  const int steps = std::clamp(static_cast<int>(std::round(kHorizon / step)), kMinSteps, kMax);
  const bool isCar = limits.turningRadius > 0.0, isNew = distro >= Distro::Lyrical;
  YamlLines yaml;
  yaml.add("time_steps", steps)
      .add("model_dt", step)
      .add("batch_size", 2000)
      .add("vx_max", limits.maxForward)
      .add("vx_min", -limits.maxReverse)
      .add("wz_max", limits.maxAngular)
      .add("vx_std", std::max(0.1, 0.4 * limits.maxForward))
      .add("wz_std", std::max(0.2, 0.4 * limits.maxAngular));
  if (distro != Distro::Humble) {
    yaml.add("ax_max", limits.acceleration)
        .add("ax_min", -limits.acceleration)
        .add("az_max", limits.angularAcceleration);
  }
  if (isNew) {
    yaml.add("motion_model", isCar ? "ackermann" : "diff_drive");
  } else {
    yaml.add("motion_model", isCar ? "Ackermann" : "DiffDrive").add("prune_distance", 1.7);
  }
  if (isCar) {
    yaml.add(isNew ? "ackermann.min_turning_r" : "AckermannConstraints.min_turning_r",
             limits.turningRadius);
  }
  return yaml
      .add("critics",
           "[ConstraintCritic, CostCritic, GoalCritic, GoalAngleCritic, PathAlignCritic, "
           "PathFollowCritic, PathAngleCritic, PreferForwardCritic]")
      .text();
}

/// Selects by the name of the class: MPPI for TEB and other trajectory optimizers, Regulated Pure
/// Pursuit for variants of pure pursuit, Nav2's own controllers for their variants, DWB for all
/// others.
SubstituteController nearestController(const std::string& type) {
  std::string name = type;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  for (const NamePart& each : kNameParts) {
    if (name.find(each.part) != std::string::npos) {
      return {each.plugin, each.why};
    }
  }
  return {kDwb, kLimitsKept};
}

/// The controller's block as YAML, one line per key, with keys that `distro` reads; `rate`:
/// controller_frequency [Hz].
std::string controllerTemplate(const std::string& plugin, Distro distro,
                               const ControllerLimits& limits, double rate) {
  if (plugin == kDwb) {
    return dwbTemplate(limits);
  }
  if (plugin == kMppi) {
    return mppiTemplate(distro, limits, rate);
  }
  const bool isNew = distro >= Distro::Lyrical;
  if (plugin == kPursuit) {
    return YamlLines()
        .add(isNew ? "max_linear_vel" : "desired_linear_vel", limits.maxForward)
        .text();
  }
  return YamlLines()
      .add("v_linear_max", limits.maxForward)
      .add("v_angular_max", limits.maxAngular)
      .text();
}

/// Limits of a controller under the names of common packages.
ControllerLimits controllerLimits(NodeReader& node, const std::string& prefix,
                                  const Nav2ParameterBlock& block, const VelocityLimits& robot) {
  constexpr double kDefaultSpeed = 0.5, kDefaultAngularSpeed = 1.0, kMinSpeed = 0.05;
  constexpr double kDefaultAcceleration = 2.5, kDefaultAngularAcceleration = 3.2;
  const auto find = [&](std::initializer_list<const char*> keys) {
    return firstNumber(node, prefix, block, keys);
  };
  ControllerLimits limits;
  const auto maxForward =
      find({"max_vel_x", "vx_max", "desired_linear_vel", "max_linear_vel", "max_linear_velocity",
            "v_linear_max", "max_vel_trans", "max_speed_xy", "max_speed", "max_linear_speed",
            "linear_vel", "max_v", "v_max", "target_x_vel", "nominal_linear_vel", "max_velocity"});
  const auto maxAngular =
      find({"max_vel_theta", "wz_max", "max_angular_vel", "max_angular_velocity", "v_angular_max",
            "rotate_to_heading_angular_vel", "max_rotational_vel", "max_angular_speed",
            "angular_vel", "max_w", "w_max"});
  limits.maxForward =
      std::max(maxForward.value_or(robot.maxForward.value_or(kDefaultSpeed)), kMinSpeed);
  limits.maxAngular =
      std::max(maxAngular.value_or(robot.maxAngular.value_or(kDefaultAngularSpeed)), kMinSpeed);
  limits.maxReverse = std::min(
      find({"max_vel_x_backwards", "vx_min", "max_backward_vel"}).value_or(0.0), limits.maxForward);
  limits.acceleration =
      find({"acc_lim_x", "ax_max", "max_linear_accel", "max_linear_acceleration", "linear_acc"})
          .value_or(kDefaultAcceleration);
  limits.angularAcceleration =
      find({"acc_lim_theta", "az_max", "max_angular_accel", "max_angular_acceleration"})
          .value_or(kDefaultAngularAcceleration);
  limits.turningRadius = find({"min_turning_radius", "minimum_turning_radius"}).value_or(0.0);
  return limits;
}

/// Supplies the keys of a template that the file lacks and that `counts` accepts, at the line of
/// `key`, the replaced class.
void addTemplate(NodeReader& node, const std::string& prefix, const std::string& yaml,
                 const std::string& key, const std::function<bool(const std::string&)>& counts) {
  const GivenParameter* const given = node.parameters().find(key);
  const int line = given != nullptr ? given->value->line : node.line();
  const std::string file = given != nullptr ? given->file : node.parameters().file;
  base::Diagnostics problems;
  base::YamlNode tree = base::parseYaml(yaml, {}, problems);
  for (base::YamlNode& value : tree.items) {
    const std::string name = prefix + value.key;
    if (!node.has(name) && counts(name)) {
      value.line = line;
      value.column = 0;
      node.supply(name, std::move(value), file);
    }
  }
}

/// The tolerance of the first goal checker [m].
double goalToleranceOf(const Nav2ParameterBlock& server) {
  const std::vector<std::string> names =
      stringListAt(server, "goal_checker_plugins", "goal_checker");
  const auto* const tolerance =
      names.empty() ? nullptr : valueAt<double>(server, names.front() + ".xy_goal_tolerance");
  return tolerance != nullptr ? *tolerance : ControllerLimits().goalTolerance;
}

/// `prefix`: prefix of the controller's keys; `key`: the key of its class.
void replaceController(NodeReader& node, const std::string& name, const std::string& prefix,
                       const std::string& key, const std::string& type,
                       const VelocityLimits& robot) {
  const SubstituteController substitute = nearestController(type);
  const std::string owner = node.node() + "." + key.substr(0, key.rfind(".plugin"));
  node.report(key,
              base::warning("nav2.treated-as", {owner, type, substitute.plugin, substitute.why}));
  ControllerLimits limits = controllerLimits(node, prefix, node.given(prefix), robot);
  limits.goalTolerance = goalToleranceOf(node.given({}));
  setPluginClass(node, key, substitute.plugin);
  const Nav2ParameterBlock own = node.given(name + ".");
  const Nav2ParameterBlock frequency = node.given("controller_frequency");
  const double* const rate = valueAt<double>(frequency, "");
  const std::string yaml =
      controllerTemplate(substitute.plugin, node.distro(), limits, rate != nullptr ? *rate : 20.0);
  // Keys of critics have an effect when their critic is listed by the file or the template.
  addTemplate(node, prefix, yaml, key, [](const std::string&) { return true; });
  const std::string outer = stringAt(own, "plugin").value_or(substitute.plugin);
  const ControllerType* const known = findController(outer);
  if (known == nullptr) {
    return;
  }
  const Nav2KeyTable keys = known->keys(node.given(name + "."), node.distro());
  node.keepOnly(name + ".", keys, "a key of " + type);
  const auto isKey = [&](const std::string& path) {
    return keys.find(path.substr(name.size() + 1), node.distro()) != nullptr;
  };
  addTemplate(node, prefix, yaml, key, isKey);  // replaces values of a wrong type
}

void replaceControllers(NodeReader& node, const Nav2ParameterBlock& block,
                        const VelocityLimits& limits) {
  const std::vector<std::string> known = controllerPlugins();
  for (const std::string& name : stringListAt(block, "controller_plugins", "FollowPath")) {
    std::string key = base::join({name, "plugin"}, "."), prefix = base::join({name, ""}, ".");
    std::string type = stringAt(block, key).value_or("");
    if (normalizedPluginClass(type) == kRotationShim) {
      const bool isNested = node.distro() >= Distro::Lyrical;
      const std::string primary = base::join({name, "primary_controller"}, ".");
      key = isNested ? base::join({primary, "plugin"}, ".") : primary;
      prefix = isNested ? base::join({primary, ""}, ".") : prefix;
      type = stringAt(block, key).value_or("");
    }
    const bool isKnown = type.empty() || findController(type) != nullptr;
    if (!isKnown && !isMisspelt(type, known)) {
      replaceController(node, name, prefix, key, type, limits);
    }
  }
}

/// Replaces goal checkers, progress checkers and path handlers, whose keys have little effect.
void replaceCheckers(NodeReader& node, const Nav2ParameterBlock& block,
                     const std::vector<std::string>& names, const std::vector<std::string>& known,
                     const Nav2KeyTable& keys) {
  for (const std::string& name : names) {
    const std::string key = name + ".plugin";
    const std::string type = stringAt(block, key).value_or("");
    if (!type.empty()) {
      const std::string read = substituteClass(node, name, type, known, known.front(), keys);
      if (read != type) {
        setPluginClass(node, key, read);
      }
    }
  }
}

}  // namespace

VelocityLimits velocitySmootherLimits(const ParameterFile& file, const std::string& robot) {
  const NodeParameters smoother = file.parametersOf("velocity_smoother", robot);
  const GivenParameter* const given = smoother.find("max_velocity");
  const auto value =
      given == nullptr ? std::nullopt : toRosValue(*given->value, Nav2Value(std::vector<double>()));
  VelocityLimits limits;
  const auto* const numbers = value ? std::get_if<std::vector<double>>(&*value) : nullptr;
  if (numbers != nullptr && numbers->size() == 3) {
    limits.maxForward = (*numbers)[0] > 0.0 ? std::optional<double>((*numbers)[0]) : std::nullopt;
    limits.maxAngular = (*numbers)[2] > 0.0 ? std::optional<double>((*numbers)[2]) : std::nullopt;
  }
  return limits;
}

std::string substituteClass(NodeReader& node, const std::string& name, const std::string& type,
                            const std::vector<std::string>& known, const std::string& fallback,
                            const Nav2KeyTable& keys) {
  const bool isKnown =
      std::find(known.begin(), known.end(), normalizedPluginClass(type)) != known.end();
  if (isKnown || isMisspelt(type, known)) {
    return type;
  }
  reportSubstitute(node, name, type, fallback, kOtherPackage);
  node.keepOnly(name + ".", keys, "a key of " + type);
  return fallback;
}

void replaceControllerPlugins(NodeReader& node, const VelocityLimits& limits) {
  const Nav2ParameterBlock block = node.given({});
  replaceControllers(node, block, limits);
  const std::vector<std::string> checkers = goalCheckerPlugins();
  replaceCheckers(node, block, stringListAt(block, "goal_checker_plugins", "goal_checker"),
                  checkers, goalCheckerKeysOf(checkers.front()));
  std::vector<std::string> names =
      stringListAt(block, "progress_checker_plugins", "progress_checker");
  if (node.distro() == Distro::Humble) {
    names = {stringAt(block, "progress_checker_plugin").value_or("progress_checker")};
  }
  replaceCheckers(node, block, names, progressCheckerPlugins(),
                  keyTableOf(progressCheckerKeys(), ProgressCheckerParameters()));
  if (node.distro() >= Distro::Lyrical) {
    replaceCheckers(node, block, stringListAt(block, "path_handler_plugins", "PathHandler"),
                    {"nav2_controller::FeasiblePathHandler"},
                    keyTableOf(feasiblePathHandlerKeys(), PathPruning()));
  }
}

}  // namespace sim2d::nav2

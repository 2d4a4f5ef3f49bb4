#include "sim2d/nav/nav2/params/PluginReplacement.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <utility>
#include <variant>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/GoalChecker.h"
#include "sim2d/nav/nav2/control/PathHandler.h"
#include "sim2d/nav/nav2/control/ProgressChecker.h"
#include "sim2d/nav/nav2/params/PluginBlocks.h"
#include "sim2d/nav/nav2/params/PluginTemplates.h"
#include "sim2d/nav/nav2/params/RosValue.h"

namespace sim2d::nav2 {
namespace {

constexpr char kShim[] = "nav2_rotation_shim_controller::RotationShimController";
constexpr char kOtherPackage[] = "its package is not re-implemented";

std::optional<std::string> textAt(const Nav2Block& block, const std::string& key) {
  const auto found = block.find(key);
  const auto* const text =
      found == block.end() ? nullptr : std::get_if<std::string>(&found->second);
  return text != nullptr ? std::optional<std::string>(*text) : std::nullopt;
}

std::vector<std::string> listAt(const Nav2Block& block, const std::string& key,
                                const std::string& usual) {
  const auto found = block.find(key);
  const auto* const names =
      found == block.end() ? nullptr : std::get_if<std::vector<std::string>>(&found->second);
  return names != nullptr ? *names : std::vector<std::string>{usual};
}

/// A text that replaces another value of the file.
base::YamlNode textInPlaceOf(const GivenParameter* given, const std::string& text, int line) {
  base::YamlNode node = base::stringNode(text);
  node.line = given != nullptr ? given->value->line : line;
  node.column = given != nullptr ? given->value->column : 0;
  return node;
}

void putClass(NodeReader& node, const std::string& key, const std::string& substitute) {
  const GivenParameter* const given = node.parameters().find(key);
  base::YamlNode value = textInPlaceOf(given, substitute, node.line());
  node.markUsed(key);
  node.supply(key, std::move(value));
}

/// The first positive number among keys, and which key it is.
std::optional<double> numberOf(NodeReader& node, const std::string& prefix, const Nav2Block& block,
                               std::initializer_list<const char*> keys) {
  for (const char* const key : keys) {
    const auto found = block.find(key);
    if (found == block.end()) {
      continue;
    }
    const double* const number = std::get_if<double>(&found->second);
    if (number != nullptr && std::isfinite(*number) && std::abs(*number) > 0.0) {
      node.markUsed(prefix + key);
      return std::abs(*number);
    }
  }
  return std::nullopt;
}

/// Limits of a controller under the names that common packages use.
ReplacedLimits limitsOfBlock(NodeReader& node, const std::string& prefix, const Nav2Block& block,
                             const RobotLimits& robot) {
  constexpr double kUsualSpeed = 0.5, kUsualTurn = 1.0, kSlowest = 0.05;
  constexpr double kUsualAcceleration = 2.5, kUsualTurning = 3.2;
  const auto find = [&](std::initializer_list<const char*> keys) {
    return numberOf(node, prefix, block, keys);
  };
  ReplacedLimits limits;
  const auto ahead =
      find({"max_vel_x", "vx_max", "desired_linear_vel", "max_linear_vel", "max_linear_velocity",
            "v_linear_max", "max_vel_trans", "max_speed_xy", "max_speed", "max_linear_speed",
            "linear_vel", "max_v", "v_max", "target_x_vel", "nominal_linear_vel", "max_velocity"});
  const auto turn = find({"max_vel_theta", "wz_max", "max_angular_vel", "max_angular_velocity",
                          "v_angular_max", "rotate_to_heading_angular_vel", "max_rotational_vel",
                          "max_angular_speed", "angular_vel", "max_w", "w_max"});
  limits.ahead = std::max(ahead.value_or(robot.ahead.value_or(kUsualSpeed)), kSlowest);
  limits.turn = std::max(turn.value_or(robot.turn.value_or(kUsualTurn)), kSlowest);
  limits.back = std::min(find({"max_vel_x_backwards", "vx_min", "max_backward_vel"}).value_or(0.0),
                         limits.ahead);
  limits.acceleration =
      find({"acc_lim_x", "ax_max", "max_linear_accel", "max_linear_acceleration", "linear_acc"})
          .value_or(kUsualAcceleration);
  limits.turning =
      find({"acc_lim_theta", "az_max", "max_angular_accel", "max_angular_acceleration"})
          .value_or(kUsualTurning);
  limits.turningRadius = find({"min_turning_radius", "minimum_turning_radius"}).value_or(0.0);
  return limits;
}

/// The keys of a template that the file does not have, at the line of the replaced class, as far as
/// they count.
void addTemplate(NodeReader& node, const std::string& prefix, const std::string& yaml, int line,
                 const std::function<bool(const std::string&)>& counts) {
  base::Diagnostics problems;
  base::YamlNode tree = base::parseYaml(yaml, {}, problems);
  for (base::YamlNode& value : tree.items) {
    const std::string name = prefix + value.key;
    if (!node.has(name) && counts(name)) {
      value.line = line;
      value.column = 0;
      node.supply(name, std::move(value));
    }
  }
}

/// `prefix`: of the controller's keys; `key`: where its class is given.
void replaceController(NodeReader& node, const std::string& name, const std::string& prefix,
                       const std::string& key, const std::string& type, const RobotLimits& robot) {
  const ReplacedController substitute = nearestController(type);
  const std::string owner = node.node() + "." + key.substr(0, key.rfind(".plugin"));
  node.tell(key,
            base::warning("nav2.treated-as", {owner, type, substitute.plugin, substitute.why}));
  const GivenParameter* const given = node.parameters().find(key);
  const int line = given != nullptr ? given->value->line : node.line();
  const ReplacedLimits limits = limitsOfBlock(node, prefix, node.given(prefix), robot);
  putClass(node, key, substitute.plugin);
  const Nav2Block own = node.given(name + ".");
  const auto frequency = node.given("controller_frequency");
  const auto found = frequency.find("");
  const double* const rate =
      found == frequency.end() ? nullptr : std::get_if<double>(&found->second);
  const std::string yaml =
      templateOf(substitute.plugin, node.distro(), limits, rate != nullptr ? *rate : 20.0);
  // Keys of critics count when their critic is listed, by the file or by the template.
  addTemplate(node, prefix, yaml, line, [](const std::string&) { return true; });
  const std::string outer = textAt(own, "plugin").value_or(substitute.plugin);
  const ControllerType* const known = controllerRegistry().find(outer, node.distro());
  if (known == nullptr) {
    return;
  }
  const Nav2Keys keys = known->keys(node.given(name + "."), node.distro());
  node.keepOnly(name + ".", keys, "a key of " + type);
  const auto isKey = [&](const std::string& path) {
    return keys.find(path.substr(name.size() + 1), node.distro()) != nullptr;
  };
  addTemplate(node, prefix, yaml, line, isKey);  // replaces values of a wrong type
}

void replaceControllers(NodeReader& node, const Nav2Block& block, const RobotLimits& limits) {
  const std::vector<std::string> known = controllerRegistry().plugins(node.distro());
  for (const std::string& name : listAt(block, "controller_plugins", "FollowPath")) {
    std::string key = base::join({name, "plugin"}, "."), prefix = base::join({name, ""}, ".");
    std::string type = textAt(block, key).value_or("");
    if (pluginName(type) == kShim) {
      const bool isNested = node.distro() >= Distro::Lyrical;
      const std::string primary = base::join({name, "primary_controller"}, ".");
      key = isNested ? base::join({primary, "plugin"}, ".") : primary;
      prefix = isNested ? base::join({primary, ""}, ".") : prefix;
      type = textAt(block, key).value_or("");
    }
    const bool isKnown = type.empty() || controllerRegistry().find(type, node.distro()) != nullptr;
    if (!isKnown && !isMisspelt(type, known)) {
      replaceController(node, name, prefix, key, type, limits);
    }
  }
}

/// Goal checkers, progress checkers, path handlers: classes without keys of great effect.
void replaceSmall(NodeReader& node, const Nav2Block& block, const std::vector<std::string>& names,
                  const std::vector<std::string>& known, const Nav2Keys& keys) {
  for (const std::string& name : names) {
    const std::string key = name + ".plugin";
    const std::string type = textAt(block, key).value_or("");
    if (!type.empty()) {
      const std::string read = replacedClass(node, name, type, known, known.front(), keys);
      if (read != type) {
        putClass(node, key, read);
      }
    }
  }
}

}  // namespace

RobotLimits limitsOfSmoother(const ParameterFile& file, const std::string& robot) {
  const NodeParameters smoother = file.parametersOf("velocity_smoother", robot);
  const GivenParameter* const given = smoother.find("max_velocity");
  const auto value =
      given == nullptr ? std::nullopt : rosValue(*given->value, Nav2Value(std::vector<double>()));
  RobotLimits limits;
  const auto* const numbers = value ? std::get_if<std::vector<double>>(&*value) : nullptr;
  if (numbers != nullptr && numbers->size() == 3) {
    limits.ahead = (*numbers)[0] > 0.0 ? std::optional<double>((*numbers)[0]) : std::nullopt;
    limits.turn = (*numbers)[2] > 0.0 ? std::optional<double>((*numbers)[2]) : std::nullopt;
  }
  return limits;
}

std::string replacedClass(NodeReader& node, const std::string& name, const std::string& type,
                          const std::vector<std::string>& known, const std::string& fallback,
                          const Nav2Keys& keys) {
  const bool isKnown = std::find(known.begin(), known.end(), pluginName(type)) != known.end();
  if (isKnown || isMisspelt(type, known)) {
    return type;
  }
  tellSubstitute(node, name, type, fallback, kOtherPackage);
  node.keepOnly(name + ".", keys, "a key of " + type);
  return fallback;
}

void replaceControllerPlugins(NodeReader& node, const RobotLimits& limits) {
  const Nav2Block block = node.given({});
  replaceControllers(node, block, limits);
  const std::vector<std::string> checkers = goalCheckerPlugins(node.distro());
  replaceSmall(node, block, listAt(block, "goal_checker_plugins", "goal_checker"), checkers,
               goalCheckerKeysOf(checkers.front()));
  Nav2Keys progress, handler;
  addRows(progress, progressCheckerKeys(), ProgressCheckerParameters());
  addRows(handler, feasiblePathHandlerKeys(), FeasiblePathHandlerParameters());
  std::vector<std::string> names = listAt(block, "progress_checker_plugins", "progress_checker");
  if (node.distro() == Distro::Humble) {
    names = {textAt(block, "progress_checker_plugin").value_or("progress_checker")};
  }
  replaceSmall(node, block, names, progressCheckerPlugins(node.distro()), progress);
  if (node.distro() >= Distro::Lyrical) {
    replaceSmall(node, block, listAt(block, "path_handler_plugins", "PathHandler"),
                 {"nav2_controller::FeasiblePathHandler"}, handler);
  }
}

}  // namespace sim2d::nav2

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/control/ControllerServer.h"

/// Creates the controller server from the parameters of its node.
namespace sim2d::nav2 {
namespace {

constexpr char kFeasibleHandler[] = "nav2_controller::FeasiblePathHandler";

/// A kind of plugin that the server loads.
struct PluginSlot {
  std::vector<std::string> names;  // instance names
  std::string defaultName;         // the default of the list
  std::string defaultPlugin;       // default class of that instance
};

struct ServerSlots {
  PluginSlot controllers, goalCheckers, progressCheckers, pathHandlers;
};

ServerSlots slotsOf(const ControllerServerParameters& p, Distro distro) {
  ServerSlots slots;
  slots.controllers = {p.controllers, "FollowPath", "dwb_core::DWBLocalPlanner"};
  slots.goalCheckers = {p.goalCheckers, "goal_checker", "nav2_controller::SimpleGoalChecker"};
  slots.progressCheckers = {p.progressCheckers, "progress_checker",
                            "nav2_controller::SimpleProgressChecker"};
  if (distro == Distro::Humble) {
    slots.progressCheckers.names = {p.progressChecker};
  }
  if (distro >= Distro::Lyrical) {
    slots.pathHandlers = {p.pathHandlers, "PathHandler", kFeasibleHandler};
  }
  return slots;
}

/// The values given below a name.
Nav2ParameterBlock subBlock(const Nav2ParameterBlock& node, const std::string& name) {
  Nav2ParameterBlock block;
  const std::string prefix = name + ".";
  for (auto at = node.lower_bound(prefix); at != node.end() && base::startsWith(at->first, prefix);
       ++at) {
    block.emplace(at->first.substr(prefix.size()), at->second);
  }
  return block;
}

/// The class of an instance; empty: not given.
std::string pluginOf(const PluginSlot& slot, const std::string& name,
                     const Nav2ParameterBlock& block) {
  const auto given = block.find("plugin");
  if (given != block.end()) {
    const auto* text = std::get_if<std::string>(&given->second);
    return text != nullptr ? *text : "";
  }
  const bool isDefault = slot.names.size() == 1 && name == slot.defaultName;
  return isDefault ? slot.defaultPlugin : "";
}

/// Creates all instances of a slot by `make(plugin, name, block)`.
template <class T, class Make>
void makeSlot(const PluginSlot& slot, const Nav2ParameterBlock& node, base::Diagnostics& problems,
              ControllerServer::Named<T>& made, Make make) {
  for (const std::string& name : slot.names) {
    const Nav2ParameterBlock block = subBlock(node, name);
    const std::string plugin = pluginOf(slot, name, block);
    if (plugin.empty()) {
      problems.push_back(base::error("nav2.missing-key", {name + ".plugin"}));
      continue;
    }
    base::Result<std::unique_ptr<T>> one = make(plugin, name, block);
    for (const base::Diagnostic& problem : one.diagnostics()) {
      problems.push_back(base::withContext(name, problem));
    }
    if (one) {
      made[name] = *std::move(one);
    }
  }
}

base::Result<std::unique_ptr<PathHandler>> makePathHandler(const std::string& plugin,
                                                           const Nav2ParameterBlock& block) {
  if (normalizedPluginClass(plugin) != kFeasibleHandler) {
    return unknownPlugin(plugin, {kFeasibleHandler});
  }
  base::Diagnostics problems;
  const auto parameters = applyBlock(FeasiblePathHandlerParameters(), feasiblePathHandlerKeys(),
                                     block, Distro::Main, problems);
  if (base::hasErrors(problems)) {
    return problems;
  }
  return std::make_unique<PathHandler>(pruningOf(parameters));
}

/// Keys of the plugins of a slot; `keysOf(plugin, block)` returns those of one plugin.
template <class KeysOf>
void addSlotKeys(const PluginSlot& slot, const Nav2ParameterBlock& given, Nav2KeyTable& keys,
                 KeysOf keysOf) {
  for (const std::string& name : slot.names) {
    const Nav2ParameterBlock block = subBlock(given, name);
    const std::string plugin = pluginOf(slot, name, block);
    keys.rows.push_back({name + ".plugin", Nav2Value(plugin), "", "class of the plugin"});
    Nav2KeyTable inner = keysOf(plugin, block);
    for (Nav2KeyTable::Row& row : inner.rows) {
      row.name = name + "." + row.name;
      keys.rows.push_back(std::move(row));
    }
    for (Nav2KeyTable::Ignored& ignored : inner.ignored) {
      ignored.name = name + "." + ignored.name;
      keys.ignored.push_back(std::move(ignored));
    }
  }
}

/// Removes the problems that result from an invalid frequency.
base::Diagnostics withoutFrequencyProblems(base::Diagnostics problems) {
  problems.erase(std::remove_if(problems.begin(), problems.end(),
                                [](const base::Diagnostic& problem) {
                                  return problem.code == "nav2.mppi-period" ||
                                         problem.code == "nav2.mppi-no-shift";
                                }),
                 problems.end());
  return problems;
}

void makePlugins(const ServerSlots& slots, const Nav2ParameterBlock& node,
                 const ControllerSetup& common, ControllerServer::Setup& made,
                 base::Diagnostics& problems) {
  makeSlot(
      slots.controllers, node, problems, made.controllers,
      [&](const std::string& plugin, const std::string& name, const Nav2ParameterBlock& block) {
        ControllerSetup setup = common;
        setup.name = name;
        setup.block = block;
        return controllerRegistry().make(plugin, setup);
      });
  makeSlot(slots.goalCheckers, node, problems, made.goalCheckers,
           [&](const std::string& plugin, const std::string&, const Nav2ParameterBlock& block) {
             return makeGoalChecker(plugin, common.distro, block);
           });
  makeSlot(slots.progressCheckers, node, problems, made.progressCheckers,
           [&](const std::string& plugin, const std::string&, const Nav2ParameterBlock& block) {
             return makeProgressChecker(plugin, common.distro, block);
           });
  makeSlot(slots.pathHandlers, node, problems, made.pathHandlers,
           [](const std::string& plugin, const std::string&, const Nav2ParameterBlock& block) {
             return makePathHandler(plugin, block);
           });
}

}  // namespace

const std::vector<Nav2Key<ControllerServerParameters>>& controllerServerKeys() {
  using P = ControllerServerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"controller_frequency", &P::frequency, "Hz", "commands per second"},
      {"min_x_velocity_threshold", &P::minXVelocity, "m/s", "lower forward speeds count as 0"},
      {"min_y_velocity_threshold", &P::minYVelocity, "m/s", "lower lateral speeds count as 0"},
      {"min_theta_velocity_threshold", &P::minThetaVelocity, "rad/s",
       "lower turn rates count as 0"},
      {"failure_tolerance", &P::failureTolerance, "s",
       "maximum time without a valid command, during which the robot stands; 0: none, -1: "
       "unlimited"},
      {"costmap_update_timeout", &P::costmapUpdateTimeout, "s",
       "maximum wait for the costmap after it was cleared", kSinceJazzy},
      {"publish_zero_velocity", &P::publishesZeroVelocity, "",
       "sends zero velocity at the end of a goal"},
      {"progress_checker_plugin", &P::progressChecker, "", "name of the progress checker", kHumble},
      {"progress_checker_plugins", &P::progressCheckers, "", "names of the progress checkers",
       kSinceJazzy},
      {"goal_checker_plugins", &P::goalCheckers, "", "names of the goal checkers"},
      {"controller_plugins", &P::controllers, "", "names of the controllers"},
      {"path_handler_plugins", &P::pathHandlers, "", "names of the path handlers", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredControllerServerKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"speed_limit_topic", "speed filters set the limits directly"},
      {"odom_topic", "ROS topics are not used"},
      {"odom_duration", "the measured speed is that of the time step"},
      {"use_realtime_priority", "threads are not used"},
      {"action_server_result_timeout", "ROS actions are not used", kJazzy},
      {"introspection_mode", "ROS actions are not used"},
      {"enable_stamped_cmd_vel", "ROS topics are not used"},
      {"search_window", "only used for the feedback of the action", kSinceLyrical},
  };
  return kKeys;
}

Nav2KeyTable controllerServerNodeKeys(const Nav2ParameterBlock& given, Distro distro) {
  Nav2KeyTable keys;
  addKeyRows(keys, controllerServerKeys(), ControllerServerParameters());
  addIgnoredKeys(keys, ignoredControllerServerKeys());
  base::Diagnostics ignored;  // reported by makeControllerServer
  const ServerSlots slots = slotsOf(
      applyBlock(ControllerServerParameters(), controllerServerKeys(), given, distro, ignored),
      distro);
  addSlotKeys(slots.controllers, given, keys, [&](const std::string& plugin, const auto& block) {
    const ControllerType* type = controllerRegistry().find(plugin, distro);
    return type == nullptr ? Nav2KeyTable() : type->keys(block, distro);
  });
  addSlotKeys(slots.goalCheckers, given, keys,
              [](const std::string& plugin, const auto&) { return goalCheckerKeysOf(plugin); });
  addSlotKeys(slots.progressCheckers, given, keys, [](const std::string&, const auto&) {
    Nav2KeyTable inner;
    addKeyRows(inner, progressCheckerKeys(), ProgressCheckerParameters());
    return inner;
  });
  addSlotKeys(slots.pathHandlers, given, keys, [](const std::string&, const auto&) {
    Nav2KeyTable inner;
    addKeyRows(inner, feasiblePathHandlerKeys(), FeasiblePathHandlerParameters());
    return inner;
  });
  return keys;
}

base::Result<std::unique_ptr<ControllerServer>> makeControllerServer(const Nav2ParameterBlock& node,
                                                                     Distro distro,
                                                                     std::uint64_t seed,
                                                                     int robotId) {
  base::Diagnostics problems;
  ControllerServer::Setup made;
  made.distro = distro;
  made.parameters =
      applyBlock(ControllerServerParameters(), controllerServerKeys(), node, distro, problems);
  constexpr double kMaxFrequency = 1000.0;  // [Hz]
  const bool isRate = ParameterChecks(problems).within(
      "controller_frequency", made.parameters.frequency, {0.0, kMaxFrequency, true},
      "above 0, up to " + base::formatDouble(kMaxFrequency));
  if (!isRate) {
    made.parameters.frequency = 20.0;
  }
  ControllerSetup common;
  common.distro = distro;
  common.frequency = made.parameters.frequency;
  common.seed = seed;
  common.robotId = robotId;
  makePlugins(slotsOf(made.parameters, distro), node, common, made, problems);
  if (base::hasErrors(problems)) {
    return isRate ? problems : withoutFrequencyProblems(std::move(problems));
  }
  return {std::make_unique<ControllerServer>(std::move(made)), std::move(problems)};
}

}  // namespace sim2d::nav2

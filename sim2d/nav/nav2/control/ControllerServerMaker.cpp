#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/control/ControllerServer.h"

/// The controller server of the parameters of its node.
namespace sim2d::nav2 {
namespace {

constexpr char kFeasibleHandler[] = "nav2_controller::FeasiblePathHandler";

/// A kind of plugin that the server loads.
struct PluginSlot {
  std::vector<std::string> names;  // of the instances
  std::string defaultName;         // the list as it is without the key
  std::string defaultPlugin;       // which then need not be given
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

/// What is given below a name.
Nav2Block blockBelow(const Nav2Block& node, const std::string& name) {
  Nav2Block block;
  const std::string prefix = name + ".";
  for (auto at = node.lower_bound(prefix);
       at != node.end() && at->first.compare(0, prefix.size(), prefix) == 0; ++at) {
    block.emplace(at->first.substr(prefix.size()), at->second);
  }
  return block;
}

/// The class of an instance; empty: not told.
std::string pluginOf(const PluginSlot& slot, const std::string& name, const Nav2Block& block) {
  const auto given = block.find("plugin");
  if (given != block.end()) {
    const auto* text = std::get_if<std::string>(&given->second);
    return text != nullptr ? *text : "";
  }
  const bool isDefault = slot.names.size() == 1 && name == slot.defaultName;
  return isDefault ? slot.defaultPlugin : "";
}

/// Makes every instance of a slot by `make(plugin, name, block)`.
template <class T, class Make>
void makeSlot(const PluginSlot& slot, const Nav2Block& node, base::Diagnostics& problems,
              ControllerServer::Named<T>& made, Make make) {
  for (const std::string& name : slot.names) {
    const Nav2Block block = blockBelow(node, name);
    const std::string plugin = pluginOf(slot, name, block);
    if (plugin.empty()) {
      problems.push_back(base::error("nav2.missing-key", {name + ".plugin"}));
      continue;
    }
    base::Result<std::unique_ptr<T>> one = make(plugin, name, block);
    for (const base::Diagnostic& problem : one.diagnostics()) {
      problems.push_back(base::within(name, problem));
    }
    if (one) {
      made[name] = *std::move(one);
    }
  }
}

base::Result<std::unique_ptr<PathHandler>> makePathHandler(const std::string& plugin,
                                                           const Nav2Block& block) {
  if (pluginName(plugin) != kFeasibleHandler) {
    return unknownPlugin(plugin, {kFeasibleHandler});
  }
  base::Diagnostics problems;
  const auto parameters = filled(FeasiblePathHandlerParameters(), feasiblePathHandlerKeys(), block,
                                 Distro::Main, problems);
  if (base::hasErrors(problems)) {
    return problems;
  }
  return std::make_unique<PathHandler>(handlingOf(parameters));
}

/// Keys of the plugins of a slot; `keysOf(plugin, block)` tells those of one.
template <class KeysOf>
void addSlotKeys(const PluginSlot& slot, const Nav2Block& given, Nav2Keys& keys, KeysOf keysOf) {
  for (const std::string& name : slot.names) {
    const Nav2Block block = blockBelow(given, name);
    const std::string plugin = pluginOf(slot, name, block);
    keys.rows.push_back({name + ".plugin", Nav2Value(plugin), "", "class of the plugin"});
    Nav2Keys inner = keysOf(plugin, block);
    for (Nav2Keys::Row& row : inner.rows) {
      row.name = name + "." + row.name;
      keys.rows.push_back(std::move(row));
    }
    for (Nav2Keys::Idle& idle : inner.idle) {
      idle.name = name + "." + idle.name;
      keys.idle.push_back(std::move(idle));
    }
  }
}

/// Without the problems that plugins find with a frequency that is itself wrong.
base::Diagnostics withoutRates(base::Diagnostics problems) {
  problems.erase(std::remove_if(problems.begin(), problems.end(),
                                [](const base::Diagnostic& problem) {
                                  return problem.code == "nav2.mppi-period" ||
                                         problem.code == "nav2.mppi-no-shift";
                                }),
                 problems.end());
  return problems;
}

void makePlugins(const ServerSlots& slots, const Nav2Block& node, const ControllerSetup& common,
                 ControllerServer::Setup& made, base::Diagnostics& problems) {
  makeSlot(slots.controllers, node, problems, made.controllers,
           [&](const std::string& plugin, const std::string& name, const Nav2Block& block) {
             ControllerSetup setup = common;
             setup.name = name;
             setup.block = block;
             return controllerRegistry().make(plugin, setup);
           });
  makeSlot(slots.goalCheckers, node, problems, made.goalCheckers,
           [&](const std::string& plugin, const std::string&, const Nav2Block& block) {
             return makeGoalChecker(plugin, common.distro, block);
           });
  makeSlot(slots.progressCheckers, node, problems, made.progressCheckers,
           [&](const std::string& plugin, const std::string&, const Nav2Block& block) {
             return makeProgressChecker(plugin, common.distro, block);
           });
  makeSlot(slots.pathHandlers, node, problems, made.pathHandlers,
           [](const std::string& plugin, const std::string&, const Nav2Block& block) {
             return makePathHandler(plugin, block);
           });
}

}  // namespace

const std::vector<Nav2Key<ControllerServerParameters>>& controllerServerKeys() {
  using P = ControllerServerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"controller_frequency", &P::frequency, "Hz", "commands per second"},
      {"min_x_velocity_threshold", &P::minXVelocity, "m/s", "slower ahead counts as 0"},
      {"min_y_velocity_threshold", &P::minYVelocity, "m/s", "slower sideways counts as 0"},
      {"min_theta_velocity_threshold", &P::minThetaVelocity, "rad/s", "slower turning counts as 0"},
      {"failure_tolerance", &P::failureTolerance, "s",
       "so long it stands for want of a valid command; 0: not at all, -1: for ever"},
      {"costmap_update_timeout", &P::costmapUpdateTimeout, "s",
       "so long it waits for the costmap after a clear", kSinceJazzy},
      {"publish_zero_velocity", &P::publishesZeroVelocity, "", "stops at the end of a goal"},
      {"progress_checker_plugin", &P::progressChecker, "", "name of the progress checker", kHumble},
      {"progress_checker_plugins", &P::progressCheckers, "", "names of the progress checkers",
       kSinceJazzy},
      {"goal_checker_plugins", &P::goalCheckers, "", "names of the goal checkers"},
      {"controller_plugins", &P::controllers, "", "names of the controllers"},
      {"path_handler_plugins", &P::pathHandlers, "", "names of the path handlers", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<IdleKey>& controllerServerIdleKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"speed_limit_topic", "speed filters set limits here"},
      {"odom_topic", "no topics here"},
      {"odom_duration", "the measured speed is that of the step"},
      {"use_realtime_priority", "no threads here"},
      {"action_server_result_timeout", "no actions here", kJazzy},
      {"introspection_mode", "no actions here"},
      {"enable_stamped_cmd_vel", "no topics here"},
      {"search_window", "feedback of the action", kSinceLyrical},
  };
  return kKeys;
}

Nav2Keys controllerServerNodeKeys(const Nav2Block& given, Distro distro) {
  Nav2Keys keys;
  addRows(keys, controllerServerKeys(), ControllerServerParameters());
  addIdle(keys, controllerServerIdleKeys());
  base::Diagnostics ignored;  // the maker tells them
  const ServerSlots slots = slotsOf(
      filled(ControllerServerParameters(), controllerServerKeys(), given, distro, ignored), distro);
  addSlotKeys(slots.controllers, given, keys, [&](const std::string& plugin, const auto& block) {
    const ControllerType* type = controllerRegistry().find(plugin, distro);
    return type == nullptr ? Nav2Keys() : type->keys(block, distro);
  });
  addSlotKeys(slots.goalCheckers, given, keys,
              [](const std::string& plugin, const auto&) { return goalCheckerKeysOf(plugin); });
  addSlotKeys(slots.progressCheckers, given, keys, [](const std::string&, const auto&) {
    Nav2Keys inner;
    addRows(inner, progressCheckerKeys(), ProgressCheckerParameters());
    return inner;
  });
  addSlotKeys(slots.pathHandlers, given, keys, [](const std::string&, const auto&) {
    Nav2Keys inner;
    addRows(inner, feasiblePathHandlerKeys(), FeasiblePathHandlerParameters());
    return inner;
  });
  return keys;
}

base::Result<std::unique_ptr<ControllerServer>> makeControllerServer(const Nav2Block& node,
                                                                     Distro distro,
                                                                     std::uint64_t seed,
                                                                     int robotId) {
  base::Diagnostics problems;
  ControllerServer::Setup made;
  made.distro = distro;
  made.parameters =
      filled(ControllerServerParameters(), controllerServerKeys(), node, distro, problems);
  constexpr double kMostFrequency = 1000.0;  // [Hz]
  const bool isRate =
      made.parameters.frequency > 0.0 && made.parameters.frequency <= kMostFrequency;
  if (!isRate) {
    problems.push_back(
        base::error("nav2.wrong-value", {"controller_frequency", made.parameters.frequency,
                                         "above 0, up to " + base::formatDouble(kMostFrequency)}));
    made.parameters.frequency = 20.0;
  }
  ControllerSetup common;
  common.distro = distro;
  common.frequency = made.parameters.frequency;
  common.seed = seed;
  common.robotId = robotId;
  makePlugins(slotsOf(made.parameters, distro), node, common, made, problems);
  if (base::hasErrors(problems)) {
    return isRate ? problems : withoutRates(std::move(problems));
  }
  return {std::make_unique<ControllerServer>(std::move(made)), std::move(problems)};
}

}  // namespace sim2d::nav2

#include "bt/robot/FirstPlugins.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace bt {
namespace {

using sim2d::nav2::controllerValue;
using sim2d::nav2::Distro;
using sim2d::nav2::Nav2Parameters;
using PluginNames = std::vector<std::string>;

/// Whether a server finds the plugin; an empty name is that of the only one.
bool isLoadedPlugin(const PluginNames& loaded, const std::string& name) {
  return name.empty() ? loaded.size() == 1
                      : std::find(loaded.begin(), loaded.end(), name) != loaded.end();
}

PluginNames listOfController(const Nav2Parameters& parameters, const char* list,
                             const char* usual) {
  return controllerValue<PluginNames>(parameters, list, {usual});
}

PluginNames plannerNames(const Nav2Parameters& parameters) {
  PluginNames names;
  names.reserve(parameters.planners.size());
  for (const auto& [name, planner] : parameters.planners) {
    names.push_back(name);
  }
  return names;
}

/// A list of plugins, and the plugin that Nav2's own tree names; empty: none.
struct ListUse {
  const char* node;
  const char* list;
  const char* named;
  PluginNames loaded;
};

bool isReplaced(const ListUse& use) {
  return !use.loaded.empty() && !isLoadedPlugin(use.loaded, use.named);
}

std::vector<ListUse> listsOf(const Nav2Parameters& parameters) {
  const auto controller = [&](const char* list, const char* usual) {
    return listOfController(parameters, list, usual);
  };
  constexpr const char* kServer = "controller_server";
  std::vector<ListUse> lists = {
      {"planner_server", "planner_plugins", "GridBased", plannerNames(parameters)},
      {kServer, "controller_plugins", "FollowPath", controller("controller_plugins", "FollowPath")},
      {kServer, "goal_checker_plugins", "", controller("goal_checker_plugins", "goal_checker")}};
  if (parameters.distro != Distro::Humble) {  // which has one
    lists.push_back({kServer, "progress_checker_plugins", "",
                     controller("progress_checker_plugins", "progress_checker")});
  }
  if (parameters.distro >= Distro::Lyrical) {
    lists.push_back(
        {kServer, "path_handler_plugins", "", controller("path_handler_plugins", "PathHandler")});
  }
  return lists;
}

}  // namespace

std::string firstOf(const Nav2Parameters& parameters, const char* list, const char* usual) {
  const PluginNames names = listOfController(parameters, list, usual);
  return names.empty() ? std::string() : names.front();
}

RobotRequest withFirstPlugins(const Nav2Parameters& parameters, RobotAction action,
                              RobotRequest request) {
  const bool plans =
      action == RobotAction::ComputePath || action == RobotAction::ComputePathThroughPoses;
  if (!plans && action != RobotAction::FollowPath) {
    return request;
  }
  for (const ListUse& use : listsOf(parameters)) {
    const std::string list = use.list;
    if ((list == "planner_plugins") != plans) {
      continue;
    }
    std::string& name = list == "goal_checker_plugins"       ? request.goalChecker
                        : list == "progress_checker_plugins" ? request.progressChecker
                        : list == "path_handler_plugins"     ? request.pathHandler
                                                             : request.server;
    if (name == use.named && isReplaced(use)) {
      name = use.loaded.front();
    }
  }
  return request;
}

base::Diagnostics firstPluginWarnings(const Nav2Parameters& parameters) {
  base::Diagnostics warnings;
  if (parameters.isPartial) {
    return warnings;
  }
  for (const ListUse& use : listsOf(parameters)) {
    if (!isReplaced(use)) {
      continue;
    }
    const std::string named = use.named;
    const base::Diagnostic warning = base::warning(
        "nav2.first-plugin",
        {use.list, named.empty() ? "none of several" : "'" + named + "'", use.loaded.front()});
    warnings.push_back(withFilePosition(parameters, base::withContext(use.node, warning)));
  }
  return warnings;
}

}  // namespace bt

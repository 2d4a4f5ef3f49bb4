#pragma once

#include "sim2d/nav/nav2/params/NodeReader.h"

/// What files of branches before Humble and files for launch programs write otherwise. Private to
/// this folder.
namespace sim2d::nav2 {

/// In a node that has not been read yet, names of Eloquent, Foxy and Galactic are given their newer
/// names: `controller_plugin_ids` and `controller_plugin_types`, `goal_checker_plugin`,
/// `recovery_plugins`, `plugin_names` and `plugin_types` of costmaps, `obstacle_range` and
/// `raytrace_range` of sources. One warning (nav2.older-branch) lists them.
/// `isOld`: the file has a node that only those branches have (recoveries_server).
void readOldNames(NodeReader& node, bool isOld);

/// Lists of plugins that are placeholders, and empty lists of planners, controllers and their
/// checkers, get the plugins whose blocks are in the node, with a warning. An empty list without
/// blocks counts as absent.
void readMissingLists(NodeReader& node);

}  // namespace sim2d::nav2

#pragma once

#include "sim2d/nav/nav2/params/NodeReader.h"

/// Older spellings in files of branches before Humble, and plugin lists in files for launch
/// programs. Private to this folder.
namespace sim2d::nav2 {

/// Renames parameters of Eloquent, Foxy and Galactic in a node that has not been read yet:
/// `controller_plugin_ids` and `controller_plugin_types`, `goal_checker_plugin`,
/// `recovery_plugins`, `plugin_names` and `plugin_types` of costmaps, `obstacle_range` and
/// `raytrace_range` of sources. One warning (nav2.older-branch) lists them. `isPreHumble`: the file
/// has a node that only those branches have (recoveries_server).
void renameLegacyKeys(NodeReader& node, bool isPreHumble);

/// Fills plugin lists that are placeholders, and empty lists of planners, controllers and their
/// checkers, with the plugins whose blocks are in the node, with a warning. An empty list without
/// blocks counts as absent.
void fillMissingLists(NodeReader& node);

}  // namespace sim2d::nav2

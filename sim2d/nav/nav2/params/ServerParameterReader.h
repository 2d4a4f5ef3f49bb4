#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"
#include "sim2d/nav/nav2/params/Nav2Parameters.h"
#include "sim2d/nav/nav2/params/NodeReader.h"
#include "sim2d/nav/nav2/route/RouteParameters.h"

/// Reading of the nodes of a parameter file. Private to this folder. `reader` starts reading a node
/// of the file.
namespace sim2d::nav2 {

/// The node of a costmap with its layers and filters.
CostmapSettings readCostmap(NodeReader& node);

/// docking_server, following_server and waypoint_follower. Nodes that are absent from the file keep
/// their defaults.
void readDocking(Nav2Parameters& to, const std::function<NodeReader(const std::string&)>& reader,
                 const ParameterFile& file);

/// Behaviors, velocity smoother and collision monitor. Precondition: `to.frames` is set.
void readMotionServers(Nav2Parameters& to,
                       const std::function<NodeReader(const std::string&)>& reader,
                       const ParameterFile& file);

/// The node route_server with its plugins.
RouteSettings readRouteServer(NodeReader node);

/// Masks of costmap filters, as Nav2's nodes publish them. A filter subscribes to
/// `filter_info_topic`; a costmap_filter_info_server publishes the mask's scale and topic there; a
/// map_server (`filter_mask_server`) publishes the mask of `yaml_filename` on that topic.

/// Assigns to the filters of both costmaps the masks that nodes of the file publish on their
/// topics. A filter with its own `mask_file` keeps it.
void readMasks(Nav2Parameters& to, const std::function<NodeReader(const std::string&)>& reader,
               const ParameterFile& file);

/// Older spellings in files of branches before Humble, and plugin lists in files for launch
/// programs. Private to this folder.

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

/// Maximum velocities in `velocity_smoother`; none: the file has no such node.
struct VelocityLimits {
  std::optional<double> maxForward;  // [m/s]
  std::optional<double> maxAngular;  // [rad/s]
};
VelocityLimits velocitySmootherLimits(const ParameterFile& file, const std::string& robot);

/// Replaces plugins in a node controller_server that has not been read yet: each controller, goal
/// checker, progress checker and path handler whose class belongs to another package gets the
/// nearest class. Keys that both have keep their values. If a controller has none of the keys of
/// the nearest one, its limits of velocity and acceleration are taken from the names of common
/// packages (`max_vel_x`, `vx_max`, `desired_linear_vel` …), else from `limits`. Each replacement
/// is a warning (nav2.treated-as); a misspelt class is left to the reader.
void replaceControllerPlugins(NodeReader& node, const VelocityLimits& limits);

/// The class that is read instead of `type`: `type` itself when it is known or misspelt, else
/// `fallback`, with a warning; keys outside of `keys` are ignored.
std::string substituteClass(NodeReader& node, const std::string& name, const std::string& type,
                            const std::vector<std::string>& known, const std::string& fallback,
                            const Nav2KeyTable& keys);

}  // namespace sim2d::nav2

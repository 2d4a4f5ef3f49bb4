#pragma once

#include <string>

#include "bt/robot/NavigatorHost.h"
#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/params/Nav2Parameters.h"

/// Nav2's own tree names the planner GridBased, the controller FollowPath and no checkers. Files
/// with other plugins have a tree of their own. If that tree is unknown and Nav2's is used instead,
/// the first plugin of each list takes the place of one that the file does not have.
namespace bt {

/// The first plugin of a list of controller_server.
std::string firstOf(const sim2d::nav2::Nav2Parameters& parameters, const char* list,
                    const char* usual);

/// Replaces names in Nav2's own tree of plugins that the servers do not have.
RobotRequest withFirstPlugins(const sim2d::nav2::Nav2Parameters& parameters, RobotAction action,
                              RobotRequest request);

/// A warning for each list whose first plugin is used with Nav2's own tree.
base::Diagnostics firstPluginWarnings(const sim2d::nav2::Nav2Parameters& parameters);

}  // namespace bt

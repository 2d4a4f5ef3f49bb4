#pragma once

#include <optional>
#include <string>

#include "app/bridge/bag/Bag.h"
#include "sim2d/base/Result.h"
#include "sim2d/trace/RecordedPoints.h"
#include "sim2d/trace/Tracks.h"

namespace bridge {

/// The topics to use, by name; empty: chosen by type (`readBagTrace`).
struct BagTopicOptions {
  std::string people, robot, map;
};

/// Parses "people=/human_states,robot=/odom,map=/map", in any order. Other keys are errors.
base::Result<BagTopicOptions> parseBagTopicOptions(const std::string& text);

/// Whether the topic can be used: the user named it, or its type contains people, a robot or a map
/// and it has no other known purpose (costmaps), or it contains goals or obstacles.
bool isUsableTopic(const BagChannel& channel, const BagTopicOptions& use);

/// Reads a recording as a trace that can be evaluated.
///
/// People: hunav_msgs/Agents, otherwise people_msgs/People. The robot: hunav_msgs/Agent, otherwise
/// nav_msgs/Odometry, geometry_msgs/PoseStamped or PoseWithCovarianceStamped, otherwise the tf
/// frame base_footprint or base_link. Its goals: those of hunav_msgs/Agent, and /goal_pose. The
/// map: nav_msgs/OccupancyGrid, and /obstacles of hunavsim. Poses in other frames are transformed
/// to the map frame by tf if possible. `points` receives closest_obs of hunav_msgs. Samples with
/// numbers that are not finite are discarded with a warning.
///
/// A complete bag of hunavsim (`kRunMetadata`) yields the trace of its run: the bodies come from
/// /human_states and /robot_states, everything else from its metadata. If parts are missing, it is
/// read as a third-party recording, with a warning.
base::Result<sim2d::Trace> readBagTrace(const std::string& path, const BagTopicOptions& use,
                                        const sim2d::TrackOptions& options,
                                        sim2d::RecordedPoints* points = nullptr);

}  // namespace bridge

#pragma once

#include <optional>
#include <string>

#include "sim2d/base/Result.h"
#include "sim2d/trace/RecordedPoints.h"
#include "sim2d/trace/Tracks.h"

namespace bridge {

/// Which topics of a bag tell what; empty: the first of a type that does (`readBagTrace`).
struct BagUse {
  std::string people, robot, map;
};

/// "people=/human_states,robot=/odom,map=/map", in any order; others are errors.
base::Result<BagUse> parseBagUse(const std::string& text);

/// A recording of a run as a record that can be measured.
///
/// People: hunav_msgs/Agents, else people_msgs/People. The robot: hunav_msgs/Agent, else
/// nav_msgs/Odometry, geometry_msgs/PoseStamped or PoseWithCovarianceStamped, else the frame
/// base_footprint or base_link of tf; its goals: those of hunav_msgs/Agent, and /goal_pose. The
/// map: nav_msgs/OccupancyGrid, and /obstacles of a run of hunavsim. Poses in other frames than the
/// map's are transformed by tf where it connects the frames. `points`: takes closest_obs of
/// hunav_msgs. Samples with numbers that are not finite are left out, with a warning.
///
/// A bag of ours (`kRunMetadata`) that is used as it is gives the record of its run: all but the
/// bodies comes from its metadata, the bodies from /human_states and /robot_states. A bag of which
/// a part is missing is read as a recording of another program, with a warning.
base::Result<sim2d::Trace> readBagTrace(const std::string& path, const BagUse& use,
                                        const sim2d::TrackOptions& options,
                                        sim2d::RecordedPoints* points = nullptr);

}  // namespace bridge

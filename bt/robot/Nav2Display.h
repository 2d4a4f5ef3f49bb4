#pragma once

#include <cstdint>
#include <vector>

#include "sim2d/map/OccupancyGrid.h"
#include "sim2d/nav/Observation.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/costmap/LayeredCostmap.h"

/// Display data of Nav2's servers.
namespace bt {

std::vector<base::Vec2> pointsOf(const sim2d::nav2::Path& path);

/// A trajectory with its cost. Scores are scale * raw for each critic that was evaluated. Rejected
/// trajectories have infinite cost.
sim2d::Candidate toCandidate(const sim2d::nav2::EvaluatedTrajectory& trajectory);

/// A copy of a costmap that is renewed after each update.
class CostmapSnapshot {
 public:
  sim2d::CostGridPtr of(const sim2d::nav2::LayeredCostmap& costmap);

 private:
  sim2d::CostGridPtr copy_;
  std::int64_t updates_ = -1;  // update count of the costmap at the time of the copy
};

/// Nav2's frames: a robot's servers use its observation in the map or, for everything that moves
/// with the odometry, in the frame odom.

/// Converts an observation to the frame odom. Obstacles seen earlier keep their position there when
/// the localiser corrects map -> odom.
class OdomObservation {
 public:
  /// `inMap` must outlive the use of the result. If both frames coincide, the result is `inMap`
  /// itself. A scan is placed by the odometry at its time stamp.
  const sim2d::Observation& of(const sim2d::Observation& inMap);

 private:
  sim2d::Observation converted_;
  sim2d::LaserScan scan_;
};

/// Transforms points from a frame, given by its pose in the map, to the map.
void moveToMap(const base::Pose2& frame, std::vector<base::Vec2>& points);

/// Resamples a grid along the axes of a frame to a grid along the axes of the map that covers it; 0
/// outside. For the identity the grid itself is returned. For display.
sim2d::CostGridPtr costsInMap(const base::Pose2& frame, sim2d::CostGridPtr grid);

/// The masks of a costmap's enabled filters. `topSpeed`: of the robot [m/s], for limits in m/s.
std::vector<sim2d::MaskGrid> maskGrids(const sim2d::nav2::CostmapSettings& costmap,
                                       const sim2d::nav2::FilterMasks& masks, double topSpeed);

}  // namespace bt

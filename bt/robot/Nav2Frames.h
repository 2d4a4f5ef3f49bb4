#pragma once

#include <vector>

#include "sim2d/map/CostGrid.h"
#include "sim2d/nav/Observation.h"

/// Nav2's frames: the servers of a robot look at its observation in the map or, what moves with the
/// odometry, in the frame odom.
namespace bt {

/// An observation in the frame odom. Obstacles that were seen stay where they are in it when the
/// localiser corrects map -> odom.
class OdomObservation {
 public:
  /// `inMap` must live as long as the result is used. While both frames coincide the result is
  /// `inMap` itself. A scan is placed by the odometry at its time.
  const sim2d::Observation& of(const sim2d::Observation& inMap);

 private:
  sim2d::Observation converted_;
  sim2d::LaserScan scan_;
};

/// Points of a frame, given as its pose in the map, in the map.
void moveToMap(const base::Pose2& frame, std::vector<base::Vec2>& points);

/// Costs of a grid along the axes of a frame, sampled into a grid along the axes of the map that
/// holds all of it; 0 outside. An identity gives the grid itself. For display.
sim2d::CostGridPtr costsInMap(const base::Pose2& frame, sim2d::CostGridPtr grid);

}  // namespace bt

#pragma once

#include "sim2d/nav/nav2/control/Controller.h"
#include "sim2d/nav/nav2/costmap/FootprintCost.h"

namespace sim2d::nav2 {

/// What it means when the robot's centre lies off the map.
enum class OffMap { IsFree, IsCollision };

/// Whether the edges of the footprint at a pose meet an obstacle, or unknown space when the costmap
/// does not track that. Radius robots are tested by their polygon too.
inline bool isPoseInCollision(const ControlInput& input, const Pose2& pose, OffMap offMap) {
  if (!input.costmap.worldToCell(pose.position)) {
    return offMap == OffMap::IsCollision;
  }
  return isEdgeCollision(footprintCost(input.costmap, input.shape.vertices, pose),
                         input.shape.tracksUnknown);
}

/// Poses of the world seen from a pose; its sine and cosine are taken once.
class RobotFrame {
 public:
  explicit RobotFrame(const Pose2& robot) : robot_(robot), axis_(robot.direction()) {}
  Pose2 toLocal(const Pose2& pose) const {
    const Vec2 offset = pose.position - robot_.position;
    return {Vec2(axis_.dot(offset), base::cross(axis_, offset)),
            base::angleDiff(pose.heading, robot_.heading)};
  }

 private:
  Pose2 robot_;
  Vec2 axis_;
};

}  // namespace sim2d::nav2

#include "bt/human/Perception.h"

#include <cmath>
#include <limits>

namespace bt {

using base::Pose2;
using base::Vec2;
using sim2d::WorldView;

double bearingOf(const Vec2& point, const Pose2& observer) {
  const Vec2 offset = point - observer.position;
  if (offset.isZero(0.0)) {
    return 0.0;
  }
  return base::angleDiff(base::headingOf(offset), observer.heading);
}

double robotDistance(const WorldView& view, int human) {
  const int robot = view.nearestRobot(human);
  if (robot < 0) {
    return std::numeric_limits<double>::infinity();
  }
  return (view.robotPose(robot).position - view.pose(human).position).norm();
}

namespace {

bool isVisible(const WorldView& view, int observer, const Vec2& place, double distance,
               double halfView) {
  const Pose2 pose = view.pose(observer);
  return (place - pose.position).norm() <= distance &&
         std::fabs(bearingOf(place, pose)) <= halfView && view.isVisible(pose.position, place);
}

}  // namespace

bool isRobotVisible(const WorldView& view, AgentIndex human, double distance) {
  const int robot = view.nearestRobot(human);
  return robot >= 0 &&
         isVisible(view, human, view.robotPose(robot).position, distance, kDefaultHalfView);
}

bool isAgentVisible(const WorldView& view, AgentIndex observer, AgentIndex target, double distance,
                    double halfView) {
  return isVisible(view, observer, view.pose(target).position, distance, halfView);
}

bool isRobotFacing(const WorldView& view, AgentIndex human) {
  const int robot = view.nearestRobot(human);
  return robot >= 0 &&
         std::fabs(bearingOf(view.pose(human).position, view.robotPose(robot))) < kFacingAngle;
}

bool isAudible(const WorldView& view, int listener, int speaker, double distance) {
  return agentDistance(view, listener, speaker) <= distance &&
         view.isVisible(view.pose(speaker).position, view.pose(listener).position);
}

double agentDistance(const WorldView& view, int from, int to) {
  return (view.pose(to).position - view.pose(from).position).norm();
}

int nearestAgent(const WorldView& view, int human) {
  int nearest = -1;
  double shortest = std::numeric_limits<double>::infinity();
  for (int other = 0; other < view.humanCount(); ++other) {
    if (other == human || !view.isPresent(other)) {
      continue;
    }
    const double distance = agentDistance(view, human, other);
    const bool isTie = distance == shortest && nearest >= 0 &&
                       view.constants(other).id < view.constants(nearest).id;
    if (distance < shortest || isTie) {
      nearest = other;
      shortest = distance;
    }
  }
  return nearest;
}

}  // namespace bt

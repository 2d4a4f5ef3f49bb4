#include "sim2d/nav/PassiveSafety.h"

#include <algorithm>

#include "sim2d/nav/DriveKinematics.h"
#include "sim2d/nav/FootprintGap.h"

namespace sim2d {
namespace {

constexpr double kSpeedFractions[] = {1.0, 0.75, 0.5, 0.25};
constexpr double kSameGap = 1e-9;  // [m]
constexpr int kMaxBrakingSteps = 1000;

/// Poses at the end of each step until the robot stands still.
std::vector<Pose2> brakingPoses(const RobotBody& body, const Observation& observation,
                                const BodyTwist& twist) {
  const double dt = observation.dt;
  std::vector<Pose2> poses;
  BodyTwist now = reached(body, observation.motion, twist, dt);
  Pose2 pose = observation.pose;
  for (int step = 0; step < kMaxBrakingSteps && now != BodyTwist{}; ++step) {
    pose = propagated(pose, now, dt);
    poses.push_back(pose);
    now = reached(body, now, BodyTwist{}, dt);
  }
  return poses;
}

/// Largest displacement from `start` [m].
double maxDisplacement(const std::vector<Pose2>& poses, const Vec2& start) {
  double farthest = 0.0;
  for (const Pose2& pose : poses) {
    farthest = std::max(farthest, (pose.position - start).norm());
  }
  return farthest;
}

bool keepsClearOfBody(const TrackedBody& other, const RobotBody& body,
                      const Observation& observation, const std::vector<Pose2>& poses,
                      double margin) {
  double time = 0.0;
  for (const Pose2& pose : poses) {
    time += observation.dt;
    const Vec2 place = other.position + time * other.velocity;
    const double gap = gapToDisc(body.footprint, pose, place, other.radius);
    if (gap < margin &&
        gap < gapToDisc(body.footprint, observation.pose, place, other.radius) - kSameGap) {
      return false;
    }
  }
  return true;
}

bool keepsClearOfWalls(const RobotBody& body, const Observation& observation,
                       const std::vector<Pose2>& poses, double margin, double room) {
  const Obstacles& walls = *observation.obstacles;
  if (walls.clearance(observation.pose.position, room) >= room) {
    return true;
  }
  const double now = gapToWalls(body.footprint, observation.pose, walls, room);
  const double least = std::min(margin, now - kSameGap);
  return std::all_of(poses.begin(), poses.end(), [&](const Pose2& pose) {
    return gapToWalls(body.footprint, pose, walls, room) >= least;
  });
}

}  // namespace

bool isPassivelySafe(const RobotBody& body, const Observation& observation, const BodyTwist& twist,
                     double margin) {
  const std::vector<Pose2> poses = brakingPoses(body, observation, twist);
  const double time = static_cast<double>(poses.size()) * observation.dt;
  const Vec2& start = observation.pose.position;
  const double room = circumscribedRadius(body.footprint) + maxDisplacement(poses, start) + margin;
  for (const TrackedBody& other : observation.bodies) {
    const double near = room + other.radius + time * other.velocity.norm();
    if ((other.position - start).squaredNorm() < near * near &&
        !keepsClearOfBody(other, body, observation, poses, margin)) {
      return false;
    }
  }
  return keepsClearOfWalls(body, observation, poses, margin, room);
}

BodyTwist nearestSafeTwist(const RobotBody& body, const Observation& observation,
                           const BodyTwist& wanted, double margin) {
  const BodyTwist full = reached(body, observation.motion, wanted, observation.dt);
  const BodyTwist turning{0.0, wanted.angular, 0.0};
  const BodyTwist slow = reached(body, observation.motion, turning, observation.dt);
  for (const double share : kSpeedFractions) {
    const BodyTwist tried{slow.linear + share * (full.linear - slow.linear),
                          slow.angular + share * (full.angular - slow.angular),
                          slow.lateral + share * (full.lateral - slow.lateral)};
    if (isPassivelySafe(body, observation, tried, margin)) {
      return tried;
    }
  }
  return isPassivelySafe(body, observation, slow, margin) ? slow : BodyTwist{};
}

}  // namespace sim2d

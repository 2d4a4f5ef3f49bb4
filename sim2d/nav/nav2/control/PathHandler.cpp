#include "sim2d/nav/nav2/control/PathHandler.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"

namespace sim2d::nav2 {
namespace {

constexpr char kNoPlan[] = "Received plan with zero length";
constexpr char kUnitPlan[] = "Received plan with length of one";
constexpr char kNothingLeft[] = "Resulting plan has 0 poses in it.";

double stepLength(const Path& path, std::size_t from) {
  return (path[from + 1].position - path[from].position).norm();
}

Path::difference_type offsetOf(std::size_t index) {
  return static_cast<Path::difference_type>(index);
}

void eraseBefore(Path& path, std::size_t begin) {
  path.erase(path.begin(), std::next(path.begin(), offsetOf(begin)));
}

/// Poses from `begin` to before the first one farther than `most` [m] from the robot.
Path posesWithin(const Path& path, std::size_t begin, const Vec2& robot, double most) {
  std::size_t end = begin;
  while (end < path.size() && !((path[end].position - robot).norm() > most)) {
    ++end;
  }
  return {std::next(path.begin(), offsetOf(begin)), std::next(path.begin(), offsetOf(end))};
}

/// Index of the first pose after the first turn in place by at least `angle` [rad]; the path's size
/// if there is none.
std::size_t firstAfterTurn(const Path& path, double angle) {
  constexpr double kSpot = 1e-4;  // [m]
  for (std::size_t begin = 0; begin + 1 < path.size(); ++begin) {
    double turned = 0.0;
    std::size_t end = begin;
    while (end + 1 < path.size() && stepLength(path, end) < kSpot) {
      turned += std::abs(base::angleDiff(path[end + 1].heading, path[end].heading));
      ++end;
    }
    if (end > begin && turned >= angle) {
      return end + 1;
    }
    begin = end;
  }
  return path.size();
}

}  // namespace

double pathLength(const Path& path) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    length += stepLength(path, i);
  }
  return length;
}

std::size_t firstAfterDistance(const Path& path, std::size_t begin, double distance) {
  double length = 0.0;
  for (std::size_t i = begin; i + 1 < path.size(); ++i) {
    length += stepLength(path, i);
    if (length > distance) {
      return i + 1;
    }
  }
  return path.size();
}

std::size_t firstAfterInversion(const Path& path) {
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Vec2 before = path[i].position - path[i - 1].position;
    const Vec2 after = path[i + 1].position - path[i].position;
    if (before.dot(after) < 0.0) {
      return i + 1;
    }
  }
  return path.size();
}

double halfExtent(const Costmap& costmap) {
  const int cells = std::max(costmap.width(), costmap.height());
  return (cells - 1 + 0.5) * costmap.resolution() / 2.0;
}

void PathHandler::setPlan(const Path& plan) {
  remainingPlan_ = plan;
  truncateAtConstraint();
}

void PathHandler::truncateAtConstraint() {
  plan_ = remainingPlan_;
  std::size_t end = remainingPlan_.size();
  if (pruning_.enforcesInversion) {
    end = firstAfterInversion(remainingPlan_);
  }
  if (pruning_.enforcesRotation) {
    end = std::min(end, firstAfterTurn(remainingPlan_, pruning_.minimumRotation));
  }
  constraint_ = end < remainingPlan_.size() ? end : 0;
  plan_.resize(end);
}

bool PathHandler::isAtConstraint(const Pose2& robot) const {
  const Pose2& end = plan_.back();
  return (robot.position - end.position).norm() <= pruning_.inversionXyTolerance &&
         std::abs(base::angleDiff(robot.heading, end.heading)) <= pruning_.inversionYawTolerance;
}

/// As in Nav2 the robot's pose is transformed into the frame of the plan, and the pruned plan into
/// that of the costmap.
LocalPlan PathHandler::localPlan(const Pose2& robotInCostmap, const Costmap& costmap,
                                 const Pose2& planFrame) {
  if (plan_.empty()) {
    return {{}, kNoPlan};
  }
  if (pruning_.rejectsUnitPath && plan_.size() == 1) {
    return {{}, kUnitPlan};
  }
  const Pose2 robot = toFrame(planFrame, robotInCostmap);
  LocalPlan local;
  switch (pruning_.rule) {
    case PathPruning::Rule::Pursuit:
      local = pursuitPlan(robot, costmap);
      break;
    case PathPruning::Rule::Dwb:
      local = dwbPlan(robot, costmap);
      break;
    case PathPruning::Rule::AlongPath:
      local = alongPathPlan(robot, costmap, planFrame);
      break;
  }
  if (local.poses.empty()) {
    local.problem = kNothingLeft;
  }
  for (Pose2& pose : local.poses) {
    pose = toParent(planFrame, pose);
  }
  return local;
}

LocalPlan PathHandler::localPlan(const ControlInput& input) {
  return input.localPlan != nullptr ? LocalPlan{*input.localPlan}
                                    : localPlan(input.robot, input.costmap, input.planFrame);
}

std::size_t PathHandler::nearest(const Pose2& robot, const Costmap& costmap) const {
  double within = pruning_.searchDistance;
  if (within < 0.0) {
    within = std::numeric_limits<double>::infinity();
  } else if (within == 0.0) {
    within = halfExtent(costmap);
  }
  const std::size_t end = firstAfterDistance(plan_, 0, within);
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < end; ++i) {
    const double distance = (plan_[i].position - robot.position).norm();
    if (distance <= least) {  // the last of equal distances
      least = distance;
      best = i;
    }
  }
  const bool isLast = best + 1 == end;
  return pruning_.keepsLastTwo && isLast && best > 0 ? best - 1 : best;
}

LocalPlan PathHandler::pursuitPlan(const Pose2& robot, const Costmap& costmap) {
  const std::size_t begin = nearest(robot, costmap);
  LocalPlan local{posesWithin(plan_, begin, robot.position, halfExtent(costmap))};
  eraseBefore(plan_, begin);
  return local;
}

LocalPlan PathHandler::dwbPlan(const Pose2& robot, const Costmap& costmap) {
  const double half = std::max(costmap.width(), costmap.height()) * costmap.resolution() / 2.0;
  const double near = pruning_.prunesPlan ? std::min(half, pruning_.pruneDistance) : half;
  const double far = pruning_.shortensPlan ? std::min(half, pruning_.forwardPruneDistance) : half;
  const std::size_t last = firstAfterDistance(plan_, 0, pruning_.forwardPruneDistance);
  std::size_t begin = 0;
  while (begin < last && !((plan_[begin].position - robot.position).norm() < near)) {
    ++begin;
  }
  LocalPlan local{posesWithin(plan_, begin, robot.position, far)};
  if (pruning_.prunesPlan) {
    eraseBefore(plan_, begin);
  }
  return local;
}

LocalPlan PathHandler::alongPathPlan(const Pose2& robot, const Costmap& costmap,
                                     const Pose2& planFrame) {
  const std::size_t begin = nearest(robot, costmap);
  std::size_t end = begin;
  for (const std::size_t last = firstAfterDistance(plan_, begin, pruning_.pruneDistance);
       end < last && costmap.worldToCell(toParent(planFrame, plan_[end]).position); ++end) {
  }
  LocalPlan local{
      {std::next(plan_.begin(), offsetOf(begin)), std::next(plan_.begin(), offsetOf(end))}};
  eraseBefore(plan_, begin);
  if (constraint_ != 0 && isAtConstraint(robot)) {
    eraseBefore(remainingPlan_, constraint_);
    truncateAtConstraint();
  }
  return local;
}

const std::vector<Nav2Key<PathPruning>>& feasiblePathHandlerKeys() {
  using P = PathPruning;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"max_robot_pose_search_dist", &P::searchDistance, "m",
       "length of the path that is searched for the robot; 0: half the costmap, negative: all",
       kSinceLyrical},
      {"prune_distance", &P::pruneDistance, "m", "length of the path that is used", kSinceLyrical},
      {"enforce_path_inversion", &P::enforcesInversion, "",
       "the path is cut at its first cusp until the robot reaches it", kSinceLyrical},
      {"enforce_path_rotation", &P::enforcesRotation, "",
       "the path is cut at its first rotation in place until the robot has completed it",
       kSinceLyrical},
      {"minimum_rotation_angle", &P::minimumRotation, "rad", "minimum angle of a rotation in place",
       kSinceLyrical},
      {"inversion_xy_tolerance", &P::inversionXyTolerance, "m", "position tolerance at the cusp",
       kSinceLyrical},
      {"inversion_yaw_tolerance", &P::inversionYawTolerance, "rad", "heading tolerance at the cusp",
       kSinceLyrical},
      {"reject_unit_path", &P::rejectsUnitPath, "", "rejects a path of one pose", kSinceLyrical},
  };
  return kKeys;
}

namespace {

/// The nearest point of a segment as a fraction of its length.
double shareOf(const Vec2& from, const Vec2& along, const Vec2& place) {
  const double length = along.squaredNorm();
  return length > 0.0 ? std::clamp((place - from).dot(along) / length, 0.0, 1.0) : 0.0;
}

double lengthFrom(const Path& path, std::size_t segment, double share) {
  double length = 0.0;
  for (std::size_t i = segment; i + 1 < path.size(); ++i) {
    const double whole = (path[i + 1].position - path[i].position).norm();
    length += i == segment ? (1.0 - share) * whole : whole;
  }
  return length;
}

}  // namespace

TrackingFeedback trackingError(const Path& path, const Pose2& robot, std::size_t first,
                               double window) {
  TrackingFeedback feedback;
  if (path.empty()) {
    return feedback;
  }
  feedback.distanceToGoal = (path.back().position - robot.position).norm();
  feedback.positionError = (path.front().position - robot.position).norm();
  feedback.headingError = base::wrapToPi(path.front().heading - robot.heading);
  double nearest = std::numeric_limits<double>::infinity();
  double share = 0.0, way = 0.0;
  for (std::size_t i = first; i + 1 < path.size(); ++i) {
    const Vec2 from = path[i].position, along = path[i + 1].position - from;
    const double part = shareOf(from, along, robot.position);
    const Vec2 off = robot.position - (from + part * along);
    if (off.norm() < nearest) {
      nearest = off.norm();
      share = part;
      feedback.index = i;
      const double side = along.x() * off.y() - along.y() * off.x();
      feedback.positionError = side < 0.0 ? -nearest : nearest;
      const double heading =
          along.squaredNorm() > 0.0 ? base::atan2(along.y(), along.x()) : path[i].heading;
      feedback.headingError = base::wrapToPi(heading - robot.heading);
    }
    way += along.norm();
    if (window >= 0.0 && way > window) {
      break;
    }
  }
  feedback.remaining = lengthFrom(path, feedback.index, share);
  return feedback;
}

}  // namespace sim2d::nav2

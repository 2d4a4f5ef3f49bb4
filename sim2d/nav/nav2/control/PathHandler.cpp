#include "sim2d/nav/nav2/control/PathHandler.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

#include "sim2d/nav/nav2/control/Controller.h"

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

/// From `begin` to before the first pose farther than `most` [m] from the robot.
Path untilFar(const Path& path, std::size_t begin, const Vec2& robot, double most) {
  std::size_t end = begin;
  while (end < path.size() && !((path[end].position - robot).norm() > most)) {
    ++end;
  }
  return {std::next(path.begin(), offsetOf(begin)), std::next(path.begin(), offsetOf(end))};
}

/// The first pose after the first turn on the spot by at least `angle` [rad]; its size: none.
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
  rest_ = plan;
  cutAtConstraint();
}

void PathHandler::cutAtConstraint() {
  plan_ = rest_;
  std::size_t end = rest_.size();
  if (handling_.enforcesInversion) {
    end = firstAfterInversion(rest_);
  }
  if (handling_.enforcesRotation) {
    end = std::min(end, firstAfterTurn(rest_, handling_.minimumRotation));
  }
  constraint_ = end < rest_.size() ? end : 0;
  plan_.resize(end);
}

bool PathHandler::isAtConstraint(const Pose2& robot) const {
  const Pose2& end = plan_.back();
  return (robot.position - end.position).norm() <= handling_.inversionXyTolerance &&
         std::abs(base::angleDiff(robot.heading, end.heading)) <= handling_.inversionYawTolerance;
}

/// As in Nav2 the robot's pose is transformed into the frame of the plan, and what is cut of the
/// plan into that of the costmap.
LocalPlan PathHandler::localPlan(const Pose2& robotInCostmap, const Costmap& costmap,
                                 const Pose2& planFrame) {
  if (plan_.empty()) {
    return {{}, kNoPlan};
  }
  if (handling_.rejectsUnitPath && plan_.size() == 1) {
    return {{}, kUnitPlan};
  }
  const Pose2 robot = toFrame(planFrame, robotInCostmap);
  LocalPlan local;
  switch (handling_.rule) {
    case PathHandling::Rule::Pursuit:
      local = pursuitPlan(robot, costmap);
      break;
    case PathHandling::Rule::Dwb:
      local = dwbPlan(robot, costmap);
      break;
    case PathHandling::Rule::Way:
      local = wayPlan(robot, costmap, planFrame);
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
  double within = handling_.searchDistance;
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
    if (distance <= least) {  // of equal ones the last
      least = distance;
      best = i;
    }
  }
  const bool isLast = best + 1 == end;
  return handling_.keepsTwo && isLast && best > 0 ? best - 1 : best;
}

LocalPlan PathHandler::pursuitPlan(const Pose2& robot, const Costmap& costmap) {
  const std::size_t begin = nearest(robot, costmap);
  LocalPlan local{untilFar(plan_, begin, robot.position, halfExtent(costmap))};
  eraseBefore(plan_, begin);
  return local;
}

LocalPlan PathHandler::dwbPlan(const Pose2& robot, const Costmap& costmap) {
  const double half = std::max(costmap.width(), costmap.height()) * costmap.resolution() / 2.0;
  const double near = handling_.prunesPlan ? std::min(half, handling_.pruneDistance) : half;
  const double far = handling_.shortensPlan ? std::min(half, handling_.forwardPruneDistance) : half;
  const std::size_t last = firstAfterDistance(plan_, 0, handling_.forwardPruneDistance);
  std::size_t begin = 0;
  while (begin < last && !((plan_[begin].position - robot.position).norm() < near)) {
    ++begin;
  }
  LocalPlan local{untilFar(plan_, begin, robot.position, far)};
  if (handling_.prunesPlan) {
    eraseBefore(plan_, begin);
  }
  return local;
}

LocalPlan PathHandler::wayPlan(const Pose2& robot, const Costmap& costmap, const Pose2& planFrame) {
  const std::size_t begin = nearest(robot, costmap);
  std::size_t end = begin;
  for (const std::size_t last = firstAfterDistance(plan_, begin, handling_.pruneDistance);
       end < last && costmap.worldToCell(toParent(planFrame, plan_[end]).position); ++end) {
  }
  LocalPlan local{
      {std::next(plan_.begin(), offsetOf(begin)), std::next(plan_.begin(), offsetOf(end))}};
  eraseBefore(plan_, begin);
  if (constraint_ != 0 && isAtConstraint(robot)) {
    eraseBefore(rest_, constraint_);
    cutAtConstraint();
  }
  return local;
}

const std::vector<Nav2Key<FeasiblePathHandlerParameters>>& feasiblePathHandlerKeys() {
  using P = FeasiblePathHandlerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"max_robot_pose_search_dist", &P::searchDistance, "m",
       "length of path searched for the robot; 0: half the costmap, negative: all", kSinceLyrical},
      {"prune_distance", &P::pruneDistance, "m", "length of path that is used", kSinceLyrical},
      {"enforce_path_inversion", &P::enforcesInversion, "",
       "the path ends at its first cusp until the robot is there", kSinceLyrical},
      {"enforce_path_rotation", &P::enforcesRotation, "",
       "the path ends at its first turn on the spot until the robot has made it", kSinceLyrical},
      {"minimum_rotation_angle", &P::minimumRotation, "rad", "least angle of a turn on the spot",
       kSinceLyrical},
      {"inversion_xy_tolerance", &P::inversionXyTolerance, "m", "tolerance at the cusp",
       kSinceLyrical},
      {"inversion_yaw_tolerance", &P::inversionYawTolerance, "rad", "idem, heading", kSinceLyrical},
      {"reject_unit_path", &P::rejectsUnitPath, "", "refuse a path of one pose", kSinceLyrical},
  };
  return kKeys;
}

PathHandling handlingOf(const FeasiblePathHandlerParameters& parameters) {
  PathHandling handling;
  handling.rule = PathHandling::Rule::Way;
  handling.searchDistance = parameters.searchDistance;
  handling.pruneDistance = parameters.pruneDistance;
  handling.keepsTwo = true;
  handling.enforcesInversion = parameters.enforcesInversion;
  handling.enforcesRotation = parameters.enforcesRotation;
  handling.minimumRotation = parameters.minimumRotation;
  handling.inversionXyTolerance = parameters.inversionXyTolerance;
  handling.inversionYawTolerance = parameters.inversionYawTolerance;
  handling.rejectsUnitPath = parameters.rejectsUnitPath;
  return handling;
}

}  // namespace sim2d::nav2

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "sim2d/nav/nav2/mppi/MppiCriticRound.h"
#include "sim2d/nav/nav2/mppi/MppiCritics.h"

namespace sim2d::nav2 {
namespace {

float criticFloat(double value) {
  return static_cast<float>(value);
}

}  // namespace

bool MppiCritics::askConstraint(Round& round) {
  using Model = ConstraintProblem::Model;
  const CriticSettings& settings = settings_.constraint;
  if (!settings.isEnabled) {
    return false;
  }
  ConstraintProblem problem;
  problem.low = limits_.low[0];
  problem.high = limits_.high[0];
  problem.lateral = limits_.high[2];
  problem.turningRadius = limits_.turningRadius;
  problem.dt = dt_;
  if (motion_ == MppiMotion::Ackermann) {
    problem.model = Model::Ackermann;
  } else if (motion_ == MppiMotion::Omni && distro_ >= Distro::Lyrical) {
    problem.model = Model::LinearAndLateral;
  } else if (motion_ == MppiMotion::Omni) {
    problem.model = Model::Planar;
  }
  if (distro_ < Distro::Lyrical) {  // vy_max counts for every motion model, also without a vy
    const float back = std::sqrt(problem.low * problem.low + problem.lateral * problem.lateral);
    problem.low = problem.low > 0.0F ? back : -back;
    problem.high = std::sqrt(problem.high * problem.high + problem.lateral * problem.lateral);
  }
  kernel_.constraint(problem, round.batch, sinkOf(round, settings));
  return true;
}

bool MppiCritics::askGoal(Round& round) {
  const GoalSettings& settings = settings_.goal;
  if (!settings.isEnabled || !isNear(round.scene, settings.threshold)) {
    return false;
  }
  kernel_.goal(pathX_.back(), pathY_.back(), round.batch, sinkOf(round, settings));
  return true;
}

bool MppiCritics::askGoalAngle(Round& round) {
  const GoalAngleSettings& settings = settings_.goalAngle;
  if (!settings.isEnabled || !isNear(round.scene, settings.threshold)) {
    return false;
  }
  const float yaw =
      distro_ == Distro::Humble ? pathYaw_.back() : criticFloat(round.scene.goal.heading);
  kernel_.goalAngle(yaw, settings.isSymmetric, round.batch, sinkOf(round, settings));
  return true;
}

/// The path point from which on blocked ones are counted: Humble begins at that nearest to the
/// first place of the trajectories.
int MppiCritics::firstCounted(const Round& round) const {
  if (distro_ != Distro::Humble) {
    return 0;
  }
  int first = 0;
  float least = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < pathX_.size(); ++i) {
    const float dx = pathX_[i] - round.columns.x.front();
    const float dy = pathY_[i] - round.columns.y.front();
    const float distance2 = dx * dx + dy * dy;
    if (distance2 < least) {
      least = distance2;
      first = static_cast<int>(i);
    }
  }
  return first;
}

bool MppiCritics::isTooOccupied(Round& round, int reached) {
  const int first = firstCounted(round);
  const auto range = static_cast<float>(reached - first);
  float blocked = 0.0F;
  for (int i = first; i < reached; ++i) {
    blocked += isValid(round, i) ? 0.0F : 1.0F;
    if (blocked > 2.0F && blocked / range > criticFloat(settings_.pathAlign.mostOccupied)) {
      return true;
    }
  }
  return false;
}

bool MppiCritics::askPathAlign(Round& round) {
  const PathAlignSettings& settings = settings_.pathAlign;
  if (!settings.isEnabled || isNear(round.scene, settings.threshold)) {
    return false;
  }
  const int reached = reachedBy(round);
  if (reached < std::max(settings.offsetFromFurthest, 1) || isTooOccupied(round, reached)) {
    return false;
  }
  isValid(round, 0);  // found by now, also where Humble has counted none
  alignWay_.assign(pathWay_.begin(), pathWay_.begin() + reached);
  alignWay_.push_back(std::numeric_limits<float>::infinity());
  AlignProblem problem;
  problem.path.x = pathX_.data();
  problem.path.y = pathY_.data();
  problem.path.yaw = pathYaw_.data();
  problem.path.way = alignWay_.data();
  problem.path.valid = valid_.data();
  problem.path.count = reached;
  problem.pointStep = settings.pointStep;
  problem.usesOrientations = settings.usesOrientations;
  kernel_.align(problem, round.batch, sinkOf(round, settings));
  return true;
}

bool MppiCritics::askPathFollow(Round& round) {
  const PathFollowSettings& settings = settings_.pathFollow;
  if (!settings.isEnabled || pathX_.size() < 2 || isNear(round.scene, settings.threshold)) {
    return false;
  }
  const int last = static_cast<int>(pathX_.size()) - 1;
  int point = std::min(reachedBy(round) + settings.offsetFromFurthest, last);
  while (point < last - 1 && !isValid(round, point)) {
    ++point;
  }
  const auto at = static_cast<std::size_t>(point);
  kernel_.follow(pathX_[at], pathY_[at], round.batch, sinkOf(round, settings));
  return true;
}

bool MppiCritics::askPathAngle(Round& round) {
  using Mode = AngleProblem::Mode;
  const PathAngleSettings& settings = settings_.pathAngle;
  if (!settings.isEnabled || isNear(round.scene, settings.threshold)) {
    return false;
  }
  const bool isHumble = distro_ == Distro::Humble;
  auto mode = static_cast<Mode>(isHumble ? (settings.isForwardPreferred ? 0 : 1) : settings.mode);
  if (mode == Mode::EitherEnd && std::abs(limits_.low[0]) < 1e-6F) {
    mode = Mode::Forward;  // it cannot go back
  }
  const int last = static_cast<int>(pathX_.size()) - 1;
  const auto at =
      static_cast<std::size_t>(std::min(reachedBy(round) + settings.offsetFromFurthest, last));
  const Pose2& point = round.scene.path[at];
  const double angle =
      mode == Mode::AlongPath
          ? posePointAngle(round.scene.robot, point.position, point.heading)
          : posePointAngle(round.scene.robot, point.position, mode == Mode::Forward);
  if (angle < settings.mostAngle) {
    return false;
  }
  AngleProblem problem;
  problem.mode = mode;
  problem.isMean = isHumble;
  problem.x = pathX_[at];
  problem.y = pathY_[at];
  problem.yaw = pathYaw_[at];
  kernel_.angle(problem, round.batch, sinkOf(round, settings));
  return true;
}

bool MppiCritics::askPreferForward(Round& round) {
  const PreferForwardSettings& settings = settings_.preferForward;
  if (!settings.isEnabled || isNear(round.scene, settings.threshold)) {
    return false;
  }
  kernel_.forward(dt_, round.batch, sinkOf(round, settings));
  return true;
}

bool MppiCritics::askTwirling(Round& round) {
  const TwirlingSettings& settings = settings_.twirling;
  const Pose2& end = distro_ == Distro::Humble ? round.scene.path.back() : round.scene.goal;
  const double tolerance = round.scene.xyGoalTolerance;
  const double distance2 = (end.position - round.scene.robot.position).squaredNorm();
  if (!settings.isEnabled || distance2 < tolerance * tolerance) {
    return false;
  }
  kernel_.twirling(round.batch, sinkOf(round, settings));
  return true;
}

bool MppiCritics::askDeadband(Round& round) {
  const DeadbandSettings& settings = settings_.deadband;
  if (!settings.isEnabled) {
    return false;
  }
  DeadbandProblem problem;
  constexpr std::size_t kOrder[kTrajectoryAxes] = {0, 2, 1};  // the key has vx, vy, wz
  for (std::size_t axis = 0; axis < kTrajectoryAxes; ++axis) {
    problem.deadband[axis] = std::abs(criticFloat(settings.velocities[kOrder[axis]]));
  }
  problem.isHolonomic = motion_ == MppiMotion::Omni;
  problem.dt = dt_;
  kernel_.deadband(problem, round.batch, sinkOf(round, settings));
  return true;
}

}  // namespace sim2d::nav2

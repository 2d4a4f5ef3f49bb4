#include "sim2d/nav/nav2/control/PathGoalCheckers.h"

#include <cmath>
#include <cstddef>

#include "sim2d/base/Math.h"

namespace sim2d::nav2 {
namespace {

/// The unit vector of the path's end; the goal's heading without a path.
Vec2 endDirection(const GoalQuery& query, double distance, Distro distro) {
  const Path* const path = query.localPath;
  if (path != nullptr && path->size() >= 2) {
    std::size_t before = path->size() - 2;
    const auto length = [&](std::size_t i) {
      return (query.goal.position - (*path)[i].position).norm();
    };
    while (distro == Distro::Main && before > 0 && length(before) < distance) {
      --before;
    }
    if (length(before) > 0.0) {
      return (query.goal.position - (*path)[before].position) / length(before);
    }
  }
  return base::directionOf(query.goal.heading);
}

class AxisGoalChecker final : public GoalChecker {
 public:
  AxisGoalChecker(const AxisGoalParameters& parameters, Distro distro)
      : parameters_(parameters), distro_(distro) {}

  void reset() override {}
  bool isGoalReached(const GoalQuery& query) override { return isXyReached(query); }
  bool isXyReached(const GoalQuery& query) override {
    if (query.pathLength > parameters_.pathLengthTolerance) {
      return false;
    }
    const Vec2 direction = endDirection(query, parameters_.directionDistance, distro_);
    const Vec2 offset = query.robot.position - query.goal.position;
    const double along = direction.dot(offset);  // beyond the goal is positive
    const double across = direction.x() * offset.y() - direction.y() * offset.x();
    const double ahead = parameters_.isOvershootValid ? -along : std::abs(along);
    return ahead < parameters_.alongTolerance && std::abs(across) < parameters_.acrossTolerance;
  }
  double xyTolerance() const override { return parameters_.alongTolerance; }
  double yawTolerance() const override { return base::kPi; }

 private:
  AxisGoalParameters parameters_;
  Distro distro_;
};

class AdaptiveGoalChecker final : public GoalChecker {
 public:
  explicit AdaptiveGoalChecker(const AdaptiveGoalParameters& parameters)
      : parameters_(parameters) {}

  void reset() override {
    isLatched_ = false;
    stagnant_ = 0;
  }
  bool isGoalReached(const GoalQuery& query) override {
    if (!isLatched_) {
      countStagnation(query);
    }
    if (!isXyReached(query)) {
      return false;
    }
    isLatched_ = isLatched_ || parameters_.isStateful;
    const double turn = std::abs(base::angleDiff(query.goal.heading, query.robot.heading));
    const double tolerance = parameters_.yawTolerance;
    return turn <= tolerance || (parameters_.isSymmetric && base::kPi - turn <= tolerance);
  }
  bool isXyReached(const GoalQuery& query) override {
    if (query.pathLength > parameters_.pathLengthTolerance) {
      return false;
    }
    return isLatched_ || distanceOf(query) <= parameters_.fineTolerance ||
           (distanceOf(query) <= parameters_.coarseTolerance &&
            stagnant_ >= parameters_.stagnationCycles);
  }
  double xyTolerance() const override { return parameters_.coarseTolerance; }
  double yawTolerance() const override { return parameters_.yawTolerance; }

 private:
  static double distanceOf(const GoalQuery& query) {
    return (query.robot.position - query.goal.position).norm();
  }
  /// Checks in a row in which the robot stood within the coarse tolerance.
  void countStagnation(const GoalQuery& query) {
    const bool isStopped =
        std::abs(query.speed.angular) <= parameters_.rotStoppedVelocity &&
        Vec2(query.speed.linear, query.speed.lateral).norm() <= parameters_.transStoppedVelocity;
    const bool isNear = distanceOf(query) <= parameters_.coarseTolerance;
    stagnant_ = isStopped && isNear ? stagnant_ + 1 : 0;
  }

  AdaptiveGoalParameters parameters_;
  bool isLatched_ = false;
  int stagnant_ = 0;
};

}  // namespace

const std::vector<Nav2Key<AxisGoalParameters>>& axisGoalKeys() {
  using P = AxisGoalParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"along_path_tolerance", &P::alongTolerance, "m", "tolerance along the end of the path",
       kSinceLyrical},
      {"cross_track_tolerance", &P::acrossTolerance, "m", "tolerance across it", kSinceLyrical},
      {"path_length_tolerance", &P::pathLengthTolerance, "m",
       "the goal is not reached while more of the local path is left", kSinceLyrical},
      {"is_overshoot_valid", &P::isOvershootValid, "", "a place beyond the goal counts as reached",
       kSinceLyrical},
      {"direction_estimation_distance", &P::directionDistance, "m",
       "length of the path's end that gives its direction", kMain},
  };
  return kKeys;
}

const std::vector<Nav2Key<AdaptiveGoalParameters>>& adaptiveGoalKeys() {
  using P = AdaptiveGoalParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"fine_xy_goal_tolerance", &P::fineTolerance, "m", "distance that counts as reached",
       kSinceLyrical},
      {"coarse_xy_goal_tolerance", &P::coarseTolerance, "m",
       "distance that counts as reached for a robot that stands", kSinceLyrical},
      {"required_stagnation_cycles", &P::stagnationCycles, "",
       "checks in a row for which it must stand", kSinceLyrical},
      {"yaw_goal_tolerance", &P::yawTolerance, "rad", "how far from the goal's heading is right",
       kSinceLyrical},
      {"path_length_tolerance", &P::pathLengthTolerance, "m",
       "the goal is not reached while more of the local path is left", kSinceLyrical},
      {"rot_stopped_velocity", &P::rotStoppedVelocity, "rad/s", "slower counts as standing",
       kSinceLyrical},
      {"trans_stopped_velocity", &P::transStoppedVelocity, "m/s", "slower counts as standing",
       kSinceLyrical},
      {"stateful", &P::isStateful, "", "the place counts as reached until a new path",
       kSinceLyrical},
      {"symmetric_yaw_tolerance", &P::isSymmetric, "", "facing backwards is accepted too",
       kSinceLyrical},
  };
  return kKeys;
}

std::unique_ptr<GoalChecker> makeAxisGoalChecker(const AxisGoalParameters& parameters,
                                                 Distro distro) {
  return std::make_unique<AxisGoalChecker>(parameters, distro);
}

std::unique_ptr<GoalChecker> makeAdaptiveGoalChecker(const AdaptiveGoalParameters& parameters) {
  return std::make_unique<AdaptiveGoalChecker>(parameters);
}

}  // namespace sim2d::nav2

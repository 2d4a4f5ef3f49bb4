#include <cmath>
#include <memory>
#include <vector>

#include "sim2d/nav/nav2/control/PathHandler.h"
#include "sim2d/nav/nav2/control/dwb/DwbCritic.h"

namespace sim2d::nav2 {
namespace {

double squaredSpeed(const BodyTwist& twist) {
  return twist.linear * twist.linear + twist.lateral * twist.lateral;
}

/// Near the goal: first requires braking, then rotation in place.
class RotateToGoalCritic final : public DwbCritic {
 public:
  explicit RotateToGoalCritic(const DwbCriticSetup& setup)
      : parameters_(setup.parameters),
        tolerance_(setup.controller.xyGoalTolerance),
        stopped_(setup.controller.transStoppedVelocity),
        distro_(setup.distro) {}

  void reset() override {
    isInWindow_ = false;
    isRotating_ = false;
  }
  void prepare(const DwbScene& scene) override {
    const Pose2& robot = scene.input.robot;
    const double squared = (robot.position - scene.goal.position).squaredNorm();
    const bool isLong = distro_ >= Distro::Lyrical && pathLength(scene.plan) > kPathLengthTolerance;
    isInWindow_ = isInWindow_ || (squared <= tolerance_ * tolerance_ && !isLong);
    speedSquared_ = squaredSpeed(scene.input.speed);
    isRotating_ = isRotating_ || (isInWindow_ && speedSquared_ <= stopped_ * stopped_);
    goalHeading_ = scene.goal.heading;
  }
  DwbScore score(const DwbTrajectory& trajectory) override {
    if (!isInWindow_) {
      return 0.0;
    }
    if (!isRotating_) {
      const double squared = squaredSpeed(trajectory.velocity);
      if (squared >= speedSquared_) {
        return "Not slowing down near goal.";
      }
      return squared * parameters_.slowingFactor + remainingTurn(trajectory);
    }
    const BodyTwist& velocity = trajectory.velocity;
    if (std::abs(velocity.linear) > kStandstill || std::abs(velocity.lateral) > kStandstill) {
      return "Nonrotation command near goal.";
    }
    return remainingTurn(trajectory);
  }
  double scale(double /*resolution*/) const override { return parameters_.scale; }

 private:
  static constexpr double kStandstill = 1e-5;          // [m/s]
  static constexpr double kPathLengthTolerance = 1.0;  // [m]; its key in Nav2 lacks a dot

  double remainingTurn(const DwbTrajectory& trajectory) const {
    const double end = parameters_.lookaheadTime >= 0.0
                           ? trajectory.at(parameters_.lookaheadTime).heading
                           : trajectory.poses.back().heading;
    return std::abs(base::angleDiff(goalHeading_, end));
  }

  DwbCriticParameters parameters_;
  double tolerance_;  // [m]
  double stopped_;    // [m/s]
  Distro distro_;
  bool isInWindow_ = false, isRotating_ = false;
  double speedSquared_ = 0.0;  // [m^2/s^2]
  double goalHeading_ = 0.0;   // [rad]
};

/// Tracks the sign of the velocity along one axis.
class CommandTrend {
 public:
  void reset() { *this = {}; }
  /// Returns true on a sign change, after which the old sign is forbidden.
  bool update(double velocity) {
    if (velocity == 0.0 || std::isnan(velocity)) {
      return false;
    }
    const int sign = velocity > 0.0 ? 1 : -1;
    const bool isFlip = sign == -sign_;
    isNegativeForbidden_ = isNegativeForbidden_ || (isFlip && sign > 0);
    isPositiveForbidden_ = isPositiveForbidden_ || (isFlip && sign < 0);
    sign_ = sign;
    return isFlip;
  }
  bool forbids(double velocity) const {
    return (isNegativeForbidden_ && velocity < 0.0) || (isPositiveForbidden_ && velocity > 0.0);
  }
  bool hasFlipped() const { return isNegativeForbidden_ || isPositiveForbidden_; }

 private:
  int sign_ = 0;  // sign of the last nonzero velocity
  bool isNegativeForbidden_ = false, isPositiveForbidden_ = false;
};

/// Prevents oscillation: after a sign change the old sign is invalid until the robot has moved on.
class OscillationCritic final : public DwbCritic {
 public:
  explicit OscillationCritic(const DwbCriticSetup& setup) : parameters_(setup.parameters) {}

  void reset() override {
    x_.reset();
    y_.reset();
    theta_.reset();
  }
  void prepare(const DwbScene& scene) override {
    robot_ = scene.input.robot;
    time_ = scene.input.time;
  }
  DwbScore score(const DwbTrajectory& trajectory) override {
    const BodyTwist& velocity = trajectory.velocity;
    if (x_.forbids(velocity.linear) || y_.forbids(velocity.lateral) ||
        theta_.forbids(velocity.angular)) {
      return "Trajectory is oscillating.";
    }
    return 0.0;
  }
  void debrief(const BodyTwist& chosen) override {
    bool hasFlipped = x_.update(chosen.linear);
    if (parameters_.xOnlyThreshold < 0.0 || std::abs(chosen.linear) <= parameters_.xOnlyThreshold) {
      hasFlipped = y_.update(chosen.lateral) || hasFlipped;
      hasFlipped = theta_.update(chosen.angular) || hasFlipped;
    }
    if (hasFlipped) {
      flip_ = robot_;
      flipTime_ = time_;
    }
    if ((x_.hasFlipped() || y_.hasFlipped() || theta_.hasFlipped()) && hasProgressed()) {
      reset();
    }
  }
  double scale(double /*resolution*/) const override { return parameters_.scale; }

 private:
  bool hasProgressed() const {
    const DwbCriticParameters& p = parameters_;
    const double squared = (robot_.position - flip_.position).squaredNorm();
    if (p.resetDistance >= 0.0 && squared > p.resetDistance * p.resetDistance) {
      return true;
    }
    // As in Nav2 headings are subtracted without wrapping: crossing pi counts as a rotation.
    if (p.resetAngle >= 0.0 && std::abs(robot_.heading - flip_.heading) > p.resetAngle) {
      return true;
    }
    return p.resetTime >= 0.0 && time_ - flipTime_ > p.resetTime;
  }

  DwbCriticParameters parameters_;
  CommandTrend x_, y_, theta_;
  Pose2 robot_, flip_;
  double time_ = 0.0, flipTime_ = 0.0;  // [s]
};

class PreferForwardCritic final : public DwbCritic {
 public:
  explicit PreferForwardCritic(const DwbCriticSetup& setup) : parameters_(setup.parameters) {}
  DwbScore score(const DwbTrajectory& trajectory) override {
    const DwbCriticParameters& p = parameters_;
    const double x = trajectory.velocity.linear, turn = std::abs(trajectory.velocity.angular);
    if (x < 0.0 || (x < p.strafeX && turn < p.strafeTheta)) {
      return p.penalty;
    }
    return turn * p.thetaScale;
  }
  double scale(double /*resolution*/) const override { return parameters_.scale; }

 private:
  DwbCriticParameters parameters_;
};

class TwirlingDwbCritic final : public DwbCritic {
 public:
  explicit TwirlingDwbCritic(const DwbCriticSetup& setup) : scale_(setup.parameters.scale) {}
  DwbScore score(const DwbTrajectory& trajectory) override {
    return std::abs(trajectory.velocity.angular);
  }
  double scale(double /*resolution*/) const override { return scale_; }

 private:
  double scale_;
};

template <class Critic>
std::unique_ptr<DwbCritic> makeMotionCritic(const DwbCriticSetup& setup) {
  return std::make_unique<Critic>(setup);
}

}  // namespace

std::vector<DwbCriticType> motionCriticTypes() {
  using P = DwbCriticParameters;
  const Nav2Key<P> scale{"scale", &P::scale, "", "weight"};
  return {
      {"dwb_critics::RotateToGoalCritic",
       {scale,
        {"slowing_factor", &P::slowingFactor, "s^2/m^2", "weight of the speed near the goal"},
        {"lookahead_time", &P::lookaheadTime, "s",
         "time of the pose whose heading is scored; negative: the last pose"}},
       makeMotionCritic<RotateToGoalCritic>},
      {"dwb_critics::OscillationCritic",
       {scale,
        {"oscillation_reset_dist", &P::resetDistance, "m",
         "distance after which a change of direction is forgotten; negative: never"},
        {"oscillation_reset_angle", &P::resetAngle, "rad",
         "rotation after which a change of direction is forgotten"},
        {"oscillation_reset_time", &P::resetTime, "s",
         "time after which a change of direction is forgotten"},
        {"x_only_threshold", &P::xOnlyThreshold, "m/s",
         "forward speed above which rotation and lateral motion are not tracked; negative: always "
         "tracked"}},
       makeMotionCritic<OscillationCritic>},
      {"dwb_critics::PreferForwardCritic",
       {scale,
        {"penalty", &P::penalty, "", "cost of driving backwards or very slowly"},
        {"strafe_x", &P::strafeX, "m/s",
         "forward speed below which the motion counts as very slow"},
        {"strafe_theta", &P::strafeTheta, "rad/s",
         "turn rate above which very slow motion has no cost"},
        {"theta_scale", &P::thetaScale, "s/rad", "weight of the turn rate"}},
       makeMotionCritic<PreferForwardCritic>},
      {"dwb_critics::TwirlingCritic", {scale}, makeMotionCritic<TwirlingDwbCritic>},
  };
}

}  // namespace sim2d::nav2

#pragma once

#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/PathHandler.h"
#include "sim2d/nav/nav2/control/RegulationFunctions.h"

namespace sim2d::nav2 {

/// nav2_regulated_pure_pursuit_controller: follows a carrot on the path, at reduced speed in curves
/// and near obstacles. It does not limit the linear acceleration.
class RegulatedPurePursuit final : public Controller {
 public:
  /// `frequency`: controller_frequency [Hz].
  RegulatedPurePursuit(const PursuitParameters& parameters, Distro distro, double frequency);

  void setPlan(const Path& plan) override;
  ControlResult computeVelocityCommands(const ControlInput& input) override;
  void setSpeedLimit(double limit, bool isPercentage) override;
  bool cancel() override;
  void reset() override;

  const PursuitParameters& parameters() const { return parameters_; }  // with the speed limit

 private:
  struct Pursuit {
    Vec2 carrot = Vec2::Zero();         // robot frame [m]
    Vec2 headingCarrot = Vec2::Zero();  // determines rotation and curvature
    double sign = 1.0;
  };
  Pursuit findCarrots(const Path& plan, double speed) const;
  ControlResult command(const ControlInput& input, const Path& plan, const Pursuit& pursuit);
  BodyTwist follow(const ControlInput& input, const Path& plan, const Pursuit& pursuit,
                   std::uint8_t cost);
  bool isGoalTurn(const ControlInput& input, const Path& plan, const Vec2& carrot);
  void brakeForCancel(double speed, double sign, double& linear);
  bool collides(const ControlInput& input, const BodyTwist& twist, double range, double length);

  PursuitParameters parameters_;
  double fullLinearVelocity_;  // without a speed limit [m/s]
  Distro distro_;
  double period_;  // dt [s]
  PathHandler handler_;
  Pose2 goal_;  // end of the complete path
  bool isGoalLatched_ = false;
  bool isCancelling_ = false;
  bool isCancelled_ = false;
};

/// Dynamic window pure pursuit (main): the velocities nearest to a curvature within the
/// acceleration limits (dynamic_window_pure_pursuit_functions.hpp; Ohnishi, Takahashi 2025).

struct VelocityWindow {
  double minLinear = 0.0, maxLinear = 0.0;    // [m/s]
  double minAngular = 0.0, maxAngular = 0.0;  // [rad/s]
};

/// The velocities reachable from `now` within `dt` [s].
VelocityWindow velocityWindow(const PursuitParameters& parameters, const BodyTwist& now, double dt);
/// The part of the window between 0 and the regulated speed [m/s]; a single speed if it is empty.
VelocityWindow regulatedWindow(VelocityWindow window, double speed);
/// The fastest point of the window on the line omega = kappa v, else the corner nearest to the
/// line. `sign` < 0: backwards.
BodyTwist bestInWindow(const VelocityWindow& window, double curvature, double sign);

}  // namespace sim2d::nav2

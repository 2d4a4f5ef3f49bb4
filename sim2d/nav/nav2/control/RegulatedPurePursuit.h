#pragma once

#include "sim2d/nav/nav2/control/Controller.h"
#include "sim2d/nav/nav2/control/PathHandler.h"
#include "sim2d/nav/nav2/control/PursuitParameters.h"

namespace sim2d::nav2 {

/// nav2_regulated_pure_pursuit_controller: follows a carrot on the path, slowly in curves and near
/// obstacles. It has no limit of linear acceleration.
class RegulatedPurePursuit final : public Controller {
 public:
  /// `frequency` = that of the controller server [Hz].
  RegulatedPurePursuit(const PursuitParameters& parameters, Distro distro, double frequency);

  void setPlan(const Path& plan) override;
  Control computeVelocityCommands(const ControlInput& input) override;
  void setSpeedLimit(double limit, bool isPercentage) override;
  bool cancel() override;
  void reset() override;

  const PursuitParameters& parameters() const { return parameters_; }  // with the speed limit

 private:
  struct Pursuit {
    Vec2 carrot = Vec2::Zero();         // in the robot's frame [m]
    Vec2 headingCarrot = Vec2::Zero();  // what it turns to and curves by
    double sign = 1.0;
  };
  Pursuit pursue(const Path& plan, double speed) const;
  Control command(const ControlInput& input, const Path& plan, const Pursuit& pursuit);
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
  Pose2 goal_;  // end of the whole path
  bool isGoalLatched_ = false;
  bool isCancelling_ = false;
  bool isCancelled_ = false;
};

}  // namespace sim2d::nav2

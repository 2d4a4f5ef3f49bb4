#pragma once

#include <cstddef>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/GracefulParameters.h"
#include "sim2d/nav/nav2/control/PathHandler.h"

namespace sim2d::nav2 {

/// nav2_graceful_controller: drives a smooth curve to a reachable target on the path.
class GracefulController final : public Controller {
 public:
  GracefulController(const GracefulParameters& parameters, Distro distro);

  void setPlan(const Path& plan) override;
  ControlResult computeVelocityCommands(const ControlInput& input) override;
  void setSpeedLimit(double limit, bool isPercentage) override;

  const GracefulParameters& parameters() const { return parameters_; }  // with the speed limit

 private:
  /// The path in the robot's frame.
  struct Scene {
    const ControlInput& input;
    Path plan;
    double length = 0.0;  // of the path [m]
  };
  struct Attempt {
    Pose2 target;  // robot frame
    bool isBackward = false;
    double maxLinear = 0.0;  // [m/s]
  };
  bool isGoalTurn(const Scene& scene);
  ControlResult followOneTarget(const Scene& scene);
  ControlResult followFarthest(const Scene& scene);
  ControlResult followInterpolated(const Scene& scene);
  bool drive(const Scene& scene, Pose2 target, BodyTwist& command);
  bool isInitialRotationDone(const Pose2& target);
  bool simulate(const ControlInput& input, const Attempt& attempt, BodyTwist& command);
  bool isRotationFree(const ControlInput& input, double angle) const;
  bool collides(const ControlInput& input, const Pose2& local, double scale) const;
  double rotationCommand(double angle) const;

  GracefulParameters parameters_;
  GracefulParameters fullParameters_;  // without a speed limit
  Distro distro_;
  PathHandler handler_;
  Pose2 goal_;  // end of the complete path
  bool isGoalReached_ = false;
  bool isInitialRotation_ = true;
};

}  // namespace sim2d::nav2

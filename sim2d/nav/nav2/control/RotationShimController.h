#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"

namespace sim2d::nav2 {

/// Keys of nav2_rotation_shim_controller::RotationShimController.
struct RotationShimParameters {
  std::string primary;                  // primary_controller, main: primary_controller.plugin
  double threshold = 0.785;             // angular_dist_threshold [rad]
  double disengageThreshold = 0.3925;   // [rad], Humble 0.785
  double samplingDistance = 0.5;        // forward_sampling_distance [m]
  double rotateVelocity = 1.8;          // [rad/s]
  double maxAngularAcceleration = 3.2;  // [rad/s^2]
  double simulateAheadTime = 1.0;       // [s]
  bool rotatesToGoal = false;
  bool isClosedLoop = true;
  bool rotatesOnce = false;           // since Jazzy: only for a new goal
  bool usesPathOrientations = false;  // since Jazzy
  int maxCost = 254;                  // since Jazzy: max_cost_threshold
};
RotationShimParameters rotationShimDefaults(Distro distro);
const std::vector<Nav2Key<RotationShimParameters>>& rotationShimKeys();
const std::vector<IgnoredKey>& ignoredRotationShimKeys();

/// Turns in place towards a new path, then delegates to the primary controller.
class RotationShimController final : public Controller {
 public:
  /// `frequency`: controller_frequency [Hz].
  RotationShimController(const RotationShimParameters& parameters, Distro distro, double frequency,
                         std::unique_ptr<Controller> primary);

  void setPlan(const Path& plan) override;
  ControlResult computeVelocityCommands(const ControlInput& input) override;
  void setSpeedLimit(double limit, bool isPercentage) override;
  bool cancel() override { return primary_->cancel(); }
  void reset() override;

 private:
  std::optional<double> goalTurn(const ControlInput& input) const;
  std::optional<double> pathTurn(const ControlInput& input) const;
  std::optional<BodyTwist> turn(const ControlInput& input, double angle);
  ControlResult drive(const ControlInput& input);

  RotationShimParameters parameters_;
  Distro distro_;
  double period_;  // [s]
  std::unique_ptr<Controller> primary_;
  Path plan_;
  bool isPathNew_ = false;
  bool isTurning_ = false;
  std::optional<double> lastAngular_;  // last command [rad/s]
};

}  // namespace sim2d::nav2

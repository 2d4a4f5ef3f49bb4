#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/PathHandler.h"

namespace sim2d::nav2 {

/// Keys of nav2_graceful_controller::GracefulController.
struct GracefulParameters {
  double kPhi = 2.0;    // k_phi, Humble 3: ratio of slow to fast subsystem
  double kDelta = 1.0;  // k_delta, Humble 2 [1/m]
  double beta = 0.4;    // Humble 0.2
  double lambda = 2.0;
  double minLinear = 0.1;                  // [m/s]
  double maxLinear = 0.5;                  // [m/s]
  double maxAngular = 1.0;                 // [rad/s]
  double minAngularInPlace = 0.25;         // [rad/s], since Jazzy
  double slowdownRadius = 1.5;             // [m]
  double maxDeceleration = 2.5;            // [m/s^2], main
  double searchDistance = 0.0;             // [m]; < 0: all, 0: half the map
  double minLookahead = 0.25;              // [m], Jazzy
  double maxLookahead = 1.0;               // [m], since Jazzy
  double targetDistance = 0.6;             // motion_target_dist [m], Humble
  bool initialRotation = true;             // initial_rotation
  double initialRotationTolerance = 0.75;  // [rad]
  bool prefersFinalRotation = true;        // Humble: final_rotation
  double rotationScaling = 0.5;            // [1/rad]
  bool allowsBackward = false;
  double inPlaceResolution = 0.1;         // in_place_collision_resolution [rad]
  bool usesCollisionDetection = true;     // main
  double footprintScalingVelocity = 0.5;  // [m/s], main
  double footprintScalingFactor = 0.25;   // main
  double footprintScalingStep = 0.1;      // [m/s], main
};

GracefulParameters gracefulDefaults(Distro distro);
const std::vector<Nav2Key<GracefulParameters>>& gracefulKeys();
const std::vector<IgnoredKey>& ignoredGracefulKeys();

/// The control law of nav2_graceful_controller (smooth_control_law.cpp; Park, Kuipers, "A Smooth
/// Control Law for Graceful Motion of Differential Wheeled Mobile Robots in 2D Environment", ICRA
/// 2011).

/// Egocentric polar coordinates of a target; angles are clockwise from the line of sight as in the
/// paper.
struct EgoPolar {
  double r = 0.0;      // [m]
  double phi = 0.0;    // target heading [rad]
  double delta = 0.0;  // robot heading [rad]
};
EgoPolar egoPolar(const Pose2& target, const Pose2& robot, bool isBackward);

/// Curvature kappa [1/m], for forward motion.
double gracefulCurvature(const GracefulParameters& parameters, const EgoPolar& polar);
/// The command towards a target.
BodyTwist gracefulCommand(const GracefulParameters& parameters, Distro distro, const Pose2& target,
                          const Pose2& robot, bool isBackward);

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

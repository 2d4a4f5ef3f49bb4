#include "sim2d/nav/nav2/docking/DockController.h"

#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/nav/FrameTransform.h"
#include "sim2d/nav/nav2/control/ControllerUtils.h"
#include "sim2d/nav/nav2/control/GracefulParameters.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

namespace sim2d::nav2 {
namespace {

constexpr double kAtTarget = 0.01;  // [m], end of the simulation

}  // namespace

BodyTwist DockController::command(const DockControllerInput& view, const Pose2& target,
                                  bool isBackward) const {
  return gracefulCommand(law_, distro_, target, view.pose, isBackward);
}

bool DockController::isFree(const DockControllerInput& view, const Pose2& target, bool isDocking,
                            bool isBackward) const {
  if (!parameters_.usesCollisionDetection) {
    return true;
  }
  const double dt = parameters_.simulationTimeStep;
  const auto most = static_cast<int>(std::ceil(parameters_.projectionTime / dt));
  const Vec2 exemptPoint = isDocking ? target.position : view.pose.position;
  Pose2 pose = view.pose;
  for (int i = 0; i < most; ++i) {
    const BodyTwist twist = gracefulCommand(law_, distro_, target, pose, isBackward);
    pose.position += twist.linear * dt * Vec2(base::cos(pose.heading), base::sin(pose.heading));
    pose.heading = base::wrapToPi(pose.heading + twist.angular * dt);
    const bool isTested = (pose.position - exemptPoint).norm() > parameters_.dockCollisionThreshold;
    const Pose2 inCostmap = toFrame(view.costmapFrame, pose);
    if (isTested && footprintCost(view.costmap, view.footprint.corners, inCostmap) == kLethal) {
      return false;
    }
    if ((target.position - pose.position).norm() <= kAtTarget) {
      break;
    }
  }
  return true;
}

BodyTwist DockController::rotation(double angle, double turnRate, double dt) const {
  return {0.0, rotationVelocity({parameters_.rotationSpeed, parameters_.rotationAcceleration},
                                angle, turnRate, dt)};
}

}  // namespace sim2d::nav2

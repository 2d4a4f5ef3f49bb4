#include "sim2d/nav/nav2/control/SmoothControlLaw.h"

#include <algorithm>
#include <cmath>

#include "sim2d/base/Math.h"

namespace sim2d::nav2 {
namespace {

double power(double x, double exponent) {  // x >= 0
  if (exponent == 2.0 || std::isinf(x)) {
    return x * x;
  }
  return x == 0.0 ? (exponent == 0.0 ? 1.0 : 0.0) : base::exp(exponent * base::log(x));
}

}  // namespace

EgoPolar egoPolar(const Pose2& target, const Pose2& robot, bool isBackward) {
  const Vec2 d = target.position - robot.position;
  const double sight = base::atan2(-d.y(), d.x()) + (isBackward ? base::kPi : 0.0);
  return {d.norm(), base::wrapToPi(target.heading + sight), base::wrapToPi(robot.heading + sight)};
}

double gracefulCurvature(const GracefulParameters& p, const EgoPolar& polar) {
  const double slow = base::atan2(-p.kPhi * polar.phi, 1.0);  // the heading that it should have
  const double turned = p.kPhi * polar.phi;
  const double proportional = p.kDelta * (polar.delta - slow);
  const double feedback = (1.0 + p.kPhi / (1.0 + turned * turned)) * base::sin(polar.delta);
  const double steering = proportional + feedback;
  return steering == 0.0 ? 0.0 : -1.0 / polar.r * steering;  // at the target: infinite, not NaN
}

BodyTwist gracefulCommand(const GracefulParameters& p, Distro distro, const Pose2& target,
                          const Pose2& robot, bool isBackward) {
  const EgoPolar polar = egoPolar(target, robot, isBackward);
  const double sign = isBackward ? -1.0 : 1.0;
  const double curvature = sign * gracefulCurvature(p, polar);
  double v = p.maxLinear / (1.0 + p.beta * power(std::abs(curvature), p.lambda));
  v = std::min(v, p.maxLinear * polar.r / p.slowdownRadius);
  if (distro >= Distro::Lyrical) {
    v = std::min(v, std::sqrt(2.0 * polar.r * p.maxDeceleration));
  }
  v = sign * std::min(std::max(v, p.minLinear), p.maxLinear);
  const double w = std::min(std::max(curvature * v, -p.maxAngular), p.maxAngular);
  return {curvature != 0.0 ? w / curvature : v, w};
}

}  // namespace sim2d::nav2

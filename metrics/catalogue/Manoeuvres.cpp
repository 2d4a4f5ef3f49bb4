#include <cmath>

#include "metrics/MetricRegistry.h"
#include "metrics/Motion.h"

namespace metrics {

namespace {

/// Velocity in the frame of the robot.
Vec2 bodyVelocity(const Robot& robot) {
  return base::Pose2{Vec2(0.0, 0.0), robot.heading}.toLocal(robot.velocity);
}

bool oscillates(const Robot& robot, const MetricParameters& parameters) {
  const Vec2 velocity = bodyVelocity(robot);
  const double limit = parameters.oscillationSpeed;
  return std::fabs(velocity.x()) < limit && std::fabs(velocity.y()) < limit &&
         robot.speed < limit && std::fabs(robot.omega) < parameters.oscillationAngularSpeed;
}

bool backsUp(const Robot& robot, const MetricParameters& parameters) {
  return bodyVelocity(robot).x() < -parameters.backwardSpeed;
}

bool turnsInPlace(const Robot& robot, const MetricParameters& parameters) {
  const Vec2 velocity = bodyVelocity(robot);
  return std::fabs(velocity.x()) < parameters.inplaceSpeed &&
         std::fabs(velocity.y()) < parameters.inplaceSpeed &&
         std::fabs(robot.omega) >= parameters.inplaceAngularSpeed;
}

using Test = bool (*)(const Robot&, const MetricParameters&);

MetricFunction shareOfTime(Test test) {
  return [test](const Recording& recording, const MetricParameters& parameters) {
    const double total = recording.duration();
    const double time = timeWhere(
        recording, [&](std::size_t i) { return test(recording.samples[i].robot, parameters); });
    return numberValue(total > 0.0 ? 100.0 * time / total : 0.0);
  };
}

}  // namespace

void addManoeuvres(MetricRegistry& to) {
  const Category motion = Category::Motion;
  to.add({"oscillations", "Hardly moving", "%", motion, Better::Lower, Needs{},
          "share of time with |vx|, |vy|, |v| < oscillation_speed and |w| < "
          "oscillation_angular_speed (robot frame)",
          "SRPB", "[0, 100]", Kind::Number, 0, ""},
         shareOfTime(oscillates));
  to.add({"backward_movements", "Driving backwards", "%", motion, Better::Lower, Needs{},
          "share of time with vx < -backward_speed (robot frame)", "SRPB", "[0, 100]", Kind::Number,
          0, ""},
         shareOfTime(backsUp));
  to.add({"inplace_rotations", "Turning in place", "%", motion, Better::Lower, Needs{},
          "share of time with |vx|, |vy| < inplace_speed and |w| >= inplace_angular_speed", "SRPB",
          "[0, 100]", Kind::Number, 0, ""},
         shareOfTime(turnsInPlace));
}

}  // namespace metrics

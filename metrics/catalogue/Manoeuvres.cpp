#include <cmath>

#include "metrics/MetricRegistry.h"

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

template <Test kTest>
class ShareOfTime : public Accumulator {
 public:
  void add(const Instant& at) override { time_.add(at, kTest(at.now.robot, at.parameters)); }
  MetricValue value(const Instant& last) const {
    return numberValue(time_.percentOf(last.elapsed()));
  }

 private:
  HeldTime time_;
};

template <Test kTest>
Stream shareOfTime() {
  return streamOf<ShareOfTime<kTest>>(&ShareOfTime<kTest>::value);
}

}  // namespace

void addManoeuvres(MetricRegistry& to) {
  const Category motion = Category::Motion;
  to.add({"oscillations", "Hardly moving", "%", motion, Better::Lower, Needs{},
          "share of time with |vx|, |vy|, |v| < oscillation_speed and |w| < "
          "oscillation_angular_speed (robot frame)",
          "SRPB", "[0, 100]"},
         shareOfTime<oscillates>());
  to.add({"backward_movements", "Driving backwards", "%", motion, Better::Lower, Needs{},
          "share of time with vx < -backward_speed (robot frame)", "SRPB", "[0, 100]"},
         shareOfTime<backsUp>());
  to.add({"inplace_rotations", "Turning in place", "%", motion, Better::Lower, Needs{},
          "share of time with |vx|, |vy| < inplace_speed and |w| >= inplace_angular_speed", "SRPB",
          "[0, 100]"},
         shareOfTime<turnsInPlace>());
}

}  // namespace metrics

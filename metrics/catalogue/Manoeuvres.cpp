#include <cmath>

#include "metrics/TermStatistics.h"

namespace metrics {

namespace {

/// Velocity in the frame of the robot.
Vec2 bodyVelocity(const Robot& robot) {
  return base::Pose2{Vec2(0.0, 0.0), robot.heading}.toLocal(robot.velocity);
}

bool oscillates(const Instant& at) {
  const Robot& robot = at.now.robot;
  const Vec2 velocity = bodyVelocity(robot);
  const double limit = at.parameters.oscillationSpeed;
  return std::fabs(velocity.x()) < limit && std::fabs(velocity.y()) < limit &&
         robot.speed < limit && std::fabs(robot.omega) < at.parameters.oscillationAngularSpeed;
}

bool backsUp(const Instant& at) {
  return bodyVelocity(at.now.robot).x() < -at.parameters.backwardSpeed;
}

bool turnsInPlace(const Instant& at) {
  const Vec2 velocity = bodyVelocity(at.now.robot);
  return std::fabs(velocity.x()) < at.parameters.inplaceSpeed &&
         std::fabs(velocity.y()) < at.parameters.inplaceSpeed &&
         std::fabs(at.now.robot.omega) >= at.parameters.inplaceAngularSpeed;
}

constexpr char kManoeuvresMetrics[] = R"(
= Motion Analysis|lower|robot|SRPB
oscillations|Time hardly moving|%|[0, 100]|share of time with s < oscillation_speed and |w| < oscillation_angular_speed
backward_movements|Time driving backwards|%|[0, 100]|share of time with v_x < -backward_speed
inplace_rotations|Time rotating in place|%|[0, 100]|share of time with |v_x|, |v_y| < inplace_speed and |w| >= inplace_angular_speed
)";

}  // namespace

void addManoeuvres(MetricRegistry& to) {
  to.add(kManoeuvresMetrics,
         {{"oscillations", conditionTimeOf<oscillates>(&ConditionTime::percentOfTime)},
          {"backward_movements", conditionTimeOf<backsUp>(&ConditionTime::percentOfTime)},
          {"inplace_rotations", conditionTimeOf<turnsInPlace>(&ConditionTime::percentOfTime)}});
}

}  // namespace metrics

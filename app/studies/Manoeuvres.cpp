#include "app/studies/Manoeuvres.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim2d/base/Math.h"

namespace app {

namespace {

constexpr double kForever = 1e9;  // [s], duration of a last segment

struct LinearTarget {
  const char* name;
  double speed = 0.0;  // [m/s]
};

/// Brake, reverse, accelerate, keep the speed.
std::vector<LinearTarget> linearTargets(const sim2d::TraceRobot& robot, double speed) {
  return {{"brake", 0.0},
          {"reverse", -robot.maxVel},
          {"keep the speed", speed},
          {"accelerate", robot.maxVel}};
}

void addSwerves(const sim2d::TraceRobot& robot, double speed, std::vector<RobotManoeuvre>& to) {
  for (const LinearTarget& first :
       {LinearTarget{"at constant speed", speed}, LinearTarget{"while braking", 0.0}}) {
    for (const auto& [duration, time] : {std::pair{0.4, "0.4 s"}, {0.8, "0.8 s"}, {1.2, "1.2 s"}}) {
      for (const LinearTarget& then :
           {LinearTarget{"accelerate", robot.maxVel}, LinearTarget{"keep the speed", speed}}) {
        for (const double side : {1.0, -1.0}) {
          const std::string name = std::string("turn ") + (side > 0.0 ? "left " : "right ") + time +
                                   " " + first.name + ", then " + then.name;
          to.push_back({name,
                        {{duration, {first.speed, side * robot.maxOmega, 0.0}},
                         {kForever, {then.speed, 0.0, 0.0}}}});
        }
      }
    }
  }
}

/// Turns to either side; an omnidirectional robot also moves to either side.
void addSides(const sim2d::TraceRobot& robot, const LinearTarget& target,
              std::vector<RobotManoeuvre>& to) {
  for (const double side : {1.0, -1.0}) {
    const std::string where = side > 0.0 ? "left" : "right";
    to.push_back({target.name + (", turn " + where),
                  {{kForever, {target.speed, side * robot.maxOmega, 0.0}}}});
    if (robot.kinematics == "omnidirectional") {
      to.push_back({target.name + (", move " + where),
                    {{kForever, {target.speed, 0.0, side * robot.maxVel}}}});
    }
  }
}

}  // namespace

std::vector<RobotManoeuvre> robotManoeuvres(const sim2d::TraceRobot& robot,
                                            const sim2d::BodyTwist& now) {
  const std::vector<LinearTarget> targets = linearTargets(robot, now.linear);
  std::vector<RobotManoeuvre> all;
  all.reserve(3 * targets.size());  // with the sides
  for (const LinearTarget& target : targets) {
    all.push_back({target.name, {{kForever, {target.speed, 0.0, 0.0}}}});
  }
  for (const LinearTarget& target : targets) {
    addSides(robot, target, all);
  }
  if (robot.kinematics != "omnidirectional") {
    addSwerves(robot, now.linear, all);
  }
  return all;
}

sim2d::BodyTwist commandOf(const RobotManoeuvre& manoeuvre, double elapsed,
                           const sim2d::TraceRobot& robot, const sim2d::BodyTwist& now, double dt) {
  constexpr double kRounding = 1e-9;  // [s]
  std::size_t k = 0;
  double end = manoeuvre.segments.front().duration;
  while (k + 1 < manoeuvre.segments.size() && elapsed > end - kRounding) {
    end += manoeuvre.segments[++k].duration;
  }
  sim2d::BodyTwist command = manoeuvre.segments[k].target;
  const double change = robot.maxAcc * dt;
  command.linear = std::clamp(command.linear, now.linear - change, now.linear + change);
  return command;
}

std::optional<BodyState> bodyStateIn(const sim2d::Frame& frame, int id) {
  const sim2d::BodyColumns& bodies =
      id < 0 ? frame.robots : static_cast<const sim2d::BodyColumns&>(frame.humans);
  const auto found = std::find(bodies.id.begin(), bodies.id.end(), id);
  if (found == bodies.id.end()) {
    return std::nullopt;
  }
  const auto k = static_cast<std::size_t>(found - bodies.id.begin());
  return BodyState{{{bodies.x[k], bodies.y[k]}, bodies.heading[k]},
                   {bodies.vx[k], bodies.vy[k]},
                   bodies.omega[k]};
}

sim2d::BodyTwist twistIn(const sim2d::Frame& frame, int robot) {
  const BodyState state = bodyStateIn(frame, robot).value_or(BodyState());
  const base::Vec2 ahead = state.pose.direction();
  return {state.velocity.dot(ahead), state.omega, base::cross(ahead, state.velocity)};
}

const std::vector<PersonManoeuvre>& personManoeuvres() {
  static const std::vector<PersonManoeuvre> kAll = {
      {"stop", true, base::Vec2::Zero()},
      {"stop, step left", true, base::Vec2(0.0, 1.0)},
      {"stop, step right", true, base::Vec2(0.0, -1.0)},
      {"stop, step back", true, base::Vec2(-1.0, 0.0)},
      {"step left while walking", false, base::Vec2(0.0, 1.0)},
      {"step right while walking", false, base::Vec2(0.0, -1.0)},
      {"walk faster", false, base::Vec2(0.5, 0.0)}};
  return kAll;
}

sim2d::StepInputs inputsOf(const PersonManoeuvre& manoeuvre, double elapsed,
                           const sim2d::TraceHuman& person, double heading) {
  constexpr double kRelaxation = 0.5;  // [s]
  sim2d::StepInputs inputs;
  if (manoeuvre.stops) {
    inputs.emplace_back();
    inputs.back().kind = sim2d::InputKind::Stop;
    inputs.back().id = person.id;
  }
  if (manoeuvre.step != base::Vec2::Zero()) {
    const double speed = person.desiredSpeed * (1.0 - std::exp(-elapsed / kRelaxation));
    const base::Vec2 ahead = base::directionOf(heading);
    const base::Vec2 left(-ahead.y(), ahead.x());
    inputs.emplace_back();
    inputs.back().kind = sim2d::InputKind::Push;
    inputs.back().id = person.id;
    inputs.back().velocity = speed * (manoeuvre.step.x() * ahead + manoeuvre.step.y() * left);
  }
  return inputs;
}

}  // namespace app

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/Body.h"
#include "sim2d/trace/Frame.h"
#include "sim2d/trace/Trace.h"

/// The manoeuvres that are tried to avoid a contact.
namespace app {

/// Commands of a robot as targets: each holds for a time, the last one without end. The robot
/// approaches the targets as fast as its accelerations allow.
struct RobotManoeuvre {
  struct Segment {
    double duration = 0.0;  // [s]
    sim2d::BodyTwist target;
  };
  std::string name;  // "brake, turn left"
  std::vector<Segment> segments;
};

/// For a robot that moves with `now`, those that need the least first.
/// - All drives: brake, reverse, accelerate or keep the speed, straight ahead or with the highest
///   turn rate to either side.
/// - Differential and Ackermann: turn for 0.4, 0.8 or 1.2 s to either side at constant speed or
///   while braking, and then accelerate straight ahead or keep the speed.
/// - Omnidirectional: the first four with the highest lateral speed to either side.
std::vector<RobotManoeuvre> robotManoeuvres(const sim2d::TraceRobot& robot,
                                            const sim2d::BodyTwist& now);

/// The command of a manoeuvre `elapsed` [s] after its start, for a robot that moves with `now` and
/// a time step `dt` [s]. Its linear part is what is reached in this step, so that an Ackermann
/// robot steers while it brakes.
sim2d::BodyTwist commandOf(const RobotManoeuvre& manoeuvre, double elapsed,
                           const sim2d::TraceRobot& robot, const sim2d::BodyTwist& now, double dt);

/// The robot's velocity in its own frame. It must be in the frame.
sim2d::BodyTwist twistIn(const sim2d::Frame& frame, int robot);
/// Position, heading and velocity of a body; nullopt: it is not in the frame.
struct BodyState {
  base::Pose2 pose;
  base::Vec2 velocity = base::Vec2::Zero();  // [m/s]
  double omega = 0.0;                        // [rad/s]
};
std::optional<BodyState> bodyStateIn(const sim2d::Frame& frame, int id);

/// A manoeuvre of a person: stops, or keeps walking, and adds a velocity in a fixed direction that
/// grows to the desired speed v0 as v0 (1 - exp(-t / 0.5 s)), the relaxation of the social force
/// model.
struct PersonManoeuvre {
  std::string name;  // "stop, step left"
  bool stops = false;
  base::Vec2 step = base::Vec2::Zero();  // direction in the frame of the person, or zero
};
/// Stop; step to the left, the right or back after a stop; the first two while walking; walk
/// faster.
const std::vector<PersonManoeuvre>& personManoeuvres();
/// The inputs of a step, `elapsed` [s] after the start of the manoeuvre. `heading` [rad]: of the
/// person at its start.
sim2d::StepInputs inputsOf(const PersonManoeuvre& manoeuvre, double elapsed,
                           const sim2d::TraceHuman& person, double heading);

}  // namespace app

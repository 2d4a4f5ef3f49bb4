#pragma once

#include <vector>

#include "sim2d/nav/Body.h"

/// Robot kinematics in closed form. World frame for poses, robot frame for twists, SI. Finite
/// inputs give finite results. Thread-safe.
namespace sim2d {

/// Pose after `time` [s] at a constant twist: the exact arc (a straight line without rotation),
/// continuous as the turn rate vanishes. The lateral direction rotates with the robot.
Pose2 propagated(const Pose2& pose, const BodyTwist& twist, double time);

/// Clamps a command to what this drive can do at all: each component within its speed limit; no
/// lateral part unless omnidirectional; Ackermann: no tighter turn than `turningRadius` (none at
/// standstill), where the linear speed has priority.
BodyTwist clampedToLimits(const RobotBody& body, const BodyTwist& wanted);
/// Twist that the drive reaches from `now` within `time` [s]: within its limits, and no component
/// changes faster than its limit. Above a speed limit it decelerates at that rate (so it may still
/// exceed the limit). Ackermann: at full lock the turn rate falls with the speed, even if that
/// exceeds `maxAlpha`.
BodyTwist reached(const RobotBody& body, const BodyTwist& now, const BodyTwist& wanted,
                  double time);

/// All twists that are reachable within `time` (the dynamic window of Fox, Burgard & Thrun 1997).
/// Ackermann: the bounding box; `reached` rejects turns that are too tight.
struct TwistWindow {
  double lowLinear = 0.0, highLinear = 0.0;    // [m/s]
  double lowAngular = 0.0, highAngular = 0.0;  // [rad/s]
  double lowLateral = 0.0, highLateral = 0.0;  // [m/s]; 0 unless omnidirectional
};
TwistWindow dynamicWindow(const RobotBody& body, const BodyTwist& now, double time);

/// Velocity samples and the arcs that a robot drives with them (Fox, Burgard & Thrun 1997).
/// Thread-safe.

/// `count` evenly spaced samples from `low` to `high`. If 0 lies between, the sample nearest to 0
/// becomes 0, so that standing and driving straight are included. Replaces the contents of `to`.
void sampleEvenly(double low, double high, int count, std::vector<double>& to);

/// Number of samples per component.
struct SampleCounts {
  int linear = 20, angular = 20, lateral = 1;
};
/// At most linear x angular samples in total: an omnidirectional robot gets equal numbers for all
/// three components, other robots a single lateral sample.
SampleCounts sampleCounts(Kinematics kinematics, int linear, int angular);

/// Samples a dynamic window on a grid; Ackermann: feasible twists only. Replaces the contents of
/// `to`; does not allocate once it has the capacity.
class TwistSampler {
 public:
  TwistSampler(const RobotBody& body, const SampleCounts& counts);
  void sample(const TwistWindow& window, std::vector<BodyTwist>& to);

 private:
  RobotBody body_;
  SampleCounts counts_;
  std::vector<double> linear_, angular_, lateral_;
};

/// Poses of a robot that changes its twist from `now` to `wanted` as fast as it can and then keeps
/// it: `from` first, `step` [s] apart, filling `poses` (at least one). Headings are not wrapped.
void rollOut(const RobotBody& body, const Pose2& from, const BodyTwist& now,
             const BodyTwist& wanted, double step, std::vector<Pose2>& poses);

/// Time to a standstill when each component decelerates at its limit [s].
double stoppingTime(const RobotBody& body, const BodyTwist& twist);

/// Length of the shortest path from a pose to a point for a vehicle that drives forward with this
/// turning radius [m]: an arc and a straight line, or two arcs if the point lies inside the circle
/// (Bui, Boissonnat, Soueres & Laumond 1994, the relaxed Dubins problem). The point is at
/// `distance` [m] and at the angle `bearing` [rad] from the heading, of either sign.
double relaxedDubinsLength(double distance, double bearing, double turningRadius);

}  // namespace sim2d

#pragma once

#include <vector>

#include "sim2d/nav/Body.h"
#include "sim2d/nav/Observation.h"
#include "sim2d/nav/ReciprocalVelocity.h"

/// Tracking of a holonomic velocity v_H (speed V_H, angle theta_H from the heading) by a robot that
/// cannot move sideways. Source: Alonso-Mora, Breitenmoser, Rufli, Beardsley & Siegwart 2013,
/// "Optimal reciprocal collision avoidance for multiple non-holonomic robots". The robot drives an
/// arc of duration T that ends with the heading theta_H, then straight with V_H; the tracking error
/// is the maximum distance to a point that moves with v_H from the start. With the optimal speed on
/// the arc, v = V_H theta_H / 2 cot(theta_H / 2), it is V_H T |sin(theta_H / 2)|; for a turn in
/// place it is V_H |theta_H| / omega_max. Ackermann: no arc is tighter than R, so T is at least
/// 2 R tan(|theta_H| / 2) / V_H and the error at least 2 R tan(|theta_H| / 2) sin(|theta_H| / 2) at
/// any speed. Robot frame, SI. Thread-safe.
namespace sim2d {

/// Properties of a robot for tracking. Acceleration limits are included by `trackingModelFor`.
struct TrackingModel {
  Kinematics kinematics = Kinematics::Differential;
  double maxVel = 1.0;         // [m/s]
  double maxOmega = 1.5;       // [rad/s], > 0
  double turnTime = 0.5;       // T [s], > 0
  double turningRadius = 0.0;  // R [m]; Ackermann
};
/// T is `turnTime`, but not shorter than the time to accelerate to the maximum turn rate.
TrackingModel trackingModelFor(const RobotBody& body, double turnTime);

/// Angles up to this one are tracked by an arc: omega_max T, at most 90 degrees. Beyond it a
/// differential robot turns in place and an Ackermann robot takes longer.
double arcAngle(const TrackingModel& model);

/// Maximum angle at which an Ackermann robot tracks slow velocities within `epsilon`.
double maxTrackableAngle(double turningRadius, double epsilon);

/// Convex polygons inside the set of holonomic velocities that are tracked within `epsilon`; each
/// contains zero: forward velocities, tracked by an arc, and (differential only) slow velocities in
/// all directions, tracked by turning in place. The set itself is not convex. Omnidirectional: one
/// polygon without edges.
std::vector<std::vector<HalfPlane>> trackableVelocities(const TrackingModel& model, double epsilon);

/// Command that tracks this holonomic velocity. Below 1 cm/s the turn rate is scaled down towards
/// zero, because the direction of a zero velocity is undefined.
BodyTwist track(const TrackingModel& model, const Vec2& velocity);

/// Driving direction of a robot, for planners that choose holonomic velocities. World frame, SI.

/// Reference velocity, in the frame in which the robot drives forward.
struct DriveReference {
  TrackingModel model;
  double heading = 0.0;        // [rad], of the leading end
  Vec2 wanted = Vec2::Zero();  // [m/s]
  bool isReversing = false;

  /// Converts a twist of that frame into the robot's command.
  BodyTwist toRobotCommand(const BodyTwist& twist) const;
};

/// Selects forward or reverse gear of an Ackermann robot. It reverses when the target point lies
/// inside its turning circles, where no forward arc leads, and after it has stood still for a
/// second. Other robots always drive forward. Not thread-safe.
class GearSelector {
 public:
  GearSelector(const RobotBody& body, double turnTime);  // turnTime: T of the tracking [s]

  /// Call once per step. `target`: point to steer to [m]; `wanted`: holonomic reference velocity. A
  /// car that cannot track it within `epsilon` [m] steers as far as it can.
  DriveReference choose(const Observation& observation, const Vec2& target, const Vec2& wanted,
                        double epsilon);
  /// Minimum distance of a route point that can be steered to [m].
  double minLookahead() const;

 private:
  bool isInsideTurningCircle(const Vec2& target, double radius) const;
  void update(const Observation& observation, const Vec2& target, bool wantsToMove);

  TrackingModel model_;
  double maxReverse_;  // [m/s]
  bool isReversing_ = false;
  double since_ = -1e9;           // time of the last gear change [s]
  double lastMotionTime_ = -1.0;  // last time it moved or was not commanded to move [s]; < 0: never
};

/// Functions shared by planners that choose velocities under half-plane constraints. World frame,
/// SI. Thread-safe.

/// Bodies whose centre lies within `range` [m] and is not hidden by a wall, nearest first, at most
/// 24.
std::vector<TrackedBody> visibleBodies(const Observation& observation, double range);

/// Half planes of velocities that do not lead into walls within `horizon` [s]. Where there is less
/// room than `radius` [m], the available room is used instead. They contain zero and a
/// neighbourhood of it, unless the robot's centre is inside a wall.
std::vector<HalfPlane> wallPlanes(const Observation& observation, double radius, double speed,
                                  double horizon);

/// Rotation from the body frame to the world frame, or back with the negative heading.
HalfPlane rotated(const HalfPlane& plane, double heading);
Vec2 rotated(const Vec2& vector, double angle);

/// Largest violation of the planes from `first` on by this velocity [m/s]; 0 if there is none.
double worstViolation(const std::vector<HalfPlane>& planes, std::size_t first,
                      const Vec2& velocity);

/// Passive motion safety: the robot has stopped before anything that it perceives touches it
/// (Macek, Vasquez, Fraichard & Siegwart 2009; Bouraine, Fraichard & Salhi 2012). World frame, SI.
/// Thread-safe.

/// The robot changes to the twist within one step, keeps it for that step, then brakes to a
/// standstill. True if it keeps `margin` [m] to all bodies (at constant velocity) and walls all
/// that time, or comes no nearer to them than if it stood still.
bool isPassivelySafe(const RobotBody& body, const Observation& observation, const BodyTwist& twist,
                     double margin);

/// Twist nearest to the wanted one that is reachable within one step from `observation.motion` and
/// passively safe: as wanted, slower, turning in place, or else braking. Braking is safe if the
/// last twist was safe and people keep their velocities.
BodyTwist nearestSafeTwist(const RobotBody& body, const Observation& observation,
                           const BodyTwist& wanted, double margin);

}  // namespace sim2d

#pragma once

#include <vector>

#include "sim2d/nav/Body.h"
#include "sim2d/nav/ReciprocalVelocity.h"

/// How well a robot that cannot go sideways follows a holonomic velocity v_H of speed V_H and angle
/// theta_H from its heading. Source: Alonso-Mora, Breitenmoser, Rufli, Beardsley & Siegwart 2013,
/// "Optimal reciprocal collision avoidance for multiple non-holonomic robots". It drives an arc of
/// duration T that ends with the heading theta_H, then straight on with V_H; the tracking error is
/// the greatest distance to a point that moves with v_H from the start. With the speed on the arc
/// that makes it least, v = V_H theta_H / 2 cot(theta_H / 2), it is V_H T |sin(theta_H / 2)|.
/// Robot frame, SI. Thread: any.
namespace sim2d {

/// What counts of a robot. Limits of acceleration come in by `trackingModelOf`.
struct TrackingModel {
  Kinematics kinematics = Kinematics::Differential;
  double maxVel = 1.0;         // [m/s]
  double maxOmega = 1.5;       // [rad/s], > 0
  double turnTime = 0.5;       // T [s], > 0
  double turningRadius = 0.0;  // R [m]; Ackermann
};
/// T is `turnTime`, but no shorter than the drive takes to turn with full speed.
TrackingModel trackingModelOf(const RobotBody& body, double turnTime);

/// Angles up to this are met by an arc: omega_max T, at most 90 degrees. Beyond it a differential
/// robot turns on the spot, an Ackermann one takes longer.
double arcAngle(const TrackingModel& model);

/// The tracking error E(V_H, theta_H) [m]; `angle` in (-pi, pi]. Differential, on the spot:
/// V_H |theta_H| / omega_max. Ackermann: no arc is tighter than R, so T is at least
/// 2 R tan(|theta_H| / 2) / V_H and the error at least 2 R tan(|theta_H| / 2) sin(|theta_H| / 2),
/// whatever the speed. Omnidirectional: 0.
double trackingError(const TrackingModel& model, double speed, double angle);
/// The greatest speed of a holonomic velocity at this angle that is tracked with an error of at
/// most `epsilon` [m] (an Ackermann robot cannot at all beyond some angle: 0).
double fastestTracked(const TrackingModel& model, double angle, double epsilon);
/// The greatest angle at which an Ackermann robot tracks slow velocities that well.
double steeringAngle(double turningRadius, double epsilon);

/// Convex polygons inside the set of holonomic velocities that are tracked within `epsilon` (all of
/// them contain zero): those ahead, by an arc; and slow ones to all sides, on the spot
/// (differential alone). The set itself is not convex. Omnidirectional: one without edges.
std::vector<std::vector<HalfPlane>> trackedVelocities(const TrackingModel& model, double epsilon);

/// The command that tracks this holonomic velocity. Below a speed of 1 cm/s it turns the slower the
/// nearer the velocity is to zero, where it has no direction.
BodyTwist track(const TrackingModel& model, const Vec2& velocity);

}  // namespace sim2d

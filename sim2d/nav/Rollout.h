#pragma once

#include <vector>

#include "sim2d/nav/Motion.h"

/// Samples of velocities and the arcs that a robot drives with them (Fox, Burgard & Thrun 1997).
/// Thread: any.
namespace sim2d {

/// Evenly from `low` to `high`, `count` of them; the one nearest to 0 becomes 0 where 0 lies
/// between, so that standing and going straight are among them. Replaces what was in `to`.
void sampleEvenly(double low, double high, int count, std::vector<double>& to);

/// How many samples are taken of each component.
struct SampleCounts {
  int linear = 20, angular = 20, lateral = 1;
};
/// As many in all as linear x angular, at most: an omnidirectional robot gets equal numbers of all
/// three components, other robots none sideways.
SampleCounts sampleCounts(Kinematics kinematics, int linear, int angular);

/// Every twist of the window, by equal steps; Ackermann: those that `feasible` leaves alone.
/// Replaces what was in `to`; allocates nothing once it has had room.
class TwistSampler {
 public:
  TwistSampler(const RobotBody& body, const SampleCounts& counts);
  void sample(const TwistWindow& window, std::vector<BodyTwist>& to);

 private:
  RobotBody body_;
  SampleCounts counts_;
  std::vector<double> linear_, angular_, lateral_;
};

/// The poses of a robot that changes its twist from `now` to `wanted` as fast as it can and keeps
/// that: `from` first, `step` [s] apart, as many as
/// `poses` has room for (one at least). Headings are not wrapped.
void rollOut(const RobotBody& body, const Pose2& from, const BodyTwist& now,
             const BodyTwist& wanted, double step, std::vector<Pose2>& poses);

/// Time from this twist to standing when each component brakes as hard as it can [s].
double stopTimeOf(const RobotBody& body, const BodyTwist& twist);

/// Length of the shortest way from a pose to a point by a vehicle that drives forwards with this
/// turning radius [m]: an arc and a straight line, or two arcs when the point lies inside of the
/// circle (Bui, Boissonnat, Soueres & Laumond 1994, the relaxed Dubins problem). The point lies
/// `distance` [m] away at the angle `bearing` [rad] from the heading, of either sign.
double relaxedDubinsLength(double distance, double bearing, double turningRadius);

}  // namespace sim2d

#pragma once

#include <cstdint>

#include "sim2d/nav/Body.h"

/// Where a robot believes to be, by the turns of its wheels. World frame for poses, robot frame for
/// twists, SI.
namespace sim2d {

/// Errors of odometry. A motion is a turn `rot1`, a way `trans` and a turn `rot2`; to each of the
/// three normal noise is added (Thrun, Burgard & Fox 2005, Probabilistic Robotics, table 5.6):
/// - to a turn `rot` with the variance alpha1 |rot| + alpha2 |trans|,
/// - to the way with the variance alpha3 |trans| + alpha4 (|rot1| + |rot2|).
/// The book has squares of the motions; here variances grow with the way, so that the error of a
/// way does not depend on the number of steps it takes. The two agree for motions of 1 m and 1 rad.
struct OdometryParameters {
  double alpha1 = 0.0;  // [rad²/rad], noise of turns by turning
  double alpha2 = 0.0;  // [rad²/m], noise of turns by driving
  double alpha3 = 0.0;  // [m²/m], noise of ways by driving
  double alpha4 = 0.0;  // [m²/rad], noise of ways by turning
  /// Turn that one metre ahead is wrong by, always the same way [rad/m] (wheels of unequal size,
  /// Borenstein & Feng 1996); metres backwards take it back.
  double headingDrift = 0.0;

  bool isExact() const {
    return alpha1 == 0.0 && alpha2 == 0.0 && alpha3 == 0.0 && alpha4 == 0.0 && headingDrift == 0.0;
  }
};

/// The odometry of one robot. Errors add up from the last reset on. Draws depend on seed, robot and
/// step alone. A copy goes on as the original does. Thread: one at a time.
class Odometry {
 public:
  /// Parameters are finite and not negative (the drift may be).
  Odometry(const OdometryParameters& parameters, std::uint64_t seed, int robotId,
           const Pose2& start);

  /// Believes the true pose, and to stand.
  void reset(const Pose2& truth);
  /// One step of `dt` > 0 [s] that ended at the pose `truth` with the twist `motion`; it turned by
  /// less than half a turn. Without errors both are believed as they are, to the bit.
  void advance(const Pose2& truth, const BodyTwist& motion, double dt, std::uint64_t step);

  /// Draws of further steps.
  void reseed(std::uint64_t seed) { seed_ = seed; }

  const Pose2& pose() const { return pose_; }
  /// The true twist plus the errors of the last step, over its time.
  const BodyTwist& motion() const { return motion_; }

 private:
  struct Error {
    double rot1 = 0.0, rot2 = 0.0;  // [rad]
    double trans = 0.0;             // [m]
  };
  Error errorOf(double turn, const Vec2& way, std::uint64_t step) const;

  OdometryParameters parameters_;
  std::uint64_t seed_;
  int robotId_;
  Pose2 truth_;  // after the last step
  Pose2 pose_;
  BodyTwist motion_;
};

}  // namespace sim2d

#pragma once

#include <array>
#include <cstdint>

#include "sim2d/nav/Body.h"

/// Error model of a localiser such as AMCL, and the correction map -> odom that it publishes. Map
/// frame, SI, radians.
namespace sim2d {

/// Error of the estimated pose (x and y along the map axes, yaw). It is the sum of
/// - a stationary first-order Gauss-Markov process (Ornstein-Uhlenbeck) per coordinate: standard
///   deviation sigma, autocovariance sigma² exp(-|t| / correlationTime), clamped to ± 3 sigma,
/// - the remainder of the last jump: a step of `jumpDistance` in a random direction and of ±
///   `jumpYaw`, at the times of a Poisson process,
/// - the remainder of the error at the start or of the last global localisation.
/// The last two decay as exp(-t / correlationTime).
struct LocalizationParameters {
  double stdX = 0.0, stdY = 0.0;               // standard deviations [m]
  double stdYaw = 0.0;                         // standard deviation [rad]
  double correlationTime = 5.0;                // [s]; 0: corrections are independent
  double jumpRate = 0.0;                       // [1/s]
  double jumpDistance = 0.0;                   // [m]
  double jumpYaw = 0.0;                        // [rad]
  double rate = 0.0;                           // of corrections [Hz]; 0: only the first one
  double startX = 0.0, startY = 0.0;           // error of the initial pose [m]
  double startYaw = 0.0;                       // same [rad]
  double initialPoseTime = 0.0;                // of the first correction [s]
  double globalStd = 0.5, globalStdYaw = 0.5;  // after a global localisation [m], [rad]

  /// True if the estimate equals the true pose at each correction.
  bool isExact() const;
  /// True if random numbers are drawn.
  bool isRandom() const;
  /// True if the robot has a localiser that does more than the identity at the start.
  bool isActive() const { return rate > 0.0 || initialPoseTime > 0.0 || !isExact(); }
};

/// Correction rate of a localiser with an error but no given rate [Hz]: AMCL updates after 0.25 m
/// (update_min_d), here at 0.5 m/s.
constexpr double kDefaultCorrectionRate = 2.0;
/// The process is clamped to this many standard deviations.
constexpr double kMaxDeviations = 3.0;

/// Error at the corrections 0, 1, 2 …, which are 1 / rate apart. The process is discretised
/// exactly, so that its statistics do not depend on the rate; draws are functions of (seed, robot,
/// correction number).
class LocalizationError {
 public:
  struct Value {
    double x = 0.0, y = 0.0;  // [m]
    double yaw = 0.0;         // [rad]
  };
  LocalizationError(const LocalizationParameters& parameters, std::uint64_t seed, int robotId)
      : parameters_(parameters), seed_(seed), robotId_(robotId) {}

  /// Advances to the correction `number`, through all corrections in between.
  void advanceTo(std::int64_t number);
  const Value& value() const { return value_; }
  std::int64_t number() const { return number_; }  // -1: before the first correction
  /// Starts a global localisation at the next correction: the error of the start or of the last one
  /// is replaced by a draw with the deviations `globalStd` and `globalStdYaw`.
  void relocalize() { isRelocalizing_ = true; }
  void reseed(std::uint64_t seed) { seed_ = seed; }

 private:
  void step();
  void decayBy(double factor);
  void sampleJump(double interval);
  void drawGlobalPose();

  LocalizationParameters parameters_;
  std::uint64_t seed_;
  int robotId_;
  std::int64_t number_ = -1;
  std::array<double, 3> process_{};  // x, y, yaw in standard deviations, not clamped
  Value jump_, transient_, value_;
  bool isRelocalizing_ = false;
};

/// Localiser of one robot. A correction sets map -> odom so that the robot is at the estimated
/// pose; between corrections only odometry moves the estimate. Copies continue identically. Not
/// thread-safe.
class Localizer {
 public:
  Localizer(const LocalizationParameters& parameters, std::uint64_t seed, int robotId)
      : parameters_(parameters), error_(parameters, seed, robotId) {}

  /// Call once per step with the true pose, the pose in the frame odom, and the time [s]. A
  /// correction is made at the first step not before initialPoseTime + n / rate.
  void update(const Pose2& truth, const Pose2& odometry, double time);
  /// Call after the robot was teleported: a localiser that has a pose corrects in the next update.
  void reset() { needsCorrection_ = isLocalized_; }
  /// Service reinitialize_global_localization; no effect if it makes no further corrections.
  void relocalize();
  bool canRelocalize() const { return parameters_.rate > 0.0 && isLocalized_; }
  void reseed(std::uint64_t seed) { error_.reseed(seed); }

  /// Pose of the frame odom in the map; identity before the first correction.
  const Pose2& mapToOdom() const { return mapToOdom_; }
  bool isLocalized() const { return isLocalized_; }  // at least one correction was made
  bool isActive() const { return parameters_.isActive(); }

 private:
  LocalizationParameters parameters_;
  LocalizationError error_;
  Pose2 mapToOdom_;
  bool isLocalized_ = false, needsCorrection_ = false;
};

/// Estimated pose of a robot from wheel motions. World frame for poses, robot frame for twists, SI.

/// Odometry errors. A motion is a rotation `rot1`, a translation `trans` and a rotation `rot2`;
/// normal noise is added to each (Thrun, Burgard & Fox 2005, Probabilistic Robotics, table 5.6):
/// - to a rotation `rot` with the variance alpha1 |rot| + alpha2 |trans|,
/// - to the translation with the variance alpha3 |trans| + alpha4 (|rot1| + |rot2|).
/// The book squares the motions; here variances grow linearly, so that the error of a path does not
/// depend on the number of steps. Both agree for motions of 1 m and 1 rad.
struct OdometryParameters {
  double alpha1 = 0.0;  // [rad²/rad], rotation noise from rotation
  double alpha2 = 0.0;  // [rad²/m], rotation noise from translation
  double alpha3 = 0.0;  // [m²/m], translation noise from translation
  double alpha4 = 0.0;  // [m²/rad], translation noise from rotation
  /// Systematic heading error per metre forward [rad/m] (unequal wheel sizes, Borenstein & Feng
  /// 1996); driving backward reverses it.
  double headingDrift = 0.0;

  bool isExact() const {
    return alpha1 == 0.0 && alpha2 == 0.0 && alpha3 == 0.0 && alpha4 == 0.0 && headingDrift == 0.0;
  }
};

/// Odometry of one robot. Errors accumulate since the last reset. Draws depend on seed, robot and
/// step only. Copies continue identically. Not thread-safe.
class Odometry {
 public:
  /// Parameters must be finite and not negative (except the drift).
  Odometry(const OdometryParameters& parameters, std::uint64_t seed, int robotId,
           const Pose2& start);

  /// Sets the estimate to the true pose and zero velocity.
  void reset(const Pose2& truth);
  /// Advances one step of `dt` > 0 [s] that ended at the pose `truth` with the twist `motion`, with
  /// less than half a turn of rotation. Without errors the estimate is bit-identical to both.
  void advance(const Pose2& truth, const BodyTwist& motion, double dt, std::uint64_t step);

  /// Sets the seed for further steps.
  void reseed(std::uint64_t seed) { seed_ = seed; }

  const Pose2& pose() const { return pose_; }
  /// True twist plus the errors of the last step divided by its duration.
  const BodyTwist& motion() const { return motion_; }

 private:
  struct Error {
    double rot1 = 0.0, rot2 = 0.0;  // [rad]
    double trans = 0.0;             // [m]
  };
  Error sampledError(double turn, const Vec2& way, std::uint64_t step) const;

  OdometryParameters parameters_;
  std::uint64_t seed_;
  int robotId_;
  Pose2 truth_;  // after the last step
  Pose2 pose_;
  BodyTwist motion_;
};

}  // namespace sim2d

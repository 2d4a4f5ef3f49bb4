#pragma once

#include <array>
#include <cstdint>

#include "sim2d/nav/Body.h"
#include "sim2d/nav/FrameTransform.h"

/// The error of a localiser such as AMCL, and the correction map -> odom that it publishes. Map
/// frame, SI, radians.
namespace sim2d {

/// Error of the estimated pose (x and y along the axes of the map, yaw). It is the sum of
/// - a stationary first-order Gauss-Markov process (Ornstein-Uhlenbeck) of each coordinate:
/// standard
///   deviation sigma, autocovariance sigma² exp(-|t| / correlationTime), cut at ± 3 sigma,
/// - what is left of the last jump: a step of `jumpDistance` in a random direction and of
///   ± `jumpYaw`, at the times of a Poisson process,
/// - what is left of the error at the start or of the last global localisation.
/// The last two decay as exp(-t / correlationTime).
struct LocalizationParameters {
  double stdX = 0.0, stdY = 0.0;               // standard deviations [m]
  double stdYaw = 0.0;                         // standard deviation [rad]
  double correlationTime = 5.0;                // [s]; 0: corrections are independent
  double jumpRate = 0.0;                       // [1/s]
  double jumpDistance = 0.0;                   // [m]
  double jumpYaw = 0.0;                        // [rad]
  double rate = 0.0;                           // of corrections [Hz]; 0: the first one alone
  double startX = 0.0, startY = 0.0;           // error of the initial pose [m]
  double startYaw = 0.0;                       // idem [rad]
  double initialPoseTime = 0.0;                // of the first correction [s]
  double globalStd = 0.5, globalStdYaw = 0.5;  // after a global localisation [m], [rad]

  /// No error: the estimate is the true pose at each correction.
  bool isExact() const;
  /// Draws random numbers.
  bool isRandom() const;
  /// There is a localiser: it corrects more than the identity at the start.
  bool isActive() const { return rate > 0.0 || initialPoseTime > 0.0 || !isExact(); }
};

/// Corrections per second of a localiser with an error whose rate is not given: AMCL updates after
/// 0.25 m (update_min_d), here at 0.5 m/s [Hz].
constexpr double kUsualCorrectionRate = 2.0;
/// Errors of the process are cut at so many standard deviations.
constexpr double kMostDeviations = 3.0;

/// The error at the corrections 0, 1, 2 …, which are 1 / rate apart. The process is discretised
/// exactly, so that statistics do not depend on the rate; draws are functions of (seed, robot,
/// number of the correction).
class LocalizationError {
 public:
  struct Value {
    double x = 0.0, y = 0.0;  // [m]
    double yaw = 0.0;         // [rad]
  };
  LocalizationError(const LocalizationParameters& parameters, std::uint64_t seed, int robotId)
      : parameters_(parameters), seed_(seed), robotId_(robotId) {}

  /// To the correction `number`, by all that lie between.
  void advanceTo(std::int64_t number);
  const Value& value() const { return value_; }
  std::int64_t number() const { return number_; }  // -1: before the first correction
  /// At the next correction a global localisation begins: the error of the start or of the last one
  /// is replaced by a draw with the deviations `globalStd` and `globalStdYaw`.
  void relocalize() { isRelocalizing_ = true; }
  void reseed(std::uint64_t seed) { seed_ = seed; }

 private:
  void step();
  void decayBy(double factor);
  void jumpWithin(double interval);
  void drawGlobal();

  LocalizationParameters parameters_;
  std::uint64_t seed_;
  int robotId_;
  std::int64_t number_ = -1;
  std::array<double, 3> process_{};  // x, y, yaw in standard deviations, not cut
  Value jump_, transient_, value_;
  bool isRelocalizing_ = false;
};

/// The localiser of one robot. At a correction it sets map -> odom so that the robot is where the
/// estimate has it; between two corrections the odometry alone moves the estimate. A copy continues
/// as the original does. Thread: one at a time.
class Localizer {
 public:
  Localizer(const LocalizationParameters& parameters, std::uint64_t seed, int robotId)
      : parameters_(parameters), error_(parameters, seed, robotId) {}

  /// Each step: the true pose, the pose in the frame odom, the time [s]. A correction is made at
  /// the first step not before initialPoseTime + n / rate.
  void update(const Pose2& truth, const Pose2& odometry, double time);
  /// The robot was put elsewhere: a localiser that has a pose corrects in the next update.
  void reset() { mustCorrect_ = isLocalized_; }
  /// Service reinitialize_global_localization; nothing for one that does not correct again.
  void relocalize();
  bool canRelocalize() const { return parameters_.rate > 0.0 && isLocalized_; }
  void reseed(std::uint64_t seed) { error_.reseed(seed); }

  /// The pose of the frame odom in the map; identity before the first correction.
  const Pose2& mapToOdom() const { return mapToOdom_; }
  bool isLocalized() const { return isLocalized_; }  // a correction has come
  bool isActive() const { return parameters_.isActive(); }

 private:
  LocalizationParameters parameters_;
  LocalizationError error_;
  Pose2 mapToOdom_;
  bool isLocalized_ = false, mustCorrect_ = false;
};

}  // namespace sim2d

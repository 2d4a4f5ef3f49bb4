#include <cmath>

#include "sim2d/nav/RobotTypes.h"
#include "sim2d/scenario/FieldBuilder.h"
#include "sim2d/scenario/ScenarioYaml.h"

// The maps `lidar`, `detector`, `odometry_noise`, `localization` and `battery` of a robot.
namespace sim2d {
namespace {

constexpr double kLongestWay = 1000.0;     // [m], range of beams
constexpr double kMaxPerSecond = 1000.0;   // [Hz]
constexpr Range kAngle{-10.0, 10.0};       // [rad]
constexpr Range kNoise{0.0, kLongestWay};  // [m]
constexpr Range kShare{0.0, 1.0};

/// Makes the rows of numbers that are members of both `Keys`, as written, and `Part`, the effective
/// values of that sensor.
template <class Keys, class Part>
struct NumberRows {
  Part ResolvedRobot::*part;
  base::FormHints form;
  bool hasDefaults = true;  // false: those of the robot type

  FieldBuilder<Keys> operator()(std::string key, std::optional<double> Keys::*member,
                                double Part::*parameter, std::string help, std::string unit,
                                Range range) const {
    const auto access = [ part = part, parameter ](auto& of) -> auto& {
      return of.*part.*parameter;
    };
    FieldBuilder<Keys> row =
        field(std::move(key), member, std::move(help), form, std::move(unit), range)
            .resolvedAt(access);
    return hasDefaults ? std::move(row).defaultsTo(ResolvedRobot().*part.*parameter)
                       : std::move(row);
  }
};

/// Corrections are on by default if the localiser has an error.
double usualCorrectionRate(const LocalizationSettings& of) {
  const auto isGiven = [](const std::optional<double>& value) {
    return value.value_or(0.0) != 0.0;
  };
  const bool hasJumps = isGiven(of.jumpRate) && (isGiven(of.jumpDistance) || isGiven(of.jumpYaw));
  const bool hasError = hasJumps || isGiven(of.stdX) || isGiven(of.stdY) || isGiven(of.stdYaw) ||
                        isGiven(of.startX) || isGiven(of.startY) || isGiven(of.startYaw);
  return hasError ? kDefaultCorrectionRate : 0.0;
}

FieldBuilder<LocalizationSettings> correctionRateField() {
  return field("rate", &LocalizationSettings::rate,
               "Corrections of map -> odom per second; 0: only the first one; absent: 2 with an "
               "error, otherwise 0",
               {{}, 4, 0.5}, "Hz", Range{0.0, kMaxPerSecond})
      .resolvedAt([](auto& of) -> auto& { return of.localization.rate; })
      .with(&Field<LocalizationSettings>::resolve,
            [](const LocalizationSettings& from, ResolvedRobot& to, const ParameterSpec& /*spec*/) {
              to.localization.rate = from.rate.value_or(usualCorrectionRate(from));
            })
      .with(&Field<LocalizationSettings>::fallbackOf,
            [](const LocalizationSettings& of, const DesktopSettings& /*desktop*/) {
              return ParameterValue(usualCorrectionRate(of));
            });
}

/// Velocities are filtered by default if positions are noisy.
TrackVelocities usualVelocities(const DetectorSettings& detector) {
  return detector.noise.value_or(0.0) > 0.0 ? TrackVelocities::Filtered : TrackVelocities::Measured;
}

void resolveVelocities(const DetectorSettings& from, ResolvedRobot& to,
                       const ParameterSpec& /*spec*/) {
  to.detector.measuresVelocity =
      from.velocities.value_or(usualVelocities(from)) == TrackVelocities::Measured;
}

FieldBuilder<DetectorSettings> velocitiesField() {
  return field("velocities", &DetectorSettings::velocities,
               "Measured, or estimated from positions by a Kalman filter; absent: `filtered` with "
               "`noise`, otherwise `measured`",
               {"Velocities"})
      .words({"measured", "filtered"})
      .with(&Field<DetectorSettings>::resolve, resolveVelocities)
      .with(&Field<DetectorSettings>::resolved,
            [](const ResolvedRobot& robot, const ParameterSpec& spec) {
              return valueFrom(robot.detector.measuresVelocity ? TrackVelocities::Measured
                                                               : TrackVelocities::Filtered,
                               spec);
            })
      .with(&Field<DetectorSettings>::fallbackOf,
            [](const DetectorSettings& of, const DesktopSettings& /*desktop*/) {
              const bool isFiltered = usualVelocities(of) == TrackVelocities::Filtered;
              return ParameterValue(std::string(isFiltered ? "filtered" : "measured"));
            });
}

/// Angle spanned by the beams of a type; a full turn if one more beam would close the circle.
double spanOf(const RobotLidar& lidar) {
  const double span = lidar.angleMax - lidar.angleMin;
  const double closed = lidar.beams > 1 ? span * lidar.beams / (lidar.beams - 1) : span;
  return closed > 2.0 * base::kPi - 1e-6 ? 2.0 * base::kPi : span;
}

}  // namespace

Fields<LidarSettings> lidarFields() {
  using Keys = LidarSettings;
  using Parameters = LidarParameters;
  const base::FormHints form{{}, 3};
  const NumberRows<Keys, Parameters> number{&ResolvedRobot::lidar, form, false};
  return {
      field("beams", &Keys::beams,
            "Number of beams per scan; 0: no lidar; absent, here and below: that of the robot "
            "type",
            {"Beams", 0, 1.0}, {}, {0.0, 60000.0})
          .resolvedAt([](auto& of) -> auto& { return of.lidar.beams; }),
      number("range", &Keys::range, &Parameters::range, "Maximum range", "m",
             {0.0, kLongestWay, true}),
      number("rate", &Keys::rate, &Parameters::rate, "Scans per second", "Hz",
             {0.0, kMaxPerSecond, true}),
      number("angle_min", &Keys::angleMin, &Parameters::angleMin, "Angle of the first beam", "rad",
             kAngle),
      number("angle_max", &Keys::angleMax, &Parameters::angleMax,
             "Angle of the last beam; if it is a full turn after the first, the beams are "
             "spaced evenly",
             "rad", kAngle),
      field("x", &Keys::x, "Position in the robot's frame: forward", form, "m",
            base::kBodyOffsetRange)
          .resolvedAt([](auto& of) -> auto& { return of.lidar.mount.position.x(); }),
      field("y", &Keys::y, "Position in the robot's frame: to the left", form, "m",
            base::kBodyOffsetRange)
          .resolvedAt([](auto& of) -> auto& { return of.lidar.mount.position.y(); }),
      field("h", &Keys::h, "Orientation in the robot's frame", form, "rad", kAngle)
          .resolvedAt([](auto& of) -> auto& { return of.lidar.mount.heading; })
          .defaultsTo(0.0),
      number("noise", &Keys::noise, &Parameters::noise, "Standard deviation of a measured distance",
             "m", kNoise),
      field("legs", &Keys::legs, "The lidar detects people as two legs instead of discs", {"Legs"})
          .resolvedAt([](auto& of) -> auto& { return of.lidar.legs; })
          .defaultsTo(true),
      field("record", &Keys::record, "Write each scan to `scans.csv`", {"Record"})
          .resolvedTo(&ResolvedRobot::recordsScans)};
}

Fields<DetectorSettings> detectorFields() {
  using Keys = DetectorSettings;
  using Parameters = DetectorParameters;
  const NumberRows<Keys, Parameters> number{&ResolvedRobot::detector, {{}, 3}};
  return {
      field("kind", &Keys::kind,
            "Detections of the sensors, or the exact state of all bodies everywhere, which ignores "
            "the keys below",
            {"People perception"})
          .words({"sensor", "ground_truth"})
          .resolvedTo(&ResolvedRobot::detectorKind),
      number("range", &Keys::range, &Parameters::range,
             "Maximum distance of a detected body's centre", "m", base::kLength),
      number("field", &Keys::field, &Parameters::field, "Field of view, half of it to either side",
             "rad", {0.0, 6.2832, true}),  // a full turn, as rounded in forms
      number("rate", &Keys::rate, &Parameters::rate, "Detections per second; 0: one per time step",
             "Hz", {0.0, kMaxPerSecond}),
      number("latency", &Keys::latency, &Parameters::latency, "Delay between detection and planner",
             "s", {0.0, 60.0}),
      number("noise", &Keys::noise, &Parameters::noise, "Standard deviation of each coordinate",
             "m", kNoise),
      number("misses", &Keys::misses, &Parameters::misses,
             "Probability per detection of missing a visible body", {}, kShare),
      number("swaps", &Keys::swaps, &Parameters::swaps,
             "Probability per detection of exchanging the ids of two people who are close", {},
             kShare),
      number("swap_distance", &Keys::swapDistance, &Parameters::swapDistance,
             "Distance below which the ids of two people may be exchanged", "m", base::kDistance),
      field("occlusion", &Keys::occlusion, "Walls and other bodies occlude", {"Occlusion"})
          .resolvedAt([](auto& of) -> auto& { return of.detector.isOccluded; })
          .defaultsTo(true),
      number("hidden_share", &Keys::maxOcclusion, &Parameters::maxOcclusion,
             "A body of which others occlude more than this share is not detected", {}, kShare),
      number("coast_time", &Keys::coastTime, &Parameters::coastTime,
             "A track without detection is deleted after this time; until then it is "
             "extrapolated with constant velocity",
             "s", base::kTime),
      velocitiesField(),
      number("acceleration_noise", &Keys::accelerationNoise, &Parameters::accelerationPower,
             "Kalman filter: power of the acceleration noise of people", "m²/s³",
             base::kPositiveWeight)};
}

Fields<OdometrySettings> odometryFields() {
  using Keys = OdometrySettings;
  using Parameters = OdometryParameters;
  constexpr Range kVariance{0.0, 10.0};
  const NumberRows<Keys, Parameters> number{&ResolvedRobot::odometry, {{}, 4, 0.001}};
  return {number("alpha1", &Keys::alpha1, &Parameters::alpha1,
                 "Variance of the heading caused by rotation", "rad²/rad", kVariance),
          number("alpha2", &Keys::alpha2, &Parameters::alpha2,
                 "Variance of the heading caused by translation", "rad²/m", kVariance),
          number("alpha3", &Keys::alpha3, &Parameters::alpha3,
                 "Variance of the distance caused by translation", "m²/m", kVariance),
          number("alpha4", &Keys::alpha4, &Parameters::alpha4,
                 "Variance of the distance caused by rotation", "m²/rad", kVariance),
          number("drift", &Keys::drift, &Parameters::headingDrift,
                 "Rotation per metre driven forward that odometry does not measure", "rad/m",
                 {-10.0, 10.0})};
}

Fields<LocalizationSettings> localizationFields() {
  using Keys = LocalizationSettings;
  using Parameters = LocalizationParameters;
  constexpr Range kError{0.0, 10.0}, kTurnError{0.0, 1.0};         // [m], [rad]
  constexpr Range kOffset{-100.0, 100.0}, kTurn{-3.1416, 3.1416};  // [m], [rad]
  constexpr Range kStep{0.0, 100.0}, kTurnStep{0.0, 3.1416};       // [m], [rad]
  constexpr Range kWait{0.0, 3600.0};                              // [s]
  const NumberRows<Keys, Parameters> number{&ResolvedRobot::localization, {{}, 4, 0.01}};
  return {
      number("std_x", &Keys::stdX, &Parameters::stdX,
             "Standard deviation of the error in x, in the map", "m", kError),
      number("std_y", &Keys::stdY, &Parameters::stdY,
             "Standard deviation of the error in y, in the map", "m", kError),
      number("std_yaw", &Keys::stdYaw, &Parameters::stdYaw,
             "Standard deviation of the error of the heading", "rad", kTurnError),
      number("correlation_time", &Keys::correlationTime, &Parameters::correlationTime,
             "Time constant of the errors; 0: corrections are independent", "s", kWait),
      number("jump_rate", &Keys::jumpRate, &Parameters::jumpRate,
             "Mean number of jumps of the estimate per second", "1/s", {0.0, 10.0}),
      number("jump_distance", &Keys::jumpDistance, &Parameters::jumpDistance, "Length of a jump",
             "m", kStep),
      number("jump_yaw", &Keys::jumpYaw, &Parameters::jumpYaw,
             "Rotation of a jump, in either direction", "rad", kTurnStep),
      correctionRateField(),
      number("start_x", &Keys::startX, &Parameters::startX, "Error of the initial pose: x", "m",
             kOffset),
      number("start_y", &Keys::startY, &Parameters::startY, "Error of the initial pose: y", "m",
             kOffset),
      number("start_yaw", &Keys::startYaw, &Parameters::startYaw,
             "Error of the initial pose: heading", "rad", kTurn),
      number("initial_pose_time", &Keys::initialPoseTime, &Parameters::initialPoseTime,
             "Time of the initial pose; there is no frame map before", "s", kWait),
      number("global_std", &Keys::globalStd, &Parameters::globalStd,
             "Standard deviation of x and y after a global localization", "m", kStep),
      number("global_std_yaw", &Keys::globalStdYaw, &Parameters::globalStdYaw,
             "Standard deviation of the heading after a global localization", "rad", kTurnError)};
}

Fields<BatterySettings> batteryFields() {
  using Keys = BatterySettings;
  using Parameters = BatteryParameters;
  constexpr Range kPower{0.0, 1e5};  // [W]
  constexpr Range kVoltage{0.0, 1000.0, true};
  const NumberRows<Keys, Parameters> number{&ResolvedRobot::battery, {{}, 2}};
  return {
      field("capacity", &Keys::capacity,
            "Stored energy when full; absent: the battery never runs low", {{}, 2}, "Wh",
            {0.0, 1e6, true})
          .resolvedAt([](auto& of) -> auto& { return of.battery.capacity; }),
      number("level", &Keys::level, &Parameters::level, "State of charge at the start", "", kShare),
      number("idle_power", &Keys::idlePower, &Parameters::idlePower,
             "Power consumption at standstill", "W", kPower),
      number("motion_power", &Keys::motionPower, &Parameters::motionPower,
             "Additional power consumption at top speed or top turn rate; proportional "
             "below",
             "W", kPower),
      number("charge_power", &Keys::chargePower, &Parameters::chargePower,
             "Charging power at a charging dock", "W", kPower),
      number("empty_voltage", &Keys::emptyVoltage, &Parameters::emptyVoltage,
             "Voltage of the empty battery", "V", kVoltage),
      number("full_voltage", &Keys::fullVoltage, &Parameters::fullVoltage,
             "Voltage of the full battery; linear in between", "V", kVoltage)};
}

void setLidarFromType(const RobotType& type, ResolvedRobot& to) {
  const RobotLidar lidar = type.lidar.value_or(*robotTypes().front().lidar);
  to.lidar.beams = type.lidar ? lidar.beams : 0;
  to.lidar.range = lidar.range;
  to.lidar.rate = lidar.rate;
  to.lidar.angleMin = lidar.angleMin;
  to.lidar.angleMax = lidar.angleMin + spanOf(lidar);
  to.lidar.mount = {{lidar.x, lidar.y}, 0.0};
  to.lidar.noise = lidar.noise;
}

void resolveSensors(const Robot& from, ResolvedRobot& to) {
  resolveFields(from.lidar, to);
  const double span = to.lidar.angleMax - to.lidar.angleMin;
  if (std::fabs(span - 2.0 * base::kPi) < 1e-3) {  // users write 3.1416
    to.lidar.angleMax = to.lidar.angleMin + 2.0 * base::kPi;
  }
  resolveFields(from.detector, to);
  resolveFields(from.odometryNoise, to);
  resolveFields(from.localization, to);
  resolveFields(from.battery, to);
  if (to.detectorKind == DetectorKind::GroundTruth) {
    to.detector = groundTruthDetector();
  }
}

}  // namespace sim2d

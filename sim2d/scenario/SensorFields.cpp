#include <cmath>

#include "sim2d/nav/RobotTypes.h"
#include "sim2d/scenario/FieldMaking.h"
#include "sim2d/scenario/ScenarioTree.h"

// What a robot senses with and lives on: the maps `lidar`, `detector`, `odometry_noise`,
// `localization` and `battery`.
namespace sim2d {
namespace {

constexpr double kLongestWay = 1000.0;     // [m], of beams
constexpr double kMostPerSecond = 1000.0;  // [Hz]
constexpr Range kAngle{-10.0, 10.0};       // [rad]
constexpr Range kNoise{0.0, kLongestWay};  // [m]
constexpr Range kShare{0.0, 1.0};

template <class T>
using MaybeNumber = std::optional<double> T::*;

/// A number whose default is the type's.
template <class Access>
FieldOf<LidarSettings> lidarNumber(std::string key, MaybeNumber<LidarSettings> member,
                                   Access access, std::string help, std::string unit, Range range) {
  return field(std::move(key), member, std::move(help), {{}, 3}, std::move(unit), range)
      .resolvedAt(access);
}

FieldOf<DetectorSettings> detectorNumber(std::string key, MaybeNumber<DetectorSettings> member,
                                         double DetectorParameters::*parameter, std::string help,
                                         std::string unit, Range range) {
  const auto access = [parameter](auto& of) -> auto& {
    return of.detector.*parameter;
  };
  return field(std::move(key), member, std::move(help), {{}, 3}, std::move(unit), range)
      .resolvedAt(access)
      .orElse(idealDetector().*parameter);
}

FieldOf<OdometrySettings> odometryNumber(std::string key, MaybeNumber<OdometrySettings> member,
                                         double OdometryParameters::*parameter, std::string help,
                                         std::string unit, Range range = {0.0, 10.0}) {
  const auto access = [parameter](auto& of) -> auto& {
    return of.odometry.*parameter;
  };
  return field(std::move(key), member, std::move(help), {{}, 4, 0.001}, std::move(unit), range)
      .resolvedAt(access)
      .orElse(0.0);
}

FieldOf<LocalizationSettings> localizationNumber(std::string key,
                                                 MaybeNumber<LocalizationSettings> member,
                                                 double LocalizationParameters::*parameter,
                                                 std::string help, std::string unit, Range range) {
  const auto access = [parameter](auto& of) -> auto& {
    return of.localization.*parameter;
  };
  return field(std::move(key), member, std::move(help), {{}, 4, 0.01}, std::move(unit), range)
      .resolvedAt(access)
      .orElse(LocalizationParameters().*parameter);
}

/// A localiser with an error corrects, unless the file says otherwise.
double usualCorrectionRate(const LocalizationSettings& of) {
  const auto isGiven = [](const std::optional<double>& value) {
    return value.value_or(0.0) != 0.0;
  };
  const bool hasJumps = isGiven(of.jumpRate) && (isGiven(of.jumpDistance) || isGiven(of.jumpYaw));
  const bool hasError = hasJumps || isGiven(of.stdX) || isGiven(of.stdY) || isGiven(of.stdYaw) ||
                        isGiven(of.startX) || isGiven(of.startY) || isGiven(of.startYaw);
  return hasError ? kUsualCorrectionRate : 0.0;
}

FieldOf<LocalizationSettings> correctionRateField() {
  return field(
             "rate", &LocalizationSettings::rate,
             "Corrections map -> odom per second; 0: only the first one. Absent: 2 with an error, "
             "else 0",
             {{}, 4, 0.5}, "Hz", Range{0.0, kMostPerSecond})
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

FieldOf<BatterySettings> batteryNumber(std::string key, MaybeNumber<BatterySettings> member,
                                       double BatteryParameters::*parameter, std::string help,
                                       std::string unit, Range range) {
  const auto access = [parameter](auto& of) -> auto& {
    return of.battery.*parameter;
  };
  return field(std::move(key), member, std::move(help), {{}, 2}, std::move(unit), range)
      .resolvedAt(access);
}

/// Noisy places make noisy velocities, unless the file says otherwise.
TrackVelocities usualVelocities(const DetectorSettings& detector) {
  return detector.noise.value_or(0.0) > 0.0 ? TrackVelocities::Filtered : TrackVelocities::Measured;
}

void resolveVelocities(const DetectorSettings& from, ResolvedRobot& to,
                       const ParameterSpec& /*spec*/) {
  to.detector.isMotionMeasured =
      from.velocities.value_or(usualVelocities(from)) == TrackVelocities::Measured;
}

FieldOf<DetectorSettings> velocitiesField() {
  return field("velocities", &DetectorSettings::velocities,
               "Seen as they are, or found from the places by a Kalman filter; absent: `filtered` "
               "with `noise`, else `measured`",
               {"Velocities"})
      .words({"measured", "filtered"})
      .with(&Field<DetectorSettings>::resolve, resolveVelocities)
      .with(&Field<DetectorSettings>::resolved,
            [](const ResolvedRobot& robot, const ParameterSpec& spec) {
              return valueFrom(robot.detector.isMotionMeasured ? TrackVelocities::Measured
                                                               : TrackVelocities::Filtered,
                               spec);
            })
      .with(&Field<DetectorSettings>::fallbackOf,
            [](const DetectorSettings& of, const DesktopSettings& /*desktop*/) {
              const bool isFiltered = usualVelocities(of) == TrackVelocities::Filtered;
              return ParameterValue(std::string(isFiltered ? "filtered" : "measured"));
            });
}

/// The angle that the beams of a type span; all round when one more would close the circle.
double spanOf(const RobotLidar& lidar) {
  const double span = lidar.angleMax - lidar.angleMin;
  const double closed = lidar.beams > 1 ? span * lidar.beams / (lidar.beams - 1) : span;
  return closed > 2.0 * base::kPi - 1e-6 ? 2.0 * base::kPi : span;
}

}  // namespace

Fields<LidarSettings> lidarFields() {
  using Keys = LidarSettings;
  return {field("beams", &Keys::beams,
                "How many in a turn; 0: no lidar. Absent, here and below: as the type has it",
                {"Beams", 0, 1.0}, {}, {0.0, 60000.0})
              .resolvedAt([](auto& of) -> auto& { return of.lidar.beams; }),
          lidarNumber("range", &Keys::range, [](auto& of) -> auto& { return of.lidar.range; },
                      "What is farther away is not met", "m", {0.0, kLongestWay, true}),
          lidarNumber("rate", &Keys::rate, [](auto& of) -> auto& { return of.lidar.rate; },
                      "Turns per second", "Hz", {0.0, kMostPerSecond, true}),
          lidarNumber(
              "angle_min", &Keys::angleMin, [](auto& of) -> auto& { return of.lidar.angleMin; },
              "Of the first beam", "rad", kAngle),
          lidarNumber(
              "angle_max", &Keys::angleMax, [](auto& of) -> auto& { return of.lidar.angleMax; },
              "Of the last beam; a whole turn after the first: the beams are evenly around", "rad",
              kAngle),
          lidarNumber(
              "x", &Keys::x, [](auto& of) -> auto& { return of.lidar.mount.position.x(); },
              "Where it sits, in the robot's frame: ahead", "m", base::kOnBody),
          lidarNumber(
              "y", &Keys::y, [](auto& of) -> auto& { return of.lidar.mount.position.y(); },
              "Idem: to the left", "m", base::kOnBody),
          lidarNumber(
              "h", &Keys::h, [](auto& of) -> auto& { return of.lidar.mount.heading; },
              "Where it looks, in the robot's frame", "rad", kAngle)
              .orElse(0.0),
          lidarNumber(
              "noise", &Keys::noise, [](auto& of) -> auto& { return of.lidar.noise; },
              "Standard deviation of a distance", "m", kNoise),
          field("legs", &Keys::legs, "People are two legs to it, else discs", {"Legs"})
              .resolvedAt([](auto& of) -> auto& { return of.lidar.legs; })
              .orElse(true),
          field("record", &Keys::record, "Each turn is written to `scans.csv`", {"Record"})
              .resolvedAt([](auto& of) -> auto& { return of.recordsScans; })
              .orElse(false)};
}

Fields<DetectorSettings> detectorFields() {
  using Keys = DetectorSettings;
  using Parameters = DetectorParameters;
  return {
      field("kind", &Keys::kind,
            "What its sensors tell, or everybody everywhere: then nothing else of this counts",
            {"Knows of people"})
          .words({"sensor", "ground_truth"})
          .resolvedAt([](auto& of) -> auto& { return of.detectorKind; })
          .orElse(DetectorKind::Sensor),
      detectorNumber("range", &Keys::range, &Parameters::range,
                     "Whose centre is farther away is not seen", "m", base::kLength),
      detectorNumber("field", &Keys::field, &Parameters::field,
                     "The angle that it sees, half of it to either side", "rad",
                     {0.0, 6.2832, true}),  // a whole turn, as forms show it
      detectorNumber("rate", &Keys::rate, &Parameters::rate, "How often it looks; 0: at each step",
                     "Hz", {0.0, kMostPerSecond}),
      detectorNumber("latency", &Keys::latency, &Parameters::latency, "From sight to the planner",
                     "s", {0.0, 60.0}),
      detectorNumber("noise", &Keys::noise, &Parameters::noise,
                     "Standard deviation of each coordinate", "m", kNoise),
      detectorNumber("misses", &Keys::misses, &Parameters::misses,
                     "Chance not to see somebody, each time it looks", {}, kShare),
      detectorNumber("swaps", &Keys::swaps, &Parameters::swaps,
                     "Chance to mix up two people who are close, each time it looks", {}, kShare),
      detectorNumber("swap_distance", &Keys::swapDistance, &Parameters::swapDistance,
                     "People nearer to each other than this may be mixed up", "m", base::kDistance),
      field("occlusion", &Keys::occlusion, "Walls and other bodies hide", {"Hidden ones"})
          .resolvedAt([](auto& of) -> auto& { return of.detector.isOccluded; })
          .orElse(true),
      detectorNumber("hidden_share", &Keys::hiddenShare, &Parameters::hiddenShare,
                     "Who is hidden by others to more than this share is not seen", {}, kShare),
      detectorNumber("coast_time", &Keys::coastTime, &Parameters::coastTime,
                     "Who is not seen for longer is forgotten; until then he goes on as before",
                     "s", base::kTime),
      velocitiesField(),
      detectorNumber("acceleration_noise", &Keys::accelerationNoise, &Parameters::accelerationPower,
                     "Of the Kalman filter: how fast people change their velocity", "m²/s³",
                     base::kWeightAboveZero)};
}

Fields<OdometrySettings> odometryFields() {
  using Keys = OdometrySettings;
  using Parameters = OdometryParameters;
  return {
      odometryNumber("alpha1", &Keys::alpha1, &Parameters::alpha1,
                     "Variance of its heading by turning", "rad²/rad"),
      odometryNumber("alpha2", &Keys::alpha2, &Parameters::alpha2,
                     "Variance of its heading by driving", "rad²/m"),
      odometryNumber("alpha3", &Keys::alpha3, &Parameters::alpha3, "Variance of its way by driving",
                     "m²/m"),
      odometryNumber("alpha4", &Keys::alpha4, &Parameters::alpha4, "Variance of its way by turning",
                     "m²/rad"),
      odometryNumber("drift", &Keys::drift, &Parameters::headingDrift,
                     "What each metre ahead turns it without its knowing", "rad/m", {-10.0, 10.0})};
}

Fields<LocalizationSettings> localizationFields() {
  using Keys = LocalizationSettings;
  using Parameters = LocalizationParameters;
  constexpr Range kError{0.0, 10.0}, kTurnError{0.0, 1.0};         // [m], [rad]
  constexpr Range kOffset{-100.0, 100.0}, kTurn{-3.1416, 3.1416};  // [m], [rad]
  constexpr Range kStep{0.0, 100.0}, kTurnStep{0.0, 3.1416};       // [m], [rad]
  constexpr Range kWait{0.0, 3600.0};                              // [s]
  return {
      localizationNumber("std_x", &Keys::stdX, &Parameters::stdX,
                         "Standard deviation of the error in x, in the map", "m", kError),
      localizationNumber("std_y", &Keys::stdY, &Parameters::stdY,
                         "Standard deviation of the error in y, in the map", "m", kError),
      localizationNumber("std_yaw", &Keys::stdYaw, &Parameters::stdYaw,
                         "Standard deviation of the error of the heading", "rad", kTurnError),
      localizationNumber("correlation_time", &Keys::correlationTime, &Parameters::correlationTime,
                         "Time constant of the errors; 0: corrections are independent", "s", kWait),
      localizationNumber("jump_rate", &Keys::jumpRate, &Parameters::jumpRate,
                         "Mean number of jumps of the estimate per second", "1/s", {0.0, 10.0}),
      localizationNumber("jump_distance", &Keys::jumpDistance, &Parameters::jumpDistance,
                         "Length of a jump", "m", kStep),
      localizationNumber("jump_yaw", &Keys::jumpYaw, &Parameters::jumpYaw,
                         "Turn of a jump, to either side", "rad", kTurnStep),
      correctionRateField(),
      localizationNumber("start_x", &Keys::startX, &Parameters::startX,
                         "Error of the initial pose: x", "m", kOffset),
      localizationNumber("start_y", &Keys::startY, &Parameters::startY,
                         "Error of the initial pose: y", "m", kOffset),
      localizationNumber("start_yaw", &Keys::startYaw, &Parameters::startYaw,
                         "Error of the initial pose: heading", "rad", kTurn),
      localizationNumber("initial_pose_time", &Keys::initialPoseTime, &Parameters::initialPoseTime,
                         "Time of the initial pose; there is no frame map before", "s", kWait),
      localizationNumber("global_std", &Keys::globalStd, &Parameters::globalStd,
                         "Standard deviation of x and y after a global localisation", "m", kStep),
      localizationNumber("global_std_yaw", &Keys::globalStdYaw, &Parameters::globalStdYaw,
                         "Standard deviation of the heading after a global localisation", "rad",
                         kTurnError)};
}

Fields<BatterySettings> batteryFields() {
  using Keys = BatterySettings;
  using Parameters = BatteryParameters;
  constexpr Range kPower{0.0, 1e5};  // [W]
  constexpr Range kVoltage{0.0, 1000.0, true};
  const Parameters usual;
  return {
      batteryNumber("capacity", &Keys::capacity, &Parameters::capacity,
                    "Energy that it stores; without it the battery never runs low", "Wh",
                    {0.0, 1e6, true}),
      batteryNumber("level", &Keys::level, &Parameters::level, "Charge at the start", "", kShare)
          .orElse(usual.level),
      batteryNumber("idle_power", &Keys::idlePower, &Parameters::idlePower,
                    "Power that it gives while the robot stands", "W", kPower)
          .orElse(usual.idlePower),
      batteryNumber("motion_power", &Keys::motionPower, &Parameters::motionPower,
                    "Additional power at top speed or top turn rate; in proportion below", "W",
                    kPower)
          .orElse(usual.motionPower),
      batteryNumber("charge_power", &Keys::chargePower, &Parameters::chargePower,
                    "Power that it takes at a charging dock", "W", kPower)
          .orElse(usual.chargePower),
      batteryNumber("empty_voltage", &Keys::emptyVoltage, &Parameters::emptyVoltage,
                    "Voltage when it is empty", "V", kVoltage)
          .orElse(usual.emptyVoltage),
      batteryNumber("full_voltage", &Keys::fullVoltage, &Parameters::fullVoltage,
                    "Voltage when it is full; linear in between", "V", kVoltage)
          .orElse(usual.fullVoltage)};
}

void takeLidarOf(const RobotType& type, ResolvedRobot& to) {
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
  if (std::fabs(span - 2.0 * base::kPi) < 1e-3) {  // people write 3.1416
    to.lidar.angleMax = to.lidar.angleMin + 2.0 * base::kPi;
  }
  resolveFields(from.detector, to);
  resolveFields(from.odometryNoise, to);
  resolveFields(from.localization, to);
  resolveFields(from.battery, to);
  if (to.detectorKind == DetectorKind::GroundTruth) {
    to.detector = groundTruth();
  }
}

}  // namespace sim2d

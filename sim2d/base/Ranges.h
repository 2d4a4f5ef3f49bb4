#pragma once

#include "sim2d/base/ParameterSpec.h"
#include "sim2d/base/Types.h"

/// Ranges of values in files. Both ends are finite: far wider than any real person, robot or place,
/// yet narrow enough that squares, sums and step counts do not overflow. A key uses one of these
/// unless it has a narrower range.
namespace base {

constexpr double kMaxValue = 1e6;  // for quantities without a range of their own
constexpr double kMinSize = 1e-3;  // [m], [s], [m/s]: of divisors

constexpr Range kCoordinateRange{-kMaxCoordinate, kMaxCoordinate};  // [m], coordinates
constexpr Range kDistance{0.0, kMaxCoordinate};                     // [m]
constexpr Range kLength{kMinSize, kMaxCoordinate};                  // [m], above zero
constexpr Range kBodySize{kMinSize, 100.0};       // [m], radius of a person or robot
constexpr Range kBodyOffsetRange{-100.0, 100.0};  // [m], from the robot's centre
constexpr Range kHeading{-1e6, 1e6};              // [rad], any number of turns
constexpr Range kAngleWidth{0.0, 100.0};          // [rad]
constexpr Range kTime{0.0, 1e6};                  // [s], eleven days
constexpr Range kTimeSpan{kMinSize, 1e6};         // [s], above zero
constexpr Range kRate{0.0, 1e6};                  // [Hz]
constexpr Range kSpeed{0.0, 100.0};               // [m/s]
constexpr Range kPositiveSpeed{kMinSize, 100.0};  // [m/s], [rad/s], above zero
constexpr Range kAcceleration{0.01, 1000.0};      // [m/s²], [rad/s²]
constexpr Range kMass{0.01, 1e5};                 // [kg]
constexpr Range kWeight{0.0, kMaxValue};          // of a cost or a force
constexpr Range kPositiveWeight{1e-6, kMaxValue};
constexpr Range kFactor{-kMaxValue, kMaxValue};  // positive or negative

}  // namespace base

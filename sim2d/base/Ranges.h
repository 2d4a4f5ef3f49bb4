#pragma once

#include "sim2d/base/ParameterSpec.h"
#include "sim2d/base/Types.h"

/// What values of files may be. Each range has two ends: far wider than any person, robot or place,
/// yet so narrow that squares, sums and numbers of steps made of its values stay within what
/// numbers and runs can hold. A key takes one of them where it has no narrower range of its own.
namespace base {

constexpr double kLargestValue = 1e6;   // of whatever has no unit of its own below
constexpr double kSmallestSize = 1e-3;  // [m], [s], [m/s]: of what others are divided by

constexpr Range kWithinReach{-kFarthest, kFarthest};   // [m], a coordinate
constexpr Range kDistance{0.0, kFarthest};             // [m]
constexpr Range kLength{kSmallestSize, kFarthest};     // [m], of what is not nothing
constexpr Range kBodySize{kSmallestSize, 100.0};       // [m], a radius of a person or robot
constexpr Range kOnBody{-100.0, 100.0};                // [m], from the middle of a robot
constexpr Range kHeading{-1e6, 1e6};                   // [rad], any number of turns
constexpr Range kAngleWidth{0.0, 100.0};               // [rad]
constexpr Range kTime{0.0, 1e6};                       // [s], eleven days
constexpr Range kTimeSpan{kSmallestSize, 1e6};         // [s], of what is not nothing
constexpr Range kRate{0.0, 1e6};                       // [Hz]
constexpr Range kSpeed{0.0, 100.0};                    // [m/s]
constexpr Range kSpeedOfMotion{kSmallestSize, 100.0};  // [m/s], [rad/s], of what moves
constexpr Range kAcceleration{0.01, 1000.0};           // [m/s²], [rad/s²]
constexpr Range kMass{0.01, 1e5};                      // [kg]
constexpr Range kWeight{0.0, kLargestValue};           // of a cost or a force
constexpr Range kWeightAboveZero{1e-6, kLargestValue};
constexpr Range kFactor{-kLargestValue, kLargestValue};  // of either sign

}  // namespace base

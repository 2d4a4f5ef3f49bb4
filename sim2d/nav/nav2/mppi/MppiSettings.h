#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/mppi/MppiCriticSettings.h"

/// Parameters of Nav2's MPPI (nav2_mppi_controller::MPPIController).
namespace sim2d::nav2 {

/// The vectorized code computes in single precision.
constexpr float toFloat(double value) {
  return static_cast<float>(value);
}

enum class MppiMotion : std::uint8_t { DiffDrive, Omni, Ackermann };

struct MppiSettings {
  int timeSteps = 56;
  double modelDt = 0.05;  // [s]
  int batchSize = 1000;
  int iterationCount = 1;
  double temperature = 0.3;  // lambda
  double gamma = 0.015;
  double vxMax = 0.5, vxMin = -0.35, vyMax = 0.5;               // [m/s]
  double wzMax = 1.9;                                           // [rad/s]
  double axMax = 3.0, axMin = -3.0, ayMax = 3.0, ayMin = -3.0;  // [m/s²]
  double azMax = 3.5;                                           // [rad/s²]
  double vxStd = 0.2, vyStd = 0.2, wzStd = 0.4;                 // [m/s], [m/s], [rad/s]
  double vxDelay = 0.0, vyDelay = 0.0, wzDelay = 0.0;           // [s]
  std::string motionModel = "DiffDrive";  // main: name of the motion model's block
  double minTurningRadius = 0.2;          // [m]
  int retryAttemptLimit = 1;
  bool regeneratesNoises = false;
  bool isOpenLoop = false;
  bool clampsRawControls = false;
  int sgfOrder = 2;
  double resetPeriod = 1.0;  // [s]
  std::vector<std::string> critics;
  double collisionLookahead = 2.0;  // [s], of the validator
  bool validatesFootprint = false;  // of the validator
  double searchDistance = 0.0;      // [m], 0: half the costmap
  double pruneDistance = 1.5;       // [m]
  bool enforcesInversion = false;
  double inversionXyTolerance = 0.2;   // [m]
  double inversionYawTolerance = 0.4;  // [rad]
};

const std::vector<Nav2Key<MppiSettings>>& mppiKeys();
const std::vector<IgnoredKey>& ignoredMppiKeys();

/// Data from which MPPI is created.
struct MppiConfiguration {
  Distro distro = Distro::Jazzy;
  MppiSettings settings;
  MppiCriticSettings critics;
  MppiMotion motion = MppiMotion::DiffDrive;
};

MppiSettings mppiDefaults(Distro distro);
/// Reads a controller's block and reports all its problems: wrong types, invalid values, unknown
/// critics and motion models.
base::Result<MppiConfiguration> readMppi(const Nav2ParameterBlock& block, Distro distro);
/// The keys of such a block: those of the optimizer, the critics and main's motion model.
Nav2KeyTable mppiKeysOf(const Nav2ParameterBlock& block, Distro distro);

/// How the sequence is shifted between calls, depending on the controller period and model_dt.
enum class MppiShift : std::uint8_t { Refused, Keeps, Shifts };
MppiShift mppiShiftOf(double period, double modelDt);  // [s]

}  // namespace sim2d::nav2

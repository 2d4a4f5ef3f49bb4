#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/base/Ranges.h"

namespace metrics {

/// Corrected: the published formulas, without the known defects of HuNavSim's evaluator. Hunav2:
/// the values of that evaluator, for comparison with published tables.
enum class Profile { Corrected, Hunav2 };
const char* profileName(Profile profile);  // "corrected", "hunav2"
std::optional<Profile> profileOf(std::string_view name);

/// Thresholds of all metrics. SI units, radians; switches are 0 or 1. Names in files and
/// descriptions: parameterInfos().
struct MetricParameters {
  Profile profile = Profile::Corrected;

  double goalTolerance = 0.3;
  double timeLimit = 180.0;
  double contactDistance = 0.02;
  double stopLinearSpeed = 0.01;
  double stopAngularSpeed = 0.02;
  double jerkWindow = 0.75;
  double intimateDistance = 0.45;
  double personalDistance = 1.2;
  double socialDistance = 3.6;
  double groupInteractionDistance = 1.5;
  double groupMinimumMembers = 2;

  double socialFactor = 2.1;
  double socialLambda = 2.0;
  double socialGamma = 0.35;
  double socialN = 2.0;
  double socialNPrime = 3.0;
  double obstacleFactor = 10.0;
  double obstacleSigma = 0.2;
  double personForceParameters = 1;

  double fearCap = 10.0;
  double panicEpsilon = 0.01;
  double fieldOfView = 2.0943951023931953;
  double recognitionTime = 0.15;
  double reactionTime = 0.6;
  double surpriseDistance = 0.45;
  double surpriseMinimumDistance = 0.1;
  double surpriseRequiresMotion = 0;
  double surpriseVisibilityOnlyUnrecognised = 0;

  double complianceDistance = 0.5;
  double progressTolerance = 1e-6;
  double stallSpeed = 0.01;
  double personalRadius = 1.0;
  double facingHalfAngle = 0.08726646259971647;
  double gaussianThreshold = 0.5;
  double discomfortDistance = 0.2;
  double oscillationSpeed = 0.05;
  double oscillationAngularSpeed = 0.15;
  double backwardSpeed = 0.05;
  double inplaceSpeed = 0.005;
  double inplaceAngularSpeed = 0.15;
  double safetyDistance = 0.3;
  double collisionHorizon = 2.0;
  double collisionCap = 10.0;
  double stoppedDistance = 0.05;
  double stoppedWindow = 1.0;
  double disturbanceRadius = 0.28;
  double disturbanceFieldOfView = 3.3161255787892263;
  double disturbanceSpeed = 0.55;
  double crowdRadius = 2.0;
  double crowdInterval = 0.5;
  double laneWidth = 0.75;
  double conflictHorizon = 5.0;
  double conflictMargin = 0.3;
  double flowLineX1 = 0.0, flowLineY1 = 0.0, flowLineX2 = 0.0, flowLineY2 = 0.0;
};

/// Description of a parameter; the fallback is the member's default above.
struct ParameterInfo {
  ParameterInfo(const char* key, double MetricParameters::*itsMember, const char* unit,
                const char* help, const char* users = "", base::Range range = base::kWeight);

  base::ParameterSpec spec;
  double MetricParameters::*member;
  std::string usedBy;  // key prefixes of metrics that use it without naming it in the formula
};
const std::vector<ParameterInfo>& parameterInfos();
const ParameterInfo* findParameter(std::string_view name);

}  // namespace metrics

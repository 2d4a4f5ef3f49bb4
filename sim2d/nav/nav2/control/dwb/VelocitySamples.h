#pragma once

#include <vector>

#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/control/dwb/DwbParameters.h"

/// Velocities that DWB tries (dwb_plugins: velocity_iterator.hpp, one_d_velocity_iterator.hpp).
namespace sim2d::nav2 {

/// What of a target can be reached from v within `dt` [s]; acceleration > 0, deceleration < 0.
double projectVelocity(double v, double acceleration, double deceleration, double dt,
                       double target);

/// One axis of a drive.
struct VelocityAxis {
  double least = 0.0, most = 0.0;  // [m/s] or [rad/s]
  double acceleration = 0.0;       // > 0
  double deceleration = 0.0;       // < 0
};
/// The values tried, least first: about `count` between what can be reached within `time` [s] from
/// v, and 0 where they would jump over it.
std::vector<double> axisSamples(const VelocityAxis& axis, double v, double time, int count);

/// Of the parameters: theta's least is the negative of its most.
VelocityAxis axisX(const DwbParameters& parameters);
VelocityAxis axisY(const DwbParameters& parameters);
VelocityAxis axisTheta(const DwbParameters& parameters);

/// Every combination that may be driven, in Nav2's order: theta fastest, x slowest. Standing still
/// is none. `time` [s] in which they must be reachable.
void velocitySamples(const DwbParameters& parameters, const BodyTwist& now, double time,
                     std::vector<BodyTwist>& samples);

}  // namespace sim2d::nav2

#pragma once

#include <string>

#include "sim2d/nav/nav2/Nav2Key.h"

/// The parameters of a controller that stands in for one of another package. Private to this
/// folder.
namespace sim2d::nav2 {

/// Limits that the replaced controller has, all 0 or above.
struct ReplacedLimits {
  double ahead = 0.5;          // greatest speed [m/s]
  double back = 0.0;           // greatest speed backwards [m/s]
  double turn = 1.0;           // greatest rate of turn [rad/s]
  double acceleration = 2.5;   // [m/s²]
  double turning = 3.2;        // greatest angular acceleration [rad/s²]
  double turningRadius = 0.0;  // of a car [m]; 0: it turns on the spot
};

/// A controller that is re-implemented, and why it is the nearest one.
struct ReplacedController {
  std::string plugin;
  std::string why;
};
/// By the name of the class: TEB and other optimisers of trajectories are MPPI, variants of pure
/// pursuit are Regulated Pure Pursuit, variants of Nav2's controllers are these; any other is DWB.
ReplacedController nearestController(const std::string& type);

/// Its block as YAML, one line per key, with keys that `distro` reads; `rate`: controller_frequency
/// [Hz].
std::string templateOf(const std::string& plugin, Distro distro, const ReplacedLimits& limits,
                       double rate);

}  // namespace sim2d::nav2

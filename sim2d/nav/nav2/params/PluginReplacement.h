#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/params/NodeReader.h"

/// Replaces plugins of other packages by re-implemented ones. Private to this folder.
namespace sim2d::nav2 {

/// Maximum velocities in `velocity_smoother`; none: the file has no such node.
struct VelocityLimits {
  std::optional<double> maxForward;  // [m/s]
  std::optional<double> maxAngular;  // [rad/s]
};
VelocityLimits velocitySmootherLimits(const ParameterFile& file, const std::string& robot);

/// Replaces plugins in a node controller_server that has not been read yet: each controller, goal
/// checker, progress checker and path handler whose class belongs to another package gets the
/// nearest class. Keys that both have keep their values. If a controller has none of the keys of
/// the nearest one, its limits of velocity and acceleration are taken from the names of common
/// packages (`max_vel_x`, `vx_max`, `desired_linear_vel` …), else from `limits`. Each replacement
/// is a warning (nav2.treated-as); a misspelt class is left to the reader.
void replaceControllerPlugins(NodeReader& node, const VelocityLimits& limits);

/// The class that is read instead of `type`: `type` itself when it is known or misspelt, else
/// `fallback`, with a warning; keys outside of `keys` are ignored.
std::string substituteClass(NodeReader& node, const std::string& name, const std::string& type,
                            const std::vector<std::string>& known, const std::string& fallback,
                            const Nav2KeyTable& keys);

/// Default parameters of a controller that replaces one of another package. Private to this folder.

/// Limits of the replaced controller, all >= 0.
struct ControllerLimits {
  double maxForward = 0.5;           // maximum speed [m/s]
  double maxReverse = 0.0;           // maximum reverse speed [m/s]
  double maxAngular = 1.0;           // maximum angular speed [rad/s]
  double acceleration = 2.5;         // [m/s²]
  double angularAcceleration = 3.2;  // maximum angular acceleration [rad/s²]
  double turningRadius = 0.0;        // of a car [m]; 0: it can rotate in place
};

/// A re-implemented controller, and why it is the nearest one.
struct SubstituteController {
  std::string plugin;
  std::string why;
};
/// Selects by the name of the class: MPPI for TEB and other trajectory optimizers, Regulated Pure
/// Pursuit for variants of pure pursuit, Nav2's own controllers for their variants, DWB for all
/// others.
SubstituteController nearestController(const std::string& type);

/// The controller's block as YAML, one line per key, with keys that `distro` reads; `rate`:
/// controller_frequency [Hz].
std::string controllerTemplate(const std::string& plugin, Distro distro,
                               const ControllerLimits& limits, double rate);

}  // namespace sim2d::nav2

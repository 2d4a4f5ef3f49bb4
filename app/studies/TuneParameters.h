#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"

/// The parameters that are tuned, with their ranges.
namespace app {

/// A parameter in a list of parameters to tune.
struct TuningRange {
  std::string name;  // below the controller or planner, or beginning with a node of Nav2
  double low = 0.0, high = 1.0;
  bool isLogarithmic = false;
};

/// A list of parameters to tune (resources/tuning/parameters.yaml describes the format).
struct TuningList {
  using Entries = std::vector<std::pair<std::string, std::vector<TuningRange>>>;
  std::string file;
  Entries controllers;  // by plugin: "nav2_mppi_controller::MPPIController"
  Entries planners;     // of this program, by name

  /// Null: not listed.
  static const std::vector<TuningRange>* find(const Entries& entries, const std::string& name);
};

/// The shipped list.
std::string shippedTuningList();
/// Errors, all with their positions: not such a file, unknown keys, invalid ranges.
base::Result<TuningList> readTuningList(const std::string& path);

/// A parameter that is tuned.
struct TunedParameter {
  TuningRange range;  // extended to contain the current value
  std::string node;   // of Nav2; empty: of a planner
  std::string name;   // "FollowPath.vx_std"; "horizon"
  bool isInteger = false;
  std::string present;  // the value before tuning, as text
  double presentNumber = 0.0;
  std::optional<double> fallback;  // the default in the code of the controller or planner

  /// The value at a share in [0, 1] of the range, with three significant digits.
  std::string textAt(double share) const;
  /// A value as text: a double of ROS 2 has a decimal point.
  std::string textOf(double value) const;
  /// The share of a value in the range, at most 1.
  double shareOf(double value) const;
  /// "controller_server: FollowPath.vx_std".
  std::string label() const { return node.empty() ? name : node + ": " + name; }
};

/// A parameter with this current value. Nothing but numbers can be tuned.
TunedParameter tunedParameter(const TuningRange& range, double present, bool isInteger);

}  // namespace app

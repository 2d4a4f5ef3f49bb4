#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"

namespace base {
struct YamlNode;
}  // namespace base

namespace app {

/// A path of `--set` and what an experiment puts there: a dimension of the grid, or a draw.
struct ExperimentValue {
  enum class Kind { Grid, Normal, Uniform, Choice };

  std::string path;
  Kind kind = Kind::Grid;
  std::vector<std::string> texts;   // Grid: in order; Choice: one of them
  std::array<double, 4> numbers{};  // Normal: mean, deviation, least, most; Uniform: from, to
  bool isRange = false;             // Grid: numbers in equal steps
  bool isDrawn() const { return kind != Kind::Grid; }

  /// Those of `texts` that tell whether all are fine: of a range its ends and one step.
  std::vector<std::size_t> tellingTexts() const;
};

/// What a value is in the runs of one scenario and seed, as files write it: a function of the name
/// of the scenario's file, the seed and the path, of nothing else. So it is the same whatever the
/// other values are: runs that differ by the planner alone meet the same world (common random
/// numbers). Normal numbers are those of the normal distribution between the two ends, uniform ones
/// lie in [from, to).
std::string drawnText(const ExperimentValue& value, const std::string& scenario, long long seed);

/// The values under one path of `values`; problems have the places of what is wrong, without the
/// file. A list and {range: [from, to, step]} are dimensions.
base::Result<ExperimentValue> readExperimentValue(const base::YamlNode& node);

/// What stands behind the path in `values`: "[pursuit, dwa]", "{uniform: [0.0, 1.0]}".
std::string experimentValueText(const ExperimentValue& value);

/// A value as it stands in YAML, lists and maps in one line.
std::string valueText(const base::YamlNode& node);

}  // namespace app

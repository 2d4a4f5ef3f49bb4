#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"

namespace base {
struct YamlNode;
}  // namespace base

namespace app {

struct Design;

/// A path of `--set` with the values of an experiment: a dimension of the grid, a coordinate of the
/// design, or a draw.
struct ExperimentValue {
  enum class Kind { Grid, Between, Normal, Uniform, Choice };

  std::string path;
  Kind kind = Kind::Grid;
  std::vector<std::string> texts;   // Grid: in order; Between: by point; Choice: the options
  std::array<double, 4> numbers{};  // Normal: mean, deviation, min, max; otherwise: from, to
  bool isRange = false;             // the texts are numbers between those of the file
  bool isDrawn() const { return kind > Kind::Between; }

  /// Indices of `texts` that suffice to check all: of a range its ends and one step.
  std::vector<std::size_t> representativeTexts() const;
};

/// The value of a draw for one scenario and seed, as text: a function of the name of the scenario's
/// file, the seed and the path only, so that runs which differ in other values get the same draws
/// (common random numbers). Normal: truncated to [min, max]; uniform: in [from, to).
std::string drawnText(const ExperimentValue& value, const std::string& scenario, long long seed);

/// Sets the texts of all values of the form `between` to the points of the design.
void takeDesignPoints(const Design& design, std::vector<ExperimentValue>& values);

/// Reads the values under one path of `values`; problems have their locations, without the file. A
/// list and {range: [from, to, step]} are dimensions.
base::Result<ExperimentValue> readExperimentValue(const base::YamlNode& node);

/// The text of a value in `values`: "[pursuit, dwa]", "{uniform: [0.0, 1.0]}".
std::string experimentValueText(const ExperimentValue& value);

/// The labels of the texts of a value in tables and figures. A map is labelled with its values,
/// those after the first in brackets, files without folder and extension:
/// "{planner: nav2, nav2_params: ../a.yaml}" becomes "nav2 (a)". Commands keep their words. Other
/// texts are their own labels, and so are all of them if two labels would be equal.
std::vector<std::string> optionLabels(const std::vector<std::string>& texts);

/// Whether one of these texts of a value is a map with this key.
bool isInMap(const std::vector<std::string>& texts, const char* key);
/// Whether the values of a path are planners: of a key `planner`, or maps with this key.
bool arePlanners(const std::string& path, const std::vector<std::string>& texts);

/// The problem with the line and column of a node.
base::Diagnostic located(const base::YamlNode& node, base::Diagnostic problem);

/// Where the text with this number is written in the node of its value: the item of a list, or the
/// whole list if the text is a step of a range.
const base::YamlNode& nodeOfText(const ExperimentValue& value, std::size_t text,
                                 const base::YamlNode& node);

/// The YAML text of a value, lists and maps in one line.
std::string valueText(const base::YamlNode& node);

}  // namespace app

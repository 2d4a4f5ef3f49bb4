#pragma once

#include <vector>

#include "app/run/ExperimentTrial.h"

namespace base {
struct YamlNode;
}  // namespace base

namespace app {

/// What is wrong with the values that could be read, at their places without the file: told twice,
/// not taken by one of the scenarios, or an error of the runs that have them. `values`: the map of
/// them in the file; all texts of lists are tried, of a range and of draws some.
base::Diagnostics invalidValues(const Experiment& experiment, std::vector<ExperimentTrial>& trials,
                                const base::YamlNode& values);

/// Warnings of runs that are the same: with seeds that make no difference in what was tried, or
/// listed twice. `root`: of the whole file.
base::Diagnostics runsAlike(const Experiment& experiment,
                            const std::vector<ExperimentTrial>& trials, const base::YamlNode& root);

}  // namespace app

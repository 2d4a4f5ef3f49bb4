#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

/// The measured values of runs as columns of results.csv.
namespace app {

/// Of one run.
struct ResultValues {
  std::map<std::string, std::string> fields;  // column -> CSV field, empty where undefined
  std::vector<std::string> robots;            // whose columns are prefixed, in order
};

/// Of a run by its metrics.json: the keys of the first robot as they are, those of each other robot
/// with its name and a point in front, "robot2.path_length".
ResultValues resultValues(const std::string& metricsJson);

/// The columns of runs that have these: keys in the order of the registry, first those of the
/// first robot, then those of the others.
std::vector<std::string> resultColumns(const std::set<std::string>& present,
                                       const std::vector<std::string>& robots);

}  // namespace app

#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sim2d/base/ParameterSpec.h"
#include "sim2d/base/Result.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/map/NavigationMap.h"
#include "sim2d/scenario/Scenario.h"

namespace sim2d {

/// Locations of a scenario's files. Precedence: command line, scenario keys, search.
struct FileSearchPaths {
  std::string scenarioPath;  // empty: not saved yet
  std::string mapOption;     // --map; "none" = open plane
  std::string treesOption;   // --trees
  std::string shippedMaps;   // folder of the shipped maps
};

/// Base name of the scenario's files: yaml_base_name, else its file name; "scenario" for standard
/// input.
std::string baseName(const Scenario& scenario, const std::string& path);
/// Path of the scenario's map, or an error with the paths tried. Empty path: open plane.
base::Result<std::string> findMap(const Scenario& scenario, const FileSearchPaths& places);
/// Path of an agent's tree file; empty if there is none: the tree is generated (with a warning
/// where a file could be expected).
std::string findTree(const Scenario& scenario, const Human& human, const FileSearchPaths& places);

/// Static obstacles as parts that can be enabled: part 0 = map, then listed obstacles, then listed
/// doors (enabled if closed). Copies share the navigation layers.
struct Surroundings {
  OccupancyGrid grid;
  Obstacles obstacles;
  std::shared_ptr<NavigationLayerCache> layers = std::make_shared<NavigationLayerCache>();
  int firstObstaclePart = 1;
  int firstDoorPart = 1;
};
/// `stop` cancels this and later path planning (`base::Stopped`), unless a world uses the result.
Surroundings makeSurroundings(
    const Scenario& scenario, OccupancyGrid grid,
    const base::StopFlagPtr& stop = std::make_shared<const base::StopFlag>());

/// The outlines, with the default thickness if none is given.
std::vector<Outline> outlinesOf(const Obstacle& obstacle);
std::vector<Outline> outlinesOf(const Door& door);

/// Names that a scenario may use; knownNames() of sim2d/world returns the registered ones.
struct KnownNames {
  std::vector<std::string> models, planners, robotTypes;
  std::map<std::string, std::vector<base::ParameterSpec>> modelParameters;    // by model
  std::map<std::string, std::vector<base::ParameterSpec>> plannerParameters;  // by planner
};

/// Checks the meaning: starts and goals in walls, unreachable goals, duplicate ids and names,
/// unknown models, planners and references, and what HuNavSim would reject. `file` is the file name
/// in messages; addLocations() adds lines. Obstacles are those of `surroundings`; doors that will
/// open are ignored.
base::Diagnostics checkScenario(const Scenario& scenario, const Surroundings& surroundings,
                                const std::string& file, const KnownNames& names);

/// The largest skin number of a simulator ("Webots": 3); 11 for an unknown one.
int largestSkin(const std::string& simulator);
/// `map` without folder and extension.
std::string mapBaseName(const std::string& map);

}  // namespace sim2d

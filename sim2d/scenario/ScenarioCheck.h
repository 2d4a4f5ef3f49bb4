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

/// Where the files of a scenario lie (command line over block over search).
struct FilePlaces {
  std::string scenarioPath;  // empty: not saved yet
  std::string mapOption;     // --map; "none" = open plane
  std::string treesOption;   // --trees
  std::string shippedMaps;   // folder of the program's own maps
};

/// Names its files: as the scenario says, else as its own file is called; "scenario" for standard
/// input.
std::string baseName(const Scenario& scenario, const std::string& path);
/// The map that belongs to the scenario, or the places tried. An empty path = open plane.
base::Result<std::string> findMap(const Scenario& scenario, const FilePlaces& places);
/// Tree file of a person; an empty path = none found: the generated tree is used (with a warning
/// when the person could have had one).
std::string findTree(const Scenario& scenario, const Human& human, const FilePlaces& places);

/// All that stands in the way, as switchable parts: part 0 = map, then listed obstacles in order,
/// then listed doors in order (closed ones enabled). Copies share what is worked out for routes.
struct Surroundings {
  OccupancyGrid grid;
  Obstacles obstacles;
  std::shared_ptr<NavigationLayers> layers = std::make_shared<NavigationLayers>();
  int firstObstaclePart = 1;
  int firstDoorPart = 1;
};
/// `stop` ends this, and later the work on routes unless a world needs it, by `base::Stopped`.
Surroundings makeSurroundings(
    const Scenario& scenario, OccupancyGrid grid,
    const base::StopFlagPtr& stop = std::make_shared<const base::StopFlag>());

/// The borders of what is drawn, with the usual thickness where none is written.
std::vector<Outline> outlinesOf(const Obstacle& obstacle);
std::vector<Outline> outlinesOf(const Door& door);

/// What a scenario may name: knownNames() of sim2d/world makes it of what is registered.
struct KnownNames {
  std::vector<std::string> models, planners, robotTypes;
  std::map<std::string, std::vector<base::ParameterSpec>> modelParameters;    // by model
  std::map<std::string, std::vector<base::ParameterSpec>> plannerParameters;  // by planner
};

/// Meaning: starts and goals in walls, unreachable goals, ids and names twice, models, planners and
/// references that do not exist, what HuNavSim itself would refuse. `file` names the scenario in
/// messages; addPlaces() gives them lines. Walls are those of `surroundings`; doors that will open
/// do not count.
base::Diagnostics checkScenario(const Scenario& scenario, const Surroundings& surroundings,
                                const std::string& file, const KnownNames& names);

/// The largest skin number of a simulator ("Webots": 3); 11 for one we do not know.
int largestSkin(const std::string& simulator);
/// `map` without folder and extension.
std::string mapBaseName(const std::string& map);

}  // namespace sim2d

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace sim2d {
namespace {

/// Obstacles with fewer points are ignored; the reader has reported them.
bool hasEnoughPoints(const Obstacle& obstacle) {
  const bool isLine = obstacle.kind == ObstacleKind::Wall;
  return obstacle.points.size() >= (isLine ? 2 : obstacle.kind == ObstacleKind::Polygon ? 3 : 0);
}

namespace fs = std::filesystem;

fs::path folderOf(const FileSearchPaths& places) {
  return fs::path(places.scenarioPath).parent_path();
}

std::string normalized(const fs::path& path) {
  return path.lexically_normal().string();
}

bool isFile(const std::string& path) {
  std::error_code ignored;  // counts as missing if not accessible
  return fs::is_regular_file(path, ignored);
}

/// The first existing file; empty if there is none.
std::string firstFile(const std::vector<std::string>& paths) {
  const auto found = std::find_if(paths.begin(), paths.end(), isFile);
  return found == paths.end() ? std::string() : *found;
}

base::Diagnostic noMap(const FileSearchPaths& places, const char* code,
                       base::ProblemValues values) {
  base::Diagnostic problem = base::error(code, std::move(values), places.scenarioPath);
  problem.entity = {base::EntityKind::Scenario, 0};
  return problem;
}

base::Result<std::string> explicitPath(const FileSearchPaths& places, const char* key,
                                       const std::string& name, const fs::path& path) {
  if (isFile(normalized(path))) {
    return normalized(path);
  }
  std::error_code ignored;
  const bool isFolder = fs::is_directory(path, ignored);
  return noMap(places, isFolder ? "map.is-folder" : "map.not-there", {key, name, normalized(path)});
}

std::string treeName(const Scenario& scenario, const Human& human, const FileSearchPaths& places) {
  return baseName(scenario, places.scenarioPath) + "__agent_" + std::to_string(human.id) +
         "_bt.xml";
}

/// Omits shapes that are partly out of range; the check reports them.
std::vector<Outline> withinCoordinateRange(std::vector<Outline> outlines) {
  const bool isGood = std::all_of(outlines.begin(), outlines.end(), [](const Outline& outline) {
    return std::all_of(outline.points.begin(), outline.points.end(), base::isWithinCoordinateRange);
  });
  return isGood ? std::move(outlines) : std::vector<Outline>();
}

}  // namespace

std::string baseName(const Scenario& scenario, const std::string& path) {
  const std::string stem = fs::path(path).stem().string();
  return scenario.yamlBaseName.value_or(stem.empty() || stem == "-" ? "scenario" : stem);
}

std::vector<Outline> outlinesOf(const Obstacle& obstacle) {
  switch (obstacle.kind) {
    case ObstacleKind::Box:
      return {boxOutline(obstacle.pose, obstacle.length, obstacle.width)};
    case ObstacleKind::Circle:
      return {circleOutline(obstacle.pose.position, obstacle.radius)};
    case ObstacleKind::Polygon:
      return {polygonOutline(obstacle.points)};
    case ObstacleKind::Wall:
      break;
  }
  return wallOutlines(obstacle.points, obstacle.thickness.value_or(0.1));
}

std::vector<Outline> outlinesOf(const Door& door) {
  return wallOutlines({door.from, door.to}, door.thickness.value_or(0.05));
}

Surroundings makeSurroundings(const Scenario& scenario, OccupancyGrid grid,
                              const base::StopFlagPtr& stop) {
  Surroundings result;
  result.layers = std::make_shared<NavigationLayerCache>(stop);
  result.obstacles.add(traceOutlines(grid, *stop), true, /*isOfMap=*/true);
  result.grid = std::move(grid);
  const std::vector<Outline> none;
  forEachListed(scenario.obstacles, [&](const Obstacle& obstacle) {
    result.obstacles.add(hasEnoughPoints(obstacle) ? withinCoordinateRange(outlinesOf(obstacle))
                                                   : none);
  });
  result.firstDoorPart = result.obstacles.partCount();
  forEachListed(scenario.doors, [&](const Door& door) {
    result.obstacles.add(door.from == door.to ? none : withinCoordinateRange(outlinesOf(door)),
                         !door.open.value_or(true));
  });
  result.obstacles.build(*stop);
  return result;
}

std::string mapBaseName(const std::string& map) {
  const fs::path name = fs::path(map).filename();
  static const std::vector<std::string> kExtensions = {".yaml", ".yml", ".pgm", ".png",
                                                       ".bmp",  ".jpg", ".jpeg"};
  const std::string extension = base::toLower(name.extension().string());
  const bool isKnown =
      std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
  return (isKnown ? name.stem() : name).string();
}

base::Result<std::string> findMap(const Scenario& scenario, const FileSearchPaths& places) {
  if (places.mapOption == "none") {
    return std::string();
  }
  if (!places.mapOption.empty()) {
    return explicitPath(places, "map", places.mapOption, places.mapOption);
  }
  if (scenario.desktop.mapFile) {
    const std::string& file = *scenario.desktop.mapFile;
    return file == "none" ? base::Result<std::string>(std::string())
                          : explicitPath(places, "map_file", file, folderOf(places) / file);
  }
  const std::string name = mapBaseName(scenario.map.value_or(""));
  if (name.empty()) {
    return noMap(places, "map.not-named", {});
  }
  std::vector<std::string> tried;
  if (!places.scenarioPath.empty()) {
    tried.push_back(normalized(folderOf(places) / (name + ".yaml")));
    tried.push_back(normalized(folderOf(places) / ".." / "maps" / (name + ".yaml")));
  }
  if (!places.shippedMaps.empty()) {
    tried.push_back(normalized(fs::path(places.shippedMaps) / name / (name + ".yaml")));
  }
  const std::string found = firstFile(tried);
  return !found.empty() ? base::Result<std::string>(found)
                        : noMap(places, "map.not-found", {name, base::join(tried, ", ")});
}

std::string findTree(const Scenario& scenario, const Human& human, const FileSearchPaths& places) {
  if (human.ours.tree) {
    return normalized(folderOf(places) /
                      *human.ours.tree);  // must exist; its reader reports an error
  }
  const std::string name = treeName(scenario, human, places);
  std::vector<std::string> tried;
  if (!places.treesOption.empty()) {
    tried.push_back(normalized(fs::path(places.treesOption) / name));
  }
  if (!places.scenarioPath.empty()) {
    tried.push_back(normalized(folderOf(places) / name));
    tried.push_back(normalized(folderOf(places) / ".." / "behavior_trees" / name));
  }
  return firstFile(tried);
}

}  // namespace sim2d

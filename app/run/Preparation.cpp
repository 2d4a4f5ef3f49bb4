#include "app/run/Preparation.h"

#include <algorithm>
#include <filesystem>

#include "app/run/DataPaths.h"
#include "bt/human/TreeBehavior.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/TextPlaces.h"

namespace app {

namespace {

sim2d::FilePlaces placesOf(const RunOptions& options) {
  sim2d::FilePlaces places;
  places.scenarioPath = options.scenario;
  places.mapOption = options.map;
  places.treesOption = options.trees;
  places.shippedMaps = shippedMapsFolder();
  return places;
}

sim2d::KnownNames knownNames() {
  sim2d::KnownNames names;
  names.models = sim2d::modelNames();
  names.planners = sim2d::plannerNames();
  names.robotTypes = sim2d::robotTypeNames();
  return names;
}

bool readMapOf(Preparation& preparation, const sim2d::FilePlaces& places,
               const sim2d::ImageLoader& loader) {
  const sim2d::Scenario& scenario = *preparation.scenario;
  const base::Result<std::string> path = sim2d::findMap(scenario, places);
  base::Diagnostics problems = path.diagnostics();
  sim2d::addPlaceOfMap(problems, places.scenarioPath);
  base::append(preparation.diagnostics, problems);
  if (!path || path->empty()) {
    return bool(path);
  }
  base::Result<sim2d::MapFile> file =
      readMapFile(*path, scenario.desktop.mapRule.value_or("humble"), loader);
  base::append(preparation.diagnostics, file.diagnostics());
  if (!file) {
    return false;
  }
  preparation.inputs.push_back(file->path);
  preparation.inputs.push_back(file->imagePath);
  preparation.map = std::move(file->grid);
  return true;
}

/// People without a tree file get that of their behaviour; the reader is told.
void tellGenerated(Preparation& preparation, const std::vector<std::string>& names) {
  if (names.empty()) {
    return;
  }
  constexpr std::size_t kNamed = 3;
  std::vector<std::string> first(names.begin(), names.begin() + std::min(kNamed, names.size()));
  const std::string more = names.size() > kNamed ? " …" : "";
  base::Diagnostics told = {base::makeWarning("no tree file for " + std::to_string(names.size()) +
                                                  (names.size() == 1 ? " person (" : " people (") +
                                                  base::join(first, ", ") + more +
                                                  "): the tree of the behaviour is generated",
                                              preparation.inputs.front())};
  sim2d::addPlaceOfKey(told, preparation.inputs.front(), {"hunav_loader.ros__parameters.agents"});
  base::append(preparation.diagnostics, told);
}

bool hasTreesFolder(Preparation& preparation, const std::string& folder) {
  std::error_code ignored;
  if (folder.empty() || std::filesystem::is_directory(folder, ignored)) {
    return true;
  }
  preparation.diagnostics.push_back(base::makeError("--trees: this is no folder", folder));
  return false;
}

void findTrees(Preparation& preparation, const sim2d::FilePlaces& places) {
  std::vector<std::string> generated;
  for (const sim2d::Human& human : preparation.scenario->humans) {
    if (!human.listed) {
      continue;
    }
    const std::string path = sim2d::findTree(*preparation.scenario, human, places);
    preparation.treePaths[human.name] = path;
    if (path.empty()) {
      generated.push_back(human.name);
    } else {
      preparation.inputs.push_back(path);
    }
  }
  if (hasTreesFolder(preparation, places.treesOption)) {
    tellGenerated(preparation, generated);
  }
}

}  // namespace

base::Result<sim2d::MapFile> readMapFile(const std::string& path, const std::string& rule,
                                         const sim2d::ImageLoader& loader) {
  return sim2d::readMap(path, loader,
                        rule == "main" ? sim2d::MapRule::Main : sim2d::MapRule::Humble);
}

Preparation prepare(const RunOptions& options, const sim2d::Compatibility& compatibility,
                    const sim2d::ImageLoader& loader) {
  Preparation preparation;
  preparation.compatibility = compatibility;
  preparation.inputs.push_back(options.scenario);
  sim2d::ScenarioReading reading = sim2d::readScenario(options.scenario);
  preparation.diagnostics = reading.diagnostics;
  if (reading.ok()) {
    preparation.wrongWords = applyOptions(reading.scenario, options, compatibility);
  }
  preparation.scenario = std::make_shared<const sim2d::Scenario>(std::move(reading.scenario));
  const bool isScenario = reading.ok() || !preparation.scenario->humans.empty();
  if (!isScenario || base::hasErrors(preparation.wrongWords)) {
    return preparation;
  }
  const sim2d::FilePlaces places = placesOf(options);
  const bool hasMap = readMapOf(preparation, places, loader);
  findTrees(preparation, places);
  // Without the map, and for places that were wrong in the file and stand somewhere else now, there
  // are no walls to be in.
  const sim2d::Surroundings surroundings =
      hasMap && reading.ok() ? sim2d::makeSurroundings(*preparation.scenario, preparation.map)
                             : sim2d::Surroundings();
  base::Diagnostics meaning =
      sim2d::checkScenario(*preparation.scenario, surroundings, options.scenario, knownNames());
  sim2d::addLines(meaning, reading.lines);
  sim2d::addColumns(meaning, options.scenario);
  base::append(preparation.diagnostics, meaning);
  base::Diagnostics trees;
  bt::makeTreeBehavior(*preparation.scenario, preparation.treePaths, trees, compatibility);
  base::append(preparation.diagnostics, trees);
  return preparation;
}

base::Result<std::unique_ptr<sim2d::World>> makeWorld(const Preparation& preparation,
                                                      const RunOptions& options) {
  base::Diagnostics known;  // told by prepare
  sim2d::WorldSetup setup;
  setup.scenario = preparation.scenario;
  setup.map = preparation.map;
  setup.compatibility = preparation.compatibility;
  setup.threads = options.threads;
  setup.exact = options.exact;
  setup.behavior = bt::makeTreeBehavior(*preparation.scenario, preparation.treePaths, known,
                                        preparation.compatibility);
  if (!setup.behavior) {
    return known;
  }
  return sim2d::World::create(std::move(setup));
}

}  // namespace app

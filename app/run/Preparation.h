#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/run/RunOptions.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/world/World.h"

namespace app {

/// Everything a run reads, found and checked. With errors among the diagnostics there is no run.
struct Preparation {
  std::shared_ptr<const sim2d::Scenario> scenario;
  sim2d::OccupancyGrid map;
  sim2d::Compatibility compatibility;
  std::map<std::string, std::string> treePaths;  // of each person; empty = the generated tree
  std::vector<std::string> inputs;               // files read, for the manifest
  base::Diagnostics wrongWords;  // options that do not fit: the command line is wrong
  base::Diagnostics diagnostics;
  bool ok() const { return !base::hasErrors(diagnostics); }
};

/// Scenario, map and trees of `run` and `check`: every problem of all of them, not only the first.
/// `loader` reads map images other than PGM.
Preparation prepare(const RunOptions& options, const sim2d::Compatibility& compatibility,
                    const sim2d::ImageLoader& loader);

/// The world of a preparation without errors.
base::Result<std::unique_ptr<sim2d::World>> makeWorld(const Preparation& preparation,
                                                      const RunOptions& options);

/// The map at `path`; "none" or empty = open plane.
base::Result<sim2d::MapFile> readMapFile(const std::string& path, const std::string& rule,
                                         const sim2d::ImageLoader& loader);

}  // namespace app

#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/run/KnownFiles.h"
#include "app/run/RunOptions.h"
#include "bt/human/TreeBehavior.h"
#include "sim2d/world/World.h"

namespace app {

/// A scenario with all that a run of it takes, in memory: read from files, or as the window has it.
struct Bundle {
  std::string path;  // of the scenario's file, which names it in messages; empty = in none
  std::shared_ptr<const sim2d::Scenario> scenario;
  bool isWhole = true;       // false: the file could be read in part only
  bool isBeginning = false;  // of a damaged file: what that means alone would mislead
  std::shared_ptr<const sim2d::OccupancyGrid> map;  // null: there should be one; empty: open plane
  std::shared_ptr<KnownSurroundings> known = std::make_shared<KnownSurroundings>();  // of both
  std::shared_ptr<metrics::KnownRoutes> routes;  // of runs before on the map; null: none
  base::StopFlagPtr stop = std::make_shared<const base::StopFlag>();  // of the work on the map
  base::StopFlagPtr left = std::make_shared<const base::StopFlag>();  // of one run: ends its making
                                                                      // and the waiting in it
  std::string mapPath;  // of the map's YAML; empty: in none
  int comments = 0;     // in the scenario file
  bt::TreeFiles trees;
  std::shared_ptr<bt::KnownTrees> knownTrees;  // of runs before; null: none
  MetricsWords metrics;
  RunSettings settings;
  std::map<base::EntityId, int> lines;  // where entities stand in the file
  std::vector<std::string> inputs;      // files that were read, for the manifest
  base::Diagnostics wrongWords;         // options that do not fit: the command line is wrong
  base::Diagnostics remarks;            // of reading it all
  bool hasScenario() const { return isWhole || (!isBeginning && !scenario->humans.empty()); }
};

/// The scenario of `options` with its map and trees, and the options written into it. `loader`
/// reads map images other than PGM.
Bundle readBundle(const RunOptions& options, const RunSettings& settings,
                  const sim2d::ImageLoader& loader);
/// The same for one of many runs.
Bundle readBundle(const RunOptions& options, const RunSettings& settings, KnownFiles& files);

/// What is said of a bundle, and the run that it makes.
struct Verdict {
  base::Diagnostics problems;      // the bundle's remarks first; with errors there is no run
  base::Diagnostics worldRemarks;  // of the world: what stands elsewhere than written …
  base::Diagnostics wrongWords;    // also unknown metrics of the command line
  MetricsSetup scenarioMetrics, metrics;
  std::unique_ptr<sim2d::World> world;  // null: there is no run
  /// With CheckDepth::Setup: what a world is made of; nothing when there is none to make.
  std::optional<sim2d::WorldSetup> setup;
  bool ok() const { return !base::hasErrors(problems) && !base::hasErrors(wrongWords); }
};

/// How far a check goes.
enum class CheckDepth { Meaning, Setup, World };

/// Meaning of the scenario, trees, metrics; at last the world, when nothing is wrong until then.
/// Every way to run, and every list of problems, comes from here. Any thread; reads metrics files
/// and what trees in files hold. Throws `base::Stopped` when a flag of the bundle says so.
Verdict check(const Bundle& bundle, CheckDepth depth = CheckDepth::World);

/// Those that are errors.
base::Diagnostics errorsOf(const base::Diagnostics& problems);

}  // namespace app

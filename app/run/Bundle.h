#pragma once

#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/run/RunSpec.h"
#include "bt/human/TreeBehavior.h"
#include "metrics/ShortestPaths.h"
#include "sim2d/base/Result.h"
#include "sim2d/base/StopFlag.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/world/World.h"

namespace app {

/// Caches the surroundings of one document; recomputes them only when map, obstacles, doors or the
/// stop flag change. Thread: any.
class SurroundingsCache {
 public:
  std::shared_ptr<const sim2d::Surroundings> of(
      const sim2d::Scenario& scenario, const std::shared_ptr<const sim2d::OccupancyGrid>& map,
      const base::StopFlagPtr& stop);

 private:
  std::mutex mutex_;
  std::shared_ptr<const sim2d::OccupancyGrid> map_;
  std::vector<sim2d::Obstacle> obstacles_;
  std::vector<sim2d::Door> doors_;
  base::StopFlagPtr stop_;
  std::shared_ptr<const sim2d::Surroundings> surroundings_;
};

/// A map with the data derived from it.
struct CachedMap {
  base::Diagnostics problems;
  std::string path, imagePath;
  std::shared_ptr<const sim2d::OccupancyGrid> grid;  // null: it cannot be read
  std::shared_ptr<SurroundingsCache> surroundings = std::make_shared<SurroundingsCache>();
  std::shared_ptr<metrics::ShortestPathCache> routes =
      std::make_shared<metrics::ShortestPathCache>();
};

/// Caches scenarios, maps and trees that several runs share: each is read on first use. The most
/// recently used ones stay in memory. One thread.
class FileCache {
 public:
  /// `loader` reads map images other than PGM.
  explicit FileCache(sim2d::ImageLoader loader) : loader_(std::move(loader)) {}

  std::shared_ptr<const sim2d::ScenarioReading> scenario(const std::string& path);
  /// Uses this scenario for the file `path`, which need not exist, until it is evicted.
  void setScenario(const std::string& path, sim2d::ScenarioReading reading);
  /// `rule`: name of the Nav2 map rule; an empty path is the open plane.
  std::shared_ptr<const CachedMap> map(const std::string& path, const std::string& rule);
  const std::shared_ptr<bt::TreeCache>& trees() const { return trees_; }
  const base::StopFlagPtr& stopFlag() const { return stop_; }

 private:
  template <class Key, class Value>
  using LruList = std::list<std::pair<Key, std::shared_ptr<const Value>>>;  // latest use first

  const sim2d::ImageLoader loader_;
  const base::StopFlagPtr stop_ = std::make_shared<const base::StopFlag>();
  const std::shared_ptr<bt::TreeCache> trees_ = bt::makeTreeCache();
  LruList<std::string, sim2d::ScenarioReading> scenarios_;
  LruList<std::pair<std::string, std::string>, CachedMap> maps_;  // by path and rule
};

/// Reads the map at `path` by the Nav2 map rule of this name.
base::Result<sim2d::MapFile> readMapFile(const std::string& path, const std::string& rule,
                                         const sim2d::ImageLoader& loader);

/// Returns `some` without diagnostics for which `all` contains an equivalent one: reading, trees
/// and world creation report some problems that the scenario check also reports, with other text.
base::Diagnostics withoutDuplicates(const base::Diagnostics& some, const base::Diagnostics& all);

/// Returns the diagnostics of `more` whose text does not occur in `reported`.
base::Diagnostics newDiagnostics(const base::Diagnostics& reported, const base::Diagnostics& more);

/// A scenario with all inputs of a run, in memory: read from files, or from the document of the
/// window.
struct Bundle {
  std::string path;  // of the scenario file, also used in messages; empty: not in a file
  std::shared_ptr<const sim2d::Scenario> scenario;
  bool isWhole = true;       // false: only a part of the file could be read
  bool isBeginning = false;  // only the beginning of a damaged file: not checked further
  std::shared_ptr<const sim2d::OccupancyGrid> map;  // null: unreadable; empty: open plane
  // Of scenario and map.
  std::shared_ptr<SurroundingsCache> known = std::make_shared<SurroundingsCache>();
  std::shared_ptr<metrics::ShortestPathCache> routes;  // of earlier runs on the map; null: none
  base::StopFlagPtr stop = std::make_shared<const base::StopFlag>();  // stops work on the map
  // Of one run: cancels the creation of its world, and waiting in it.
  base::StopFlagPtr stopOfRun = std::make_shared<const base::StopFlag>();
  std::string mapPath;  // of the map's YAML file; empty: not in a file
  std::string mapImagePath;
  int comments = 0;  // in the scenario file
  bt::TreeFiles trees;
  std::shared_ptr<bt::TreeCache> knownTrees;  // of earlier runs; null: none
  MetricsOptions metrics;
  RunSettings settings;
  std::map<base::EntityId, int> lines;  // first line of each entity in the file
  std::vector<std::string> inputs;      // files that were read, for the manifest
  base::Diagnostics wrongOptions;       // invalid options: the command line is wrong
  base::Diagnostics remarks;            // of reading all of this
  bool hasScenario() const { return isWhole || (!isBeginning && !scenario->humans.empty()); }
};

/// The scenario of a run with its map and trees and the options applied to it. `loader` reads map
/// images other than PGM.
Bundle readBundle(const RunSpec& spec, const RunSettings& settings,
                  const sim2d::ImageLoader& loader);
/// The same for one of many runs.
Bundle readBundle(const RunSpec& spec, const RunSettings& settings, FileCache& files);

/// The result of checking a bundle, and the world of its run.
struct Verdict {
  base::Diagnostics problems;      // the bundle's remarks first; with errors no run is possible
  base::Diagnostics worldRemarks;  // of creating the world: bodies that were moved …
  base::Diagnostics wrongOptions;  // also unknown metrics of the command line
  MetricsSetup scenarioMetrics, metrics;
  std::unique_ptr<sim2d::World> world;  // null: no run is possible
  /// With CheckDepth::Setup: the setup of the world; nullopt with errors.
  std::optional<sim2d::WorldSetup> setup;
  bool ok() const { return !base::hasErrors(problems) && !base::hasErrors(wrongOptions); }
};

/// How far a check goes.
enum class CheckDepth { Meaning, Setup, World };

/// Checks the meaning of the scenario, trees and metrics, and creates the world if there are no
/// errors. All runs and all lists of problems come from this function. Any thread; reads metrics
/// files and the trees in files. Throws `base::Stopped` when a stop flag of the bundle is set.
Verdict check(const Bundle& bundle, CheckDepth depth = CheckDepth::World);

/// Updates the list of files that the bundle was read from, after its scenario has changed.
void listInputs(Bundle& bundle);

/// Those that are errors.
base::Diagnostics errorsOf(const base::Diagnostics& problems);

}  // namespace app

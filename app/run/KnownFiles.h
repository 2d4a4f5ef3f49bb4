#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "bt/human/TreeBehavior.h"
#include "metrics/Routes.h"
#include "sim2d/base/Stop.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

/// Surroundings in one document, worked out anew only when map, obstacles, doors or the flag that
/// ends the work are others. Thread: any.
class KnownSurroundings {
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

/// A map with what follows from it.
struct KnownMap {
  base::Diagnostics problems;
  std::string path, imagePath;
  std::shared_ptr<const sim2d::OccupancyGrid> grid;  // null: it cannot be read
  std::shared_ptr<KnownSurroundings> surroundings = std::make_shared<KnownSurroundings>();
  std::shared_ptr<metrics::KnownRoutes> routes = std::make_shared<metrics::KnownRoutes>();
};

/// Scenarios, maps and trees that many runs have in common: each is read when it is first asked
/// for. Of each the few that were asked for last stay in memory. One thread.
class KnownFiles {
 public:
  /// `loader` reads map images other than PGM.
  explicit KnownFiles(sim2d::ImageLoader loader) : loader_(std::move(loader)) {}

  std::shared_ptr<const sim2d::ScenarioReading> scenario(const std::string& path);
  /// By the rule of nav2 of this name; an empty path is the open plane.
  std::shared_ptr<const KnownMap> map(const std::string& path, const std::string& rule);
  const std::shared_ptr<bt::KnownTrees>& trees() const { return trees_; }
  const base::StopFlagPtr& stopFlag() const { return stop_; }

 private:
  template <class Key, class Value>
  using Shelf = std::list<std::pair<Key, std::shared_ptr<const Value>>>;  // last used first

  const sim2d::ImageLoader loader_;
  const base::StopFlagPtr stop_ = std::make_shared<const base::StopFlag>();
  const std::shared_ptr<bt::KnownTrees> trees_ = bt::makeKnownTrees();
  Shelf<std::string, sim2d::ScenarioReading> scenarios_;
  Shelf<std::pair<std::string, std::string>, KnownMap> maps_;  // by path and rule
};

/// The map at `path` by the rule of nav2 of this name.
base::Result<sim2d::MapFile> readMapFile(const std::string& path, const std::string& rule,
                                         const sim2d::ImageLoader& loader);

}  // namespace app

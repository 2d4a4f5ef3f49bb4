#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "bt/human/TreeBehavior.h"
#include "metrics/ShortestPaths.h"
#include "sim2d/base/StopFlag.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"

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

}  // namespace app

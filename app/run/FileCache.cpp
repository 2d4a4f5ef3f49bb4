#include "app/run/FileCache.h"

#include <algorithm>

namespace app {

namespace {

constexpr std::size_t kMaxKept = 4;

/// Returns the value for the key, created if missing, and makes it the most recently used one.
template <class Key, class Value, class Make>
std::shared_ptr<const Value> fetch(std::list<std::pair<Key, std::shared_ptr<const Value>>>& shelf,
                                   const Key& key, Make make) {
  const auto found = std::find_if(shelf.begin(), shelf.end(),
                                  [&key](const auto& each) { return each.first == key; });
  if (found != shelf.end()) {
    shelf.splice(shelf.begin(), shelf, found);
  } else {
    shelf.emplace_front(key, make());
    shelf.resize(std::min(shelf.size(), kMaxKept));
  }
  return shelf.front().second;
}

}  // namespace

std::shared_ptr<const sim2d::Surroundings> SurroundingsCache::of(
    const sim2d::Scenario& scenario, const std::shared_ptr<const sim2d::OccupancyGrid>& map,
    const base::StopFlagPtr& stop) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool isKnown = surroundings_ != nullptr && map_ == map && stop_ == stop &&
                       obstacles_ == scenario.obstacles && doors_ == scenario.doors;
  if (!isKnown) {
    surroundings_ =
        std::make_shared<const sim2d::Surroundings>(sim2d::makeSurroundings(scenario, *map, stop));
    stop_ = stop;
    map_ = map;
    obstacles_ = scenario.obstacles;
    doors_ = scenario.doors;
  }
  return surroundings_;
}

std::shared_ptr<const sim2d::ScenarioReading> FileCache::scenario(const std::string& path) {
  return fetch(scenarios_, path, [&path] {
    return std::make_shared<const sim2d::ScenarioReading>(sim2d::readScenario(path));
  });
}

std::shared_ptr<const CachedMap> FileCache::map(const std::string& path, const std::string& rule) {
  return fetch(maps_, std::pair(path, rule), [&] {
    auto known = std::make_shared<CachedMap>();
    if (path.empty()) {
      known->grid = std::make_shared<const sim2d::OccupancyGrid>();
      return known;
    }
    base::Result<sim2d::MapFile> file = readMapFile(path, rule, loader_);
    known->problems = file.diagnostics();
    if (file) {
      known->path = file->path;
      known->imagePath = file->imagePath;
      known->grid = std::make_shared<const sim2d::OccupancyGrid>(std::move(file->grid));
    }
    return known;
  });
}

base::Result<sim2d::MapFile> readMapFile(const std::string& path, const std::string& rule,
                                         const sim2d::ImageLoader& loader) {
  return sim2d::readMap(path, loader,
                        rule == "main" ? sim2d::MapRule::Main : sim2d::MapRule::Humble);
}

}  // namespace app

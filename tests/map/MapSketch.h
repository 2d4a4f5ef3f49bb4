#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "sim2d/map/PathPlanner.h"

/// Small maps drawn by hand, for tests of ways.
namespace sketch {

using namespace sim2d;

struct Scene {
  Obstacles obstacles;
  std::shared_ptr<const DistanceField> field;
};

inline Scene sceneOf(const OccupancyGrid& grid, const std::vector<std::vector<Outline>>& parts = {},
                     const std::vector<Vec2>& bounds = {},
                     double mostCells = DistanceField::kMaxCells) {
  Scene scene;
  scene.obstacles.add(traceOutlines(grid), true, /*isOfMap=*/true);
  for (const auto& part : parts) {
    scene.obstacles.add(part);
  }
  scene.obstacles.build();
  scene.field = std::make_shared<const DistanceField>(grid, scene.obstacles, bounds, mostCells);
  return scene;
}

/// A free map with rectangles of wall or of unknown cells, given in metres.
class MapSketch {
 public:
  MapSketch(double width, double height, double resolution = 0.05)
      : columns_(static_cast<int>(std::lround(width / resolution))),
        rows_(static_cast<int>(std::lround(height / resolution))),
        resolution_(resolution),
        cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}

  MapSketch& fill(const Vec2& low, const Vec2& high, int value = 100) {
    for (int row = cellOf(low.y()); row < cellOf(high.y()); ++row) {
      for (int column = cellOf(low.x()); column < cellOf(high.x()); ++column) {
        cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column)] = static_cast<std::int8_t>(value);
      }
    }
    return *this;
  }

  OccupancyGrid grid() const { return OccupancyGrid(columns_, rows_, resolution_, {}, cells_); }

 private:
  int cellOf(double metres) const { return static_cast<int>(std::lround(metres / resolution_)); }

  int columns_;
  int rows_;
  double resolution_;
  std::vector<std::int8_t> cells_;
};

/// 10 m x 10 m with walls of one or two cells and some unknown ground.
inline OccupancyGrid randomMap(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0.0, 9.0);
  std::uniform_real_distribution<double> size(0.05, 2.5);
  MapSketch sketch(10.0, 10.0);
  for (int i = 0; i < 22; ++i) {
    const Vec2 low(place(random), place(random));
    const Vec2 extent = i % 2 == 0 ? Vec2(size(random), 0.1) : Vec2(0.05, size(random));
    sketch.fill(low, (low + extent).cwiseMin(Vec2(10.0, 10.0)), i % 7 == 6 ? -1 : 100);
  }
  return sketch.grid();
}

inline double lowestClearance(const Scene& scene, const std::vector<Vec2>& path) {
  double lowest = 1e9;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 leg = path[i] - path[i - 1];
    const int steps = static_cast<int>(leg.norm() / 0.01) + 1;
    for (int n = 0; n <= steps; ++n) {
      const Vec2 point = path[i - 1] + static_cast<double>(n) / steps * leg;
      lowest = std::min(lowest, scene.obstacles.clearance(point, 0.7));
    }
  }
  return lowest;
}

}  // namespace sketch

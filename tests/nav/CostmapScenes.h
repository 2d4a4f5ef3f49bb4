#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/costmap/LayeredCostmap.h"

/// Small costmaps for tests: cells of 1 m unless told, and beams one by one.
namespace costmapscenes {

using namespace sim2d::nav2;
using sim2d::Cell;
using sim2d::LaserScan;
using sim2d::Observation;
using sim2d::OccupancyGrid;

/// A costmap of that side [m] from the origin, without layers, updated whenever it is asked.
inline CostmapSetup plainSetup(int side, double resolution = 1.0) {
  CostmapSetup setup;
  CostmapParameters& parameters = setup.settings.parameters;
  parameters.width = side;
  parameters.height = side;
  parameters.resolution = resolution;
  parameters.footprintPadding = 0.0;
  return setup;
}

/// As the unit tests of nav2 make them: every scan stays, all ranges are 100 m.
inline ObservationSource farSource() {
  ObservationSource source;
  source.observationPersistence = 1e6;
  source.maxObstacleHeight = 100.0;
  source.clearing = true;
  source.obstacleMaxRange = 100.0;
  source.raytraceMaxRange = 100.0;
  return source;
}

/// The same with the newest scan alone.
inline ObservationSource newestSource() {
  ObservationSource source = farSource();
  source.observationPersistence = 0.0;
  return source;
}

inline ObstacleLayerParameters obstacleLayer(const ObservationSource& source = farSource()) {
  ObstacleLayerParameters parameters;
  parameters.footprintClearingEnabled = false;
  parameters.sources = {source};
  return parameters;
}

inline InflationLayerParameters inflationLayer(double radius, double scaling = 1.0) {
  InflationLayerParameters parameters;
  parameters.inflationRadius = radius;
  parameters.costScalingFactor = scaling;
  return parameters;
}

/// Rows from the top: '#' occupied, '.' free, '?' unknown, '1' to '9' tens of percent.
inline OccupancyGrid gridOf(const std::vector<std::string>& rows, double resolution = 1.0,
                            const Vec2& origin = {0.0, 0.0}) {
  std::vector<std::int8_t> cells;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) {
      const int tens = c >= '1' && c <= '9' ? 10 * (c - '0') : 0;
      cells.push_back(static_cast<std::int8_t>(c == '#' ? 100 : c == '?' ? -1 : tens));
    }
  }
  return OccupancyGrid(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), resolution,
                       {origin, 0.0}, cells);
}

/// Twenty walls, as the map TenByTen of nav2's tests has them in other places.
inline OccupancyGrid tenByTen() {
  return gridOf({"......####", "......#..#", "......####", "..........", "..####....", "..........",
                 "..........", ".......##.", ".......##.", "......##.."});
}

/// One beam from a place to a point.
inline LaserScan beamTo(const Vec2& from, const Vec2& to, double time) {
  LaserScan scan;
  const Vec2 way = to - from;
  scan.sensor.position = from;
  scan.time = time;
  scan.angleMin = base::atan2(way.y(), way.x());
  scan.range = 1000.0;
  scan.distances = {way.norm()};
  return scan;
}

/// A whole turn of beams of the same length.
inline LaserScan turnOf(const Vec2& from, int beams, double distance, double time) {
  LaserScan scan;
  scan.sensor.position = from;
  scan.time = time;
  scan.angleMin = -base::kPi;
  scan.angleIncrement = 2.0 * base::kPi / beams;
  scan.range = 30.0;
  scan.distances.assign(static_cast<std::size_t>(beams), distance);
  return scan;
}

inline Observation at(const Vec2& robot, double time, const LaserScan* scan = nullptr) {
  Observation observation;
  observation.pose.position = robot;
  observation.time = time;
  observation.scan = scan;
  return observation;
}

/// An update with a beam, from a robot that stands at the origin.
inline void look(LayeredCostmap& costmap, const Vec2& from, const Vec2& to, double time) {
  const LaserScan scan = beamTo(from, to, time);
  costmap.updateNow(at({0.0, 0.0}, time, &scan));
}

inline int count(const Costmap& costmap, int cost) {
  return static_cast<int>(std::count(costmap.costs().begin(), costmap.costs().end(), cost));
}

/// Squared distance of the nearest lethal cell, by looking at all [cells²]; -1: none.
inline int nearestSquare(const Costmap& costmap, Cell cell) {
  int least = -1;
  for (int row = 0; row < costmap.height(); ++row) {
    for (int column = 0; column < costmap.width(); ++column) {
      const int across = column - cell.column, up = row - cell.row;
      const int square = across * across + up * up;
      if (costmap.at({column, row}) == kLethal && (least < 0 || square < least)) {
        least = square;
      }
    }
  }
  return least;
}

}  // namespace costmapscenes

#include "sim2d/nav/nav2/costmap/RangeSensorLayer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"

namespace sim2d::nav2 {
namespace {

constexpr double kUnknownProbability = 0.5;
constexpr double kConeAngle = 0.5;                   // of the simulated sensors [rad]
constexpr double kMinRange = 0.02, kMaxRange = 4.0;  // [m]
constexpr std::uint8_t kTargetCost = 233;  // of the measured cell, before the model is applied
constexpr double kConeLength = 1.2;  // length of the box around the cone, relative to the range

double probabilityOf(std::uint8_t cost) {
  return static_cast<double>(cost) / kLethal;
}
std::uint8_t costOf(double probability) {
  return static_cast<std::uint8_t>(probability * kLethal);
}

/// Twice the area of a triangle [cells²], positive for counter-clockwise corners.
long long twiceArea(Cell a, Cell b, Cell c) {
  return static_cast<long long>(b.column - a.column) * (c.row - a.row) -
         static_cast<long long>(b.row - a.row) * (c.column - a.column);
}

Cell unboundedCell(const Costmap& costmap, const Vec2& place) {
  return {static_cast<int>((place.x() - costmap.origin().x()) / costmap.resolution()),
          static_cast<int>((place.y() - costmap.origin().y()) / costmap.resolution())};
}

/// The minimum distance of the beams within a cone; the lidar's range if there are none.
double minDistanceInCone(const LaserScan& scan, double heading) {
  double least = scan.range;
  for (std::size_t i = 0; i < scan.distances.size(); ++i) {
    if (std::abs(base::angleDiff(scan.angle(i), heading)) <= kConeAngle / 2.0) {
      least = std::min(least, scan.distances[i]);
    }
  }
  return least;
}

}  // namespace

double directionOfSensor(const std::string& topic) {
  const auto has = [&topic](const char* part) { return topic.find(part) != std::string::npos; };
  const double side = has("left") ? 1.0 : has("right") ? -1.0 : 0.0;
  const bool isBehind = has("rear") || has("back");
  const bool isAhead = has("front");
  if (side == 0.0) {
    return isBehind ? base::kPi : 0.0;
  }
  return side * base::kPi * (isBehind ? 0.75 : isAhead ? 0.25 : 0.5);
}

RangeSensorLayer::RangeSensorLayer(std::string name, const CostmapContext& context,
                                   const RangeSensorLayerParameters& parameters,
                                   const Costmap& master)
    : CostmapLayer(std::move(name), context), parameters_(parameters), grid_(master) {
  fillWindow(grid_, wholeWindow(grid_), costOf(kUnknownProbability));
  for (const std::string& topic : parameters.topics) {
    directions_.push_back(directionOfSensor(topic));
  }
}

void RangeSensorLayer::observe(const Observation& observation) {
  const LaserScan* const scan = observation.scan;
  if (scan == nullptr || !(scan->time > lastScan_) || parameters_.inputSensorType == "FIXED") {
    return;
  }
  lastScan_ = scan->time;
  for (const double direction : directions_) {
    RangeReading reading;
    reading.origin = scan->sensor.position;
    reading.heading = observation.pose.heading + direction;
    reading.fieldOfView = kConeAngle;
    reading.range = minDistanceInCone(*scan, reading.heading);
    const bool isFar = reading.range >= std::min(kMaxRange, scan->range);
    if (reading.range < kMinRange || (isFar && !parameters_.clearOnMaxReading)) {
      continue;
    }
    reading.range = std::min(reading.range, kMaxRange);
    reading.clears = isFar;
    add(reading);
  }
}

void RangeSensorLayer::updateBounds(const Observation& observation, const Costmap& master,
                                    CostmapBounds& bounds) {
  moveWithRobot(grid_, observation, master, costOf(kUnknownProbability));
  for (const RangeReading& reading : readings_) {
    applyReading(reading);
    lastReading_ = observation.time;
  }
  const bool hasReadings = !readings_.empty();
  readings_.clear();
  bounds.touch(touched_);
  touched_ = CostmapBounds();
  const bool isStale = !hasReadings && parameters_.noReadingsTimeout > 0.0 &&
                       observation.time - lastReading_ > parameters_.noReadingsTimeout;
  if (parameters_.enabled && isStale) {
    isCurrent_ = false;
  } else if (!parameters_.enabled || (hasReadings && !wasReset_)) {
    isCurrent_ = true;
  }
}

void RangeSensorLayer::updateCosts(Costmap& master, const CellWindow& window) {
  if (!parameters_.enabled) {
    return;
  }
  const std::uint8_t clear = costOf(parameters_.clearThreshold);
  const std::uint8_t mark = costOf(parameters_.markThreshold);
  for (int row = window.bottom; row < window.top; ++row) {
    for (int column = window.left; column < window.right; ++column) {
      const Cell cell{column, row};
      const std::uint8_t probability = grid_.at(cell);
      const bool isMarked = probability > mark, isClear = probability < clear;
      if (probability == kNoInformation || (!isMarked && !isClear)) {
        continue;
      }
      const std::uint8_t cost = isMarked ? kLethal : kFreeSpace, old = master.at(cell);
      if (old == kNoInformation || old < cost) {
        master.set(cell, cost);
      }
    }
  }
  if (wasReset_) {
    wasReset_ = false;
    isCurrent_ = true;
  }
}

void RangeSensorLayer::reset(double time) {
  fillWindow(grid_, wholeWindow(grid_), costOf(kUnknownProbability));
  readings_.clear();
  lastReading_ = time;
  isCurrent_ = false;
  wasReset_ = true;
}

void RangeSensorLayer::clearArea(const Vec2& low, const Vec2& high, bool isInverted) {
  clearCells(grid_, low, high, isInverted, costOf(kUnknownProbability));
  touched_.touch(grid_.origin());
  touched_.touch(grid_.origin() + nav2SizeOf(grid_));
}

double RangeSensorLayer::occupancy(double range, double distance, double angle, double halfAngle,
                                   double phi, double resolution) {
  const double ratio = angle / halfAngle;
  const double inCone = std::abs(angle) > halfAngle ? 0.0 : 1.0 - ratio * ratio;
  const double nearness = 1.0 - (1.0 + base::tanh(2.0 * (distance - phi))) / 2.0;
  const double weight = nearness * inCone;
  const double step = resolution * range;  // as in Nav2: cell size times range
  if (distance >= 0.0 && distance < range - 2.0 * step) {
    return (1.0 - weight) * kUnknownProbability;
  }
  if (distance < range - step) {
    const double rise = (distance - (range - 2.0 * step)) / step;
    return weight * 0.5 * rise * rise + (1.0 - weight) * kUnknownProbability;
  }
  if (distance < range + step) {
    const double fall = (range - distance) / step;
    return weight * ((1.0 - 0.5 * fall * fall) - kUnknownProbability) + kUnknownProbability;
  }
  return kUnknownProbability;
}

/// Updates the cells in the box around the reading's cone.
void RangeSensorLayer::applyReading(const RangeReading& reading) {
  const double half = reading.fieldOfView / 2.0;
  const Vec2 target = reading.origin + reading.range * base::directionOf(reading.heading);
  const Vec2 left =
      reading.origin + kConeLength * reading.range * base::directionOf(reading.heading - half);
  const Vec2 right =
      reading.origin + kConeLength * reading.range * base::directionOf(reading.heading + half);
  touched_.touch(reading.origin);
  if (const auto cell = grid_.worldToCell(target)) {
    grid_.set(*cell, kTargetCost);
    touched_.touch(target);
  }
  touched_.touch(left);
  touched_.touch(right);
  const Cell tip = unboundedCell(grid_, reading.origin);
  const Cell a = unboundedCell(grid_, left), b = unboundedCell(grid_, right);
  const int firstColumn = std::max(0, std::min({tip.column, a.column, b.column}));
  const int lastColumn = std::min(grid_.width() - 1, std::max({tip.column, a.column, b.column}));
  const int firstRow = std::max(0, std::min({tip.row, a.row, b.row}));
  const int lastRow = std::min(grid_.height() - 1, std::max({tip.row, a.row, b.row}));
  for (int column = firstColumn; column <= lastColumn; ++column) {
    for (int row = firstRow; row <= lastRow; ++row) {
      if (parameters_.inflateCone >= 1.0 || isInCone(a, b, tip, {column, row})) {
        updateCell(reading, {column, row});
      }
    }
  }
}

/// Whether all barycentric coordinates are above a negative share of the area, as Nav2 widens the
/// cone.
bool RangeSensorLayer::isInCone(Cell left, Cell right, Cell tip, Cell cell) const {
  const double area = static_cast<double>(std::llabs(twiceArea(left, right, tip))) / 2.0;
  const double least = -parameters_.inflateCone * area;
  return static_cast<double>(twiceArea(left, right, cell)) >= least &&
         static_cast<double>(twiceArea(right, tip, cell)) >= least &&
         static_cast<double>(twiceArea(tip, left, cell)) >= least;
}

void RangeSensorLayer::updateCell(const RangeReading& reading, Cell cell) {
  const Vec2 offset = grid_.cellToWorld(cell) - reading.origin;
  const double angle = base::angleDiff(base::headingOf(offset), reading.heading);
  const double occupied =
      reading.clears ? 0.0
                     : occupancy(reading.range, offset.norm(), angle, reading.fieldOfView / 2.0,
                                 parameters_.phi, grid_.resolution());
  const double prior = probabilityOf(grid_.at(cell));
  const double yes = occupied * prior, no = (1.0 - occupied) * (1.0 - prior);
  if (yes + no > 0.0) {  // else contradictory certainties: unchanged
    grid_.set(cell, costOf(yes / (yes + no)));
  }
}

}  // namespace sim2d::nav2

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

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

double sonarOccupancy(double range, double distance, double angle, double halfAngle, double phi,
                      double resolution) {
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

namespace {

/// A range measurement: the distance to the nearest object within a cone.
struct RangeReading {
  Vec2 origin = Vec2::Zero();  // sensor position [m]
  double heading = 0.0;        // sensor axis [rad], world frame
  double range = 0.0;          // [m]
  bool clears = false;         // no object detected: the cone is free
};

/// Occupancy probabilities of cells from range sensors (nav2_costmap_2d::RangeSensorLayer, after D.
/// Lu and B. Gerkey): each reading changes the odds of the cells in a box around its cone by a
/// sonar model. Cells above `mark_threshold` are lethal, those below `clear_threshold` free.
///
/// Simulated robots have no such sensors: each topic is a sensor at the lidar's position with 0.5
/// rad and 0.02 to 4 m, whose reading is the minimum distance of the beams in its cone. It faces
/// forward unless its name contains a direction: "left", "right", "rear" or "back", and
/// "front_left" etc. for diagonals. A sensor without a detection gives no reading, or its maximum
/// range with `clear_on_max_reading`.
class RangeSensorLayer final : public GridLayer {
 public:
  RangeSensorLayer(const RangeSensorLayerParameters& parameters, const LayerSite& site)
      : GridLayer(site, parameters.enabled, costOf(kUnknownProbability)), parameters_(parameters) {}

  void observe(const Observation& observation) override {
    const LaserScan* const scan = observation.scan;
    if (scan == nullptr || !(scan->time > lastScan_) || parameters_.inputSensorType == "FIXED") {
      return;
    }
    lastScan_ = scan->time;
    for (const std::string& topic : parameters_.topics) {
      RangeReading reading;
      reading.origin = scan->sensor.position;
      reading.heading = observation.pose.heading + directionOfSensor(topic);
      reading.range = minDistanceInCone(*scan, reading.heading);
      const bool isFar = reading.range >= std::min(kMaxRange, scan->range);
      if (reading.range < kMinRange || (isFar && !parameters_.clearOnMaxReading)) {
        continue;
      }
      reading.range = std::min(reading.range, kMaxRange);
      reading.clears = isFar;
      readings_.push_back(reading);
    }
  }

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override {
    moveWithRobot(observation, master);
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

  void updateCosts(Costmap& master, const CellWindow& window) override {
    if (!parameters_.enabled) {
      return;
    }
    const std::uint8_t clear = costOf(parameters_.clearThreshold);
    const std::uint8_t mark = costOf(parameters_.markThreshold);
    forEachCell(window, [&](Cell cell) {
      const std::uint8_t probability = grid_.at(cell);
      const bool isMarked = probability > mark, isClear = probability < clear;
      if (probability == kNoInformation || (!isMarked && !isClear)) {
        return;
      }
      const std::uint8_t cost = isMarked ? kLethal : kFreeSpace, old = master.at(cell);
      if (old == kNoInformation || old < cost) {
        master.set(cell, cost);
      }
    });
    if (wasReset_) {
      wasReset_ = false;
      isCurrent_ = true;
    }
  }

  void reset(double time) override {
    resetGrid();
    readings_.clear();
    lastReading_ = time;
  }

  void clearArea(const Vec2& low, const Vec2& high, bool isInverted) override {
    clearCells(grid_, low, high, isInverted, emptyCost_);
    touched_.touch(grid_.origin());
    touched_.touch(grid_.origin() + nav2SizeOf(grid_));
  }

 private:
  /// Updates the cells in the box around the reading's cone.
  void applyReading(const RangeReading& reading) {
    const Vec2 target = reading.origin + reading.range * base::directionOf(reading.heading);
    const auto side = [&reading](double angle) -> Vec2 {
      return reading.origin +
             kConeLength * reading.range * base::directionOf(reading.heading + angle);
    };
    const Vec2 left = side(-kConeAngle / 2.0), right = side(kConeAngle / 2.0);
    touched_.touch(reading.origin);
    if (const auto cell = grid_.worldToCell(target)) {
      grid_.set(*cell, kTargetCost);
      touched_.touch(target);
    }
    touched_.touch(left);
    touched_.touch(right);
    const Cell tip = unboundedCell(grid_, reading.origin);
    const Cell a = unboundedCell(grid_, left), b = unboundedCell(grid_, right);
    const CellWindow box{
        std::max(0, std::min({tip.column, a.column, b.column})),
        std::max(0, std::min({tip.row, a.row, b.row})),
        std::min(grid_.width() - 1, std::max({tip.column, a.column, b.column})) + 1,
        std::min(grid_.height() - 1, std::max({tip.row, a.row, b.row})) + 1};
    forEachCell(box, [&](Cell cell) {
      if (parameters_.inflateCone >= 1.0 || isInCone(a, b, tip, cell)) {
        updateCell(reading, cell);
      }
    });
  }

  /// Whether all barycentric coordinates are above a negative share of the area, as Nav2 widens the
  /// cone.
  bool isInCone(Cell left, Cell right, Cell tip, Cell cell) const {
    const double area = static_cast<double>(std::llabs(twiceArea(left, right, tip))) / 2.0;
    const double least = -parameters_.inflateCone * area;
    return static_cast<double>(twiceArea(left, right, cell)) >= least &&
           static_cast<double>(twiceArea(right, tip, cell)) >= least &&
           static_cast<double>(twiceArea(tip, left, cell)) >= least;
  }

  void updateCell(const RangeReading& reading, Cell cell) {
    const Vec2 offset = grid_.cellToWorld(cell) - reading.origin;
    const double angle = base::angleDiff(base::headingOf(offset), reading.heading);
    const double occupied =
        reading.clears ? 0.0
                       : sonarOccupancy(reading.range, offset.norm(), angle, kConeAngle / 2.0,
                                        parameters_.phi, grid_.resolution());
    const double prior = probabilityOf(grid_.at(cell));
    const double yes = occupied * prior, no = (1.0 - occupied) * (1.0 - prior);
    if (yes + no > 0.0) {  // else contradictory certainties: unchanged
      grid_.set(cell, costOf(yes / (yes + no)));
    }
  }

  RangeSensorLayerParameters parameters_;  // the grid contains probability * 254
  std::vector<RangeReading> readings_;     // since the last update
  CostmapBounds touched_;
  double lastScan_ = -1.0, lastReading_ = 0.0;  // [s]
};

}  // namespace

LayerPointer makeLayer(const RangeSensorLayerParameters& parameters, const LayerSite& site) {
  return std::make_unique<RangeSensorLayer>(parameters, site);
}

}  // namespace sim2d::nav2

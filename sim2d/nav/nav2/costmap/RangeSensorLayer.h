#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

namespace sim2d::nav2 {

/// What a range sensor measures: one distance to the nearest thing within a cone.
struct RangeReading {
  Vec2 origin = Vec2::Zero();  // of the sensor [m]
  double heading = 0.0;        // of its axis [rad], world frame
  double range = 0.0;          // [m]
  double fieldOfView = 0.5;    // angle of the cone [rad]
  bool clears = false;         // nothing was seen: the cone is free
};

/// Probabilities of cells by the readings of range sensors (nav2_costmap_2d::RangeSensorLayer,
/// after D. Lu and B. Gerkey): each reading changes the odds of the cells in a box round its cone
/// by a model of a sonar; cells above `mark_threshold` are lethal, those below `clear_threshold`
/// free.
///
/// Robots here have no such sensors; each topic is one at the place of the lidar, of 0.5 rad and
/// 0.02 to 4 m, whose reading is the least distance of the beams in its cone. It looks ahead, or
/// where its name says: "left", "right", "rear" or "back", and "front_left" and so on between two.
/// A sensor that sees nothing gives no reading, with `clear_on_max_reading` its greatest range.
class RangeSensorLayer final : public CostmapLayer {
 public:
  /// `master`: size and place of the costmap.
  RangeSensorLayer(std::string name, const CostmapContext& context,
                   const RangeSensorLayerParameters& parameters, const Costmap& master);

  void observe(const Observation& observation) override;
  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& master, const CellWindow& window) override;
  void reset(double time) override;
  bool isCurrent() const override { return isCurrent_ || !parameters_.enabled; }
  bool isClearable() const override { return true; }
  void clearArea(const Vec2& low, const Vec2& high, bool isInverted) override;
  const Costmap* grid() const override { return &grid_; }

  /// A reading of any sensor, counted at the next update.
  void add(const RangeReading& reading) { readings_.push_back(reading); }

  /// The model: probability [0, 1] that a cell at `distance` [m] and `angle` [rad] from the axis is
  /// occupied, given a reading of `range` [m] by a sensor of the half angle `halfAngle` [rad].
  /// `phi` [m] is the key of that name, `resolution` [m] the side of a cell.
  static double occupancy(double range, double distance, double angle, double halfAngle, double phi,
                          double resolution);

 private:
  void take(const RangeReading& reading);
  void updateCell(const RangeReading& reading, Cell cell);
  bool isInCone(Cell left, Cell right, Cell tip, Cell cell) const;

  RangeSensorLayerParameters parameters_;
  Costmap grid_;                        // probability * 254
  std::vector<double> directions_;      // of the sensors, from the robot's heading [rad]
  std::vector<RangeReading> readings_;  // since the last update
  CostmapBounds touched_;
  double lastScan_ = -1.0, lastReading_ = 0.0;  // [s]
  bool isCurrent_ = true, wasReset_ = false;
};

/// Where a sensor of this name looks, from the robot's heading [rad].
double directionOfSensor(const std::string& topic);

}  // namespace sim2d::nav2

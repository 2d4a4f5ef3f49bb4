#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

namespace sim2d::nav2 {

/// A range measurement: the distance to the nearest object within a cone.
struct RangeReading {
  Vec2 origin = Vec2::Zero();  // sensor position [m]
  double heading = 0.0;        // sensor axis [rad], world frame
  double range = 0.0;          // [m]
  double fieldOfView = 0.5;    // cone angle [rad]
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
class RangeSensorLayer final : public CostmapLayer {
 public:
  /// `master`: size and origin of the costmap.
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

  /// Adds a reading of any sensor for the next update.
  void add(const RangeReading& reading) { readings_.push_back(reading); }

  /// The sensor model: probability [0, 1] that a cell at `distance` [m] and `angle` [rad] from the
  /// axis is occupied, given a reading of `range` [m] by a sensor with half angle `halfAngle`
  /// [rad]. `phi` [m] is the key of that name, `resolution` [m] the cell size.
  static double occupancy(double range, double distance, double angle, double halfAngle, double phi,
                          double resolution);

 private:
  void applyReading(const RangeReading& reading);
  void updateCell(const RangeReading& reading, Cell cell);
  bool isInCone(Cell left, Cell right, Cell tip, Cell cell) const;

  RangeSensorLayerParameters parameters_;
  Costmap grid_;                        // probability * 254
  std::vector<double> directions_;      // sensor axes relative to the robot's heading [rad]
  std::vector<RangeReading> readings_;  // since the last update
  CostmapBounds touched_;
  double lastScan_ = -1.0, lastReading_ = 0.0;  // [s]
  bool isCurrent_ = true, wasReset_ = false;
};

/// The axis of the sensor of this name relative to the robot's heading [rad].
double directionOfSensor(const std::string& topic);

}  // namespace sim2d::nav2

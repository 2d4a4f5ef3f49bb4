#pragma once

#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim2d/base/Types.h"
#include "sim2d/map/OccupancyGrid.h"

/// Costs of cells with the values of nav2_costmap_2d. Planners and controllers read them.
namespace sim2d::nav2 {

using base::Pose2;
using base::Vec2;

constexpr std::uint8_t kFreeSpace = 0;
constexpr std::uint8_t kInscribed = 253;      // the centre of a round robot in this cell collides
constexpr std::uint8_t kLethal = 254;         // an obstacle
constexpr std::uint8_t kNoInformation = 255;  // unknown

/// Poses that the robot passes in this order. World frame [m], [rad].
using Path = std::vector<Pose2>;

/// A grid of costs aligned with the axes of the world frame. Row-major from the lower left. A value
/// type.
class Costmap {
 public:
  Costmap() = default;
  /// `origin` = lower left corner of the lower left cell [m]; resolution [m] > 0.
  Costmap(int width, int height, double resolution, const Vec2& origin,
          std::uint8_t cost = kFreeSpace)
      : width_(width),
        height_(height),
        resolution_(resolution),
        origin_(origin),
        costs_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), cost) {
    assert(width >= 0 && height >= 0 && resolution > 0.0);
  }

  int width() const { return width_; }    // cells
  int height() const { return height_; }  // cells
  double resolution() const { return resolution_; }
  const Vec2& origin() const { return origin_; }
  void setOrigin(const Vec2& origin) { origin_ = origin; }  // does not move the costs
  std::vector<std::uint8_t>& costs() { return costs_; }
  const std::vector<std::uint8_t>& costs() const { return costs_; }

  bool contains(Cell cell) const {
    return cell.column >= 0 && cell.row >= 0 && cell.column < width_ && cell.row < height_;
  }
  std::size_t indexOf(Cell cell) const {  // precondition: contains(cell)
    assert(contains(cell));
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.column);
  }
  Cell cellOf(std::size_t index) const {
    const auto width = static_cast<std::size_t>(width_);
    return {static_cast<int>(index % width), static_cast<int>(index / width)};
  }
  std::uint8_t at(Cell cell) const { return costs_[indexOf(cell)]; }
  void set(Cell cell, std::uint8_t cost) { costs_[indexOf(cell)] = cost; }

  /// Returns the cell at a position: floor((p - origin) / resolution), or nullopt outside the grid
  /// and for NaN.
  std::optional<Cell> worldToCell(const Vec2& place) const {
    const double column = std::floor((place.x() - origin_.x()) / resolution_);
    const double row = std::floor((place.y() - origin_.y()) / resolution_);
    if (!(column >= 0.0 && row >= 0.0 && column < width_ && row < height_)) {
      return std::nullopt;
    }
    return Cell{static_cast<int>(column), static_cast<int>(row)};
  }
  Vec2 cellToWorld(Cell cell) const {  // centre of the cell
    return origin_ + resolution_ * Vec2(cell.column + 0.5, cell.row + 0.5);
  }
  /// Returns the number of cells that a distance spans: ceil(d / resolution), at least 0.
  int cellDistance(double distance) const {
    constexpr double kMax = 1e9;  // larger than any map
    return static_cast<int>(std::fmin(std::fmax(0.0, std::ceil(distance / resolution_)), kMax));
  }

 private:
  int width_ = 0, height_ = 0;
  double resolution_ = 0.05;  // [m]
  Vec2 origin_ = Vec2::Zero();
  std::vector<std::uint8_t> costs_;
};

}  // namespace sim2d::nav2

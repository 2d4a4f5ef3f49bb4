#include "editor/canvas/WallSnap.h"

#include <algorithm>
#include <cmath>

namespace editor {

namespace {

using base::Vec2;

constexpr double kMostCells = 40.0;  // to each side, however far the view is away
constexpr int kLeg = 3;              // cells that the edges of a corner are long at least

/// Borders between wall and no wall around one point; lattice points are the corners of cells.
class Borders {
 public:
  Borders(const sim2d::OccupancyGrid& grid, const Vec2& world, double reach)
      : grid_(grid),
        at_(grid.worldToCorner(world)),
        reach_(std::min(reach / grid.resolution(), kMostCells)) {}

  std::optional<Vec2> nearest() {
    const auto low = [this](double value) { return static_cast<int>(std::floor(value - reach_)); };
    const auto high = [this](double value) { return static_cast<int>(std::ceil(value + reach_)); };
    for (int row = low(at_.y()); row <= high(at_.y()); ++row) {
      for (int column = low(at_.x()); column <= high(at_.x()); ++column) {
        offerPoint(column, row);
      }
    }
    return corner_.place ? corner_.place : edge_.place;
  }

 private:
  struct Best {
    std::optional<Vec2> place;  // world
    double distance = 0.0;      // [cells]
  };

  bool isWall(int column, int row) const { return grid_.isWall({column, row}); }
  /// The border from a lattice point to the next one on the right, or above.
  bool goesRight(int column, int row) const {
    return isWall(column, row - 1) != isWall(column, row);
  }
  bool goesUp(int column, int row) const { return isWall(column - 1, row) != isWall(column, row); }

  template <class Goes>
  static bool isLeg(Goes&& goes) {
    for (int i = 0; i < kLeg; ++i) {
      if (!goes(i)) {
        return false;
      }
    }
    return true;
  }

  bool isCorner(int column, int row) const {
    const bool right = goesRight(column, row);
    const bool left = goesRight(column - 1, row);
    const bool up = goesUp(column, row);
    const bool down = goesUp(column, row - 1);
    if (right == left || up == down) {
      return false;
    }
    return isLeg([&](int i) { return goesRight(right ? column + i : column - 1 - i, row); }) &&
           isLeg([&](int i) { return goesUp(column, up ? row + i : row - 1 - i); });
  }

  void offer(Best& best, const Vec2& place) const {
    const double distance = (place - at_).norm();
    if (distance <= reach_ && (!best.place || distance < best.distance)) {
      best = {grid_.cornerToWorld(place.x(), place.y()), distance};
    }
  }

  void offerPoint(int column, int row) {
    const double x = column;
    const double y = row;
    if (goesRight(column, row)) {
      offer(edge_, {std::clamp(at_.x(), x, x + 1.0), y});
    }
    if (goesUp(column, row)) {
      offer(edge_, {x, std::clamp(at_.y(), y, y + 1.0)});
    }
    if (isCorner(column, row)) {
      offer(corner_, {x, y});
    }
  }

  const sim2d::OccupancyGrid& grid_;
  Vec2 at_;       // [cells]
  double reach_;  // [cells]
  Best corner_, edge_;
};

}  // namespace

std::optional<Vec2> nearestOnWalls(const sim2d::OccupancyGrid& grid, const Vec2& world,
                                   double reach) {
  return grid.isEmpty() ? std::nullopt : Borders(grid, world, reach).nearest();
}

}  // namespace editor

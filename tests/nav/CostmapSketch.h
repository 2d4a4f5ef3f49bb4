#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <queue>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"

/// Costmaps drawn as text, and plain searches through them to compare planners with.
namespace costs {

using sim2d::Cell;
using sim2d::nav2::Costmap;
using sim2d::nav2::Path;
using sim2d::nav2::Pose2;
using sim2d::nav2::Vec2;

/// Rows from the top: '#' lethal, 'i' inscribed, '?' unknown, 'o' cost 252, 'm' cost 128, else
/// free.
inline Costmap drawn(const std::vector<std::string>& rows, double resolution = 1.0) {
  const int height = static_cast<int>(rows.size()), width = static_cast<int>(rows.front().size());
  Costmap costmap(width, height, resolution, Vec2::Zero());
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const char letter =
          rows[static_cast<std::size_t>(height - 1 - row)][static_cast<std::size_t>(column)];
      const int cost = letter == '#'   ? 254
                       : letter == 'i' ? 253
                       : letter == '?' ? 255
                       : letter == 'o' ? 252
                       : letter == 'm' ? 128
                                       : 0;
      costmap.set({column, row}, static_cast<std::uint8_t>(cost));
    }
  }
  return costmap;
}

/// Costs round lethal cells, each distance measured: 253 to `inscribed` [m], then falling.
inline void inflate(Costmap& costmap, double inscribed, double radius, double scaling) {
  const Costmap bare = costmap;
  const int reach = costmap.cellDistance(radius);
  for (int row = 0; row < costmap.height(); ++row) {
    for (int column = 0; column < costmap.width(); ++column) {
      if (bare.at({column, row}) != 254) {
        continue;
      }
      for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
          const Cell cell{column + dx, row + dy};
          const double distance = std::hypot(dx, dy) * costmap.resolution();
          if (!costmap.contains(cell) || distance > radius || (dx == 0 && dy == 0)) {
            continue;
          }
          const int cost =
              distance <= inscribed
                  ? 253
                  : static_cast<int>(252.0 * std::exp(-scaling * (distance - inscribed)));
          costmap.set(cell, std::max(costmap.at(cell), static_cast<std::uint8_t>(cost)));
        }
      }
    }
  }
}

/// Textbook Dijkstra over four or eight neighbours: cost of the cheapest way from `from` to every
/// cell; `stepCost(to, length)` is infinite where there is no step.
template <class StepCost>
std::vector<double> cheapest(const Costmap& costmap, Cell from, int neighbours, StepCost stepCost) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  std::vector<double> best(costmap.costs().size(), kNever);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  best[costmap.indexOf(from)] = 0.0;
  queue.emplace(0.0, costmap.indexOf(from));
  while (!queue.empty()) {
    const auto [cost, index] = queue.top();
    queue.pop();
    if (cost > best[index]) {
      continue;
    }
    const Cell cell{static_cast<int>(index) % costmap.width(),
                    static_cast<int>(index) / costmap.width()};
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell next{cell.column + dx, cell.row + dy};
        const int moved = std::abs(dx) + std::abs(dy);
        if (moved == 0 || (neighbours == 4 && moved == 2) || !costmap.contains(next)) {
          continue;
        }
        const double found = cost + stepCost(next, std::sqrt(static_cast<double>(moved)));
        if (found < best[costmap.indexOf(next)]) {
          best[costmap.indexOf(next)] = found;
          queue.emplace(found, costmap.indexOf(next));
        }
      }
    }
  }
  return best;
}

inline Pose2 pose(double x, double y, double heading = 0.0) {
  return {{x, y}, heading};
}

inline double lengthOf(const Path& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    length += (path[i].position - path[i - 1].position).norm();
  }
  return length;
}

/// The greatest cost that a path comes over, looked at every tenth of a cell; 254 off the map.
inline int highestUnder(const Costmap& costmap, const Path& path) {
  int highest = 0;
  const auto look = [&](const Vec2& place) {
    const auto cell = costmap.worldToCell(place);
    highest = std::max(highest, cell ? static_cast<int>(costmap.at(*cell)) : 254);
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    look(path[i].position);
    const Vec2 way = path[i].position - path[i > 0 ? i - 1 : 0].position;
    const int pieces = 1 + static_cast<int>(10.0 * way.norm() / costmap.resolution());
    for (int k = 1; k < pieces; ++k) {
      look(path[i].position - way * k / pieces);
    }
  }
  return highest;
}

/// Even numbers that are the same everywhere, 0 to 1.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed * 2654435761U + 12345U) {}
  double next() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11U) / 9007199254740992.0;
  }
  double between(double low, double high) { return low + (high - low) * next(); }

 private:
  std::uint64_t state_;
};

/// Walls at random, with costs round them; free round the corners of the map.
inline Costmap cluttered(int side, std::uint64_t seed, double resolution = 0.1) {
  Numbers numbers(seed);
  Costmap costmap(side, side, resolution, {-2.0, 1.0});
  for (int i = 0; i < side / 4; ++i) {
    const int column = static_cast<int>(numbers.between(8, side - 8));
    const int row = static_cast<int>(numbers.between(8, side - 8));
    const bool isFlat = numbers.next() < 0.5;
    for (int k = 0; k < side / 8; ++k) {
      const Cell cell{column + (isFlat ? k : 0), row + (isFlat ? 0 : k)};
      if (cell.column < side - 6 && cell.row < side - 6) {
        costmap.set(cell, 254);
      }
    }
  }
  inflate(costmap, 1.5 * resolution, 6.0 * resolution, 3.0);
  return costmap;
}

}  // namespace costs

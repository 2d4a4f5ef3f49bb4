#include "sim2d/nav/nav2/control/dwb/MapGrid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

namespace sim2d::nav2 {

void MapGrid::clear(int width, int height) {
  width_ = width;
  height_ = height;
  seeds_.clear();
  isStarted_ = false;
}

void MapGrid::start() {
  isStarted_ = true;
  const auto side = static_cast<std::size_t>(width_);
  const auto other = static_cast<std::size_t>(height_);
  const std::size_t cells = side * other;
  values_.assign(cells, kUnvisited);
  isFound_.assign(cells, 0);
  entries_.resize(cells);
  for (std::size_t bucket = nearest_; bucket <= farthest_ && waiting_ > 0; ++bucket) {
    buckets_[bucket] = -1;
  }
  buckets_.resize(side * side + other * other + 1, -1);
  nearest_ = buckets_.size();
  farthest_ = 0;
  waiting_ = 0;
  for (const Cell seed : seeds_) {
    const std::int32_t index = seed.row * width_ + seed.column;
    if (isFound_[static_cast<std::size_t>(index)] == 0) {
      push(index, 0, 0);
    }
  }
}

void MapGrid::push(std::int32_t cell, int dx, int dy) {
  const auto index = static_cast<std::size_t>(cell);
  const int squared = dx * dx + dy * dy;
  const auto bucket = static_cast<std::size_t>(squared);
  isFound_[index] = 1;
  entries_[index] = {buckets_[bucket], static_cast<std::int16_t>(dx),
                     static_cast<std::int16_t>(dy)};
  buckets_[bucket] = cell;
  nearest_ = std::min(nearest_, bucket);
  farthest_ = std::max(farthest_, bucket);
  ++waiting_;
}

std::int32_t MapGrid::pop() {
  while (buckets_[nearest_] < 0) {
    ++nearest_;
  }
  const std::int32_t cell = buckets_[nearest_];
  buckets_[nearest_] = entries_[static_cast<std::size_t>(cell)].next;
  --waiting_;
  return cell;
}

void MapGrid::propagateTo(std::size_t wanted) {
  while (waiting_ > 0 && values_[wanted] == kUnvisited) {
    const std::int32_t cell = pop();
    const auto index = static_cast<std::size_t>(cell);
    const int dx = entries_[index].dx, dy = entries_[index].dy;
    values_[index] = std::abs(dx) + std::abs(dy);
    const int column = cell % width_, row = cell / width_;
    if (column > 0 && isFound_[index - 1] == 0) {
      push(cell - 1, dx - 1, dy);
    }
    if (row > 0 && isFound_[index - static_cast<std::size_t>(width_)] == 0) {
      push(cell - width_, dx, dy - 1);
    }
    if (column + 1 < width_ && isFound_[index + 1] == 0) {
      push(cell + 1, dx + 1, dy);
    }
    if (row + 1 < height_ && isFound_[index + static_cast<std::size_t>(width_)] == 0) {
      push(cell + width_, dx, dy + 1);
    }
  }
}

Path adjustPlanResolution(const Path& path, double resolution) {
  if (path.empty()) {
    return {};
  }
  Path fine{path.front()};
  const double leastSquared = resolution * resolution * 4.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Pose2& last = path[i - 1];
    const Vec2 way = path[i].position - last.position;
    const double squared = way.squaredNorm();
    if (squared > leastSquared) {
      const double gap = std::sqrt(squared) - std::sqrt(leastSquared);
      const int count = static_cast<int>(gap / resolution) - 1;
      const Vec2 step = way / count;
      for (int j = 1; j < count; ++j) {
        fine.push_back({last.position + j * step, last.heading});
      }
    }
    fine.push_back(path[i]);
  }
  return fine;
}

std::vector<Cell> pathSeeds(const Path& path, const Costmap& costmap) {
  std::vector<Cell> seeds;
  for (const Pose2& pose : adjustPlanResolution(path, costmap.resolution())) {
    const std::optional<Cell> cell = costmap.worldToCell(pose.position);
    if (cell && costmap.at(*cell) != kNoInformation) {
      seeds.push_back(*cell);
    } else if (!seeds.empty()) {
      break;
    }
  }
  return seeds;
}

}  // namespace sim2d::nav2

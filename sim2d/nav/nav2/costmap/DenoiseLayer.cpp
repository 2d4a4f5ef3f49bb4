#include "sim2d/nav/nav2/costmap/DenoiseLayer.h"

#include <cstddef>
#include <cstdlib>

namespace sim2d::nav2 {
namespace {

std::size_t windowIndex(const CellWindow& window, Cell cell) {
  const auto width = static_cast<std::size_t>(window.right - window.left);
  return static_cast<std::size_t>(cell.row - window.bottom) * width +
         static_cast<std::size_t>(cell.column - window.left);
}

}  // namespace

void DenoiseLayer::updateCosts(Costmap& master, const CellWindow& window) {
  const bool isEmpty = window.left >= window.right || window.bottom >= window.top;
  if (!parameters_.enabled || parameters_.minimalGroupSize <= 1 || isEmpty) {
    return;
  }
  seen_.assign(windowIndex(window, {window.right - 1, window.top - 1}) + 1, 0);
  for (int row = window.bottom; row < window.top; ++row) {
    for (int column = window.left; column < window.right; ++column) {
      const Cell cell{column, row};
      if (seen_[windowIndex(window, cell)] != 0 || !isObstacle(master.at(cell))) {
        continue;
      }
      findGroup(master, window, cell);
      if (group_.size() < static_cast<std::size_t>(parameters_.minimalGroupSize)) {
        for (const Cell& each : group_) {
          master.set(each, kFreeSpace);
        }
      }
    }
  }
}

/// Collects the obstacle cells connected to `from` and marks them as seen.
void DenoiseLayer::findGroup(const Costmap& master, const CellWindow& window, Cell from) {
  group_.assign(1, from);
  seen_[windowIndex(window, from)] = 1;
  for (std::size_t i = 0; i < group_.size(); ++i) {
    for (int up = -1; up <= 1; ++up) {
      for (int across = -1; across <= 1; ++across) {
        const bool isDiagonal = std::abs(up) + std::abs(across) == 2;
        const Cell next{group_[i].column + across, group_[i].row + up};
        if ((isDiagonal && parameters_.groupConnectivityType == 4) || !window.contains(next) ||
            seen_[windowIndex(window, next)] != 0 || !isObstacle(master.at(next))) {
          continue;
        }
        seen_[windowIndex(window, next)] = 1;
        group_.push_back(next);
      }
    }
  }
}

}  // namespace sim2d::nav2

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace sim2d::nav2 {
namespace {

struct Overlap {  // overlap of old and new cells along one axis
  int from = 0, to = 0, count = 0;
};
Overlap rolledOverlap(int shift, int size) {
  const int low = std::clamp(shift, 0, size);
  const int high = std::clamp(shift + size, 0, size);
  return {low, low - shift, high - low};
}

int wholeCells(double distance, double resolution) {
  constexpr double kMax = 1e9;  // larger than any map
  return static_cast<int>(std::clamp(distance / resolution, -kMax, kMax));
}

int nearestIndex(double place, double origin, double resolution, int size) {
  if (!(place >= origin)) {
    return 0;
  }
  if (place > resolution * size + origin) {
    return size - 1;
  }
  return std::min(static_cast<int>((place - origin) / resolution), size - 1);
}

std::uint8_t mergedCost(std::uint8_t layer, std::uint8_t old, CombinationMethod way) {
  switch (way) {
    case CombinationMethod::Overwrite:
      return layer == kNoInformation ? old : layer;
    case CombinationMethod::Maximum:
      return layer == kNoInformation || (old != kNoInformation && old >= layer) ? old : layer;
    case CombinationMethod::MaximumOfKnown:
      return layer == kNoInformation || old == kNoInformation || old >= layer ? old : layer;
    case CombinationMethod::Copy:
      break;
  }
  return layer;
}

}  // namespace

Vec2 nav2SizeOf(const Costmap& costmap) {
  return costmap.resolution() * Vec2(costmap.width() - 0.5, costmap.height() - 0.5);
}

void moveOrigin(Costmap& costmap, const Vec2& origin, std::uint8_t defaultCost) {
  const Vec2 way = origin - costmap.origin();
  const int columns = wholeCells(way.x(), costmap.resolution());
  const int rows = wholeCells(way.y(), costmap.resolution());
  costmap.setOrigin(costmap.origin() + costmap.resolution() * Vec2(columns, rows));
  if (columns == 0 && rows == 0) {
    return;
  }
  const Overlap across = rolledOverlap(columns, costmap.width());
  const Overlap up = rolledOverlap(rows, costmap.height());
  std::vector<std::uint8_t> moved(costmap.costs().size(), defaultCost);
  if (across.count > 0) {
    for (int row = 0; row < up.count; ++row) {
      const auto* from = costmap.costs().data() + costmap.indexOf({across.from, up.from + row});
      std::copy(from, from + across.count,
                moved.data() + costmap.indexOf({across.to, up.to + row}));
    }
  }
  costmap.costs().swap(moved);
}

Cell nearestCell(const Costmap& costmap, const Vec2& place) {
  return {nearestIndex(place.x(), costmap.origin().x(), costmap.resolution(), costmap.width()),
          nearestIndex(place.y(), costmap.origin().y(), costmap.resolution(), costmap.height())};
}

CellWindow windowOf(const Costmap& costmap, const CostmapBounds& bounds) {
  const Cell low = nearestCell(costmap, bounds.low);
  const Cell high = nearestCell(costmap, bounds.high);
  if (high.column + 1 <= low.column || high.row + 1 <= low.row) {
    return {};
  }
  return {low.column, low.row, high.column + 1, high.row + 1};
}

void fillWindow(Costmap& costmap, const CellWindow& window, std::uint8_t cost) {
  for (int row = window.bottom; row < window.top; ++row) {
    auto* const line = costmap.costs().data() + costmap.indexOf({0, row});
    std::fill(line + window.left, line + window.right, cost);
  }
}

void mergeWindow(const Costmap& from, const CellWindow& window, CombinationMethod way,
                 Costmap& into) {
  assert(from.width() == into.width() && from.height() == into.height());
  for (int row = window.bottom; row < window.top; ++row) {
    const auto* const source = from.costs().data() + from.indexOf({0, row});
    auto* const target = into.costs().data() + into.indexOf({0, row});
    for (int column = window.left; column < window.right; ++column) {
      target[column] = mergedCost(source[column], target[column], way);
    }
  }
}

void mergeWindow(const Costmap& from, const CellWindow& window, int combinationMethod,
                 Costmap& into) {
  if (combinationMethod >= 0 && combinationMethod <= 2) {
    mergeWindow(from, window, static_cast<CombinationMethod>(combinationMethod), into);
  }
}

void clearCells(Costmap& costmap, const Vec2& low, const Vec2& high, bool isInverted,
                std::uint8_t cost) {
  const Cell from = nearestCell(costmap, low), to = nearestCell(costmap, high);
  const CellWindow inside{from.column + 1, from.row + 1, to.column, to.row};
  forEachCell(wholeWindow(costmap), [&](Cell cell) {
    if (inside.contains(cell) != isInverted) {
      costmap.set(cell, cost);
    }
  });
}

GridLayer::GridLayer(const LayerSite& site, bool isEnabled, std::uint8_t emptyCost)
    : CostmapLayer(site), isEnabled_(isEnabled), emptyCost_(emptyCost), grid_(site.master) {
  emptyGrid();
}

void GridLayer::emptyGrid() {
  fillWindow(grid_, wholeWindow(grid_), emptyCost_);
}

void GridLayer::resetGrid() {
  emptyGrid();
  isCurrent_ = false;
  wasReset_ = true;
}

void GridLayer::moveWithRobot(const Observation& observation, const Costmap& master) {
  if (context().isRolling) {
    moveOrigin(grid_, observation.pose.position - 0.5 * nav2SizeOf(master), emptyCost_);
  }
}

Polygon CostmapLayer::clearedFootprint(bool isCleared, const Observation& observation,
                                       CostmapBounds& bounds) const {
  if (!isCleared) {
    return {};
  }
  Polygon footprint = transformed(context_.footprint.corners, observation.pose);
  for (const Vec2& corner : footprint) {
    bounds.touch(corner);
  }
  return footprint;
}

void fillPolygon(Costmap& costmap, const Polygon& polygon, std::uint8_t cost) {
  std::vector<Cell> corners;
  for (const Vec2& corner : polygon) {
    const std::optional<Cell> cell = costmap.worldToCell(corner);
    if (!cell) {
      return;
    }
    corners.push_back(*cell);
  }
  if (corners.size() < 3) {
    return;
  }
  // Nav2 fills each column between the lowest and the highest row of the outline. The rasterized
  // outline is not strictly convex, so equal results require the same method.
  struct Span {
    int low = std::numeric_limits<int>::max(), high = -1;
  };
  std::vector<Span> spans(static_cast<std::size_t>(costmap.width()));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    visitLine(corners[i], corners[(i + 1) % corners.size()], [&spans](Cell cell) {
      Span& span = spans[static_cast<std::size_t>(cell.column)];
      span.low = std::min(span.low, cell.row);
      span.high = std::max(span.high, cell.row);
      return true;
    });
  }
  for (std::size_t column = 0; column < spans.size(); ++column) {
    for (int row = spans[column].low; row <= spans[column].high; ++row) {
      costmap.set({static_cast<int>(column), row}, cost);
    }
  }
}

}  // namespace sim2d::nav2

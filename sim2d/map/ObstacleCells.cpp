#include "sim2d/map/ObstacleCells.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sim2d {

namespace {

constexpr double kCellSlack = 1e-9;  // [cells]

/// Or wall itself.
bool isBesideWall(const OccupancyGrid& grid, Cell cell) {
  for (int row = cell.row - 1; row <= cell.row + 1; ++row) {
    for (int column = cell.column - 1; column <= cell.column + 1; ++column) {
      if (grid.isWall({column, row})) {
        return true;
      }
    }
  }
  return false;
}

/// Marks cells in the grid's own coordinates.
class Rasteriser {
 public:
  Rasteriser(const OccupancyGrid& grid, const base::StopFlag& stop)
      : grid_(grid), stop_(stop), marks_(grid.cells().size(), char{0}) {}

  void add(const std::vector<Outline>& outlines) {
    crossings_.clear();
    background_ = 0;
    double area = 0.0;
    for (const Outline& outline : outlines) {
      stop_.check();
      area += signedArea(outline.points);
      for (std::size_t i = 0; i < outline.points.size(); ++i) {
        const Vec2 a = grid_.worldToCorner(outline.points[i]);
        const Vec2 b = grid_.worldToCorner(outline.points[(i + 1) % outline.points.size()]);
        markAlong(a, b);
        addCrossings(a, b);
      }
    }
    background_ = area < 0.0 ? 1 : 0;
    fill();
  }

  std::vector<char> takeMarks() { return std::move(marks_); }

 private:
  struct Crossing {
    int row = 0;
    double column = 0.0;
    int sense = 0;
  };

  static int cellOf(double value) {
    return static_cast<int>(std::floor(std::clamp(value, -1e8, 1e8)));
  }

  void mark(Cell cell) {
    if (grid_.contains(cell)) {
      marks_[grid_.indexOf(cell)] = 1;
    }
  }

  void markAlong(const Vec2& a, const Vec2& b) {
    const double lowY = std::min(a.y(), b.y());
    const double highY = std::max(a.y(), b.y());
    const int firstRow = cellOf(lowY + kCellSlack);
    const int lastRow =
        std::min(std::max(cellOf(highY - kCellSlack), firstRow), grid_.height() - 1);
    for (int row = std::max(firstRow, 0); row <= lastRow; ++row) {
      double x[2] = {a.x(), b.x()};
      if (highY - lowY > kCellSlack) {
        const double slope = (b.x() - a.x()) / (b.y() - a.y());
        for (int end = 0; end < 2; ++end) {
          x[end] =
              a.x() + slope * (std::clamp(static_cast<double>(row + end), lowY, highY) - a.y());
        }
      }
      const int first = cellOf(std::min(x[0], x[1]) + kCellSlack);
      const int last = std::max(cellOf(std::max(x[0], x[1]) - kCellSlack), first);
      for (int column = std::max(first, 0); column <= std::min(last, grid_.width() - 1); ++column) {
        if (!isBesideWall(grid_, {column, row})) {
          mark({column, row});
        }
      }
    }
  }

  /// Of an edge with the lines through the centres of the rows.
  void addCrossings(const Vec2& a, const Vec2& b) {
    const double low = std::min(a.y(), b.y());
    const double high = std::max(a.y(), b.y());
    const int first = std::max(cellOf(std::ceil(low - 0.5)), 0);
    for (int row = first; row < grid_.height() && row + 0.5 < high; ++row) {
      const double t = (row + 0.5 - a.y()) / (b.y() - a.y());
      crossings_.push_back({row, a.x() + t * (b.x() - a.x()), b.y() > a.y() ? 1 : -1});
    }
  }

  /// The solid lies to the left of a rising edge: a scan from +x counts rising edges up.
  void fill() {
    std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) {
      return a.row != b.row ? a.row < b.row : a.column > b.column;
    });
    std::size_t at = 0;
    for (int row = 0; row < grid_.height(); ++row) {
      stop_.check();
      int winding = background_;
      int end = grid_.width();  // columns below are not yet decided
      for (; at < crossings_.size() && crossings_[at].row == row; ++at) {
        const int begin = std::clamp(cellOf(crossings_[at].column - 0.5) + 1, 0, grid_.width());
        markRow(row, begin, winding > 0 ? end : begin);
        end = std::min(end, begin);
        winding += crossings_[at].sense;
      }
      markRow(row, 0, winding > 0 ? end : 0);
    }
  }

  void markRow(int row, int begin, int end) {
    for (int column = begin; column < end; ++column) {
      mark({column, row});
    }
  }

  const OccupancyGrid& grid_;
  const base::StopFlag& stop_;
  std::vector<char> marks_;
  std::vector<Crossing> crossings_;
  int background_ = 0;
};

}  // namespace

std::vector<char> cellsOfObstacles(const OccupancyGrid& grid, const Obstacles& obstacles,
                                   bool isLarge, const base::StopFlag& stop) {
  Rasteriser rasteriser(grid, stop);
  for (int part = 0; part < obstacles.partCount(); ++part) {
    if (obstacles.isEnabled(part) && !(isLarge && obstacles.isOfMap(part))) {
      rasteriser.add(obstacles.outlines(part));
    }
  }
  return rasteriser.takeMarks();
}

std::vector<char> cellsOfWalls(const OccupancyGrid& grid) {
  std::vector<char> marks(grid.cells().size());
  std::transform(grid.cells().begin(), grid.cells().end(), marks.begin(),
                 [](std::int8_t value) { return value > 50 ? char{1} : char{0}; });
  return marks;
}

}  // namespace sim2d

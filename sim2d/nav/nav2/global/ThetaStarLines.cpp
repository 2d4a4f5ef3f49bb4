#include "sim2d/nav/nav2/global/ThetaStarLines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace sim2d::nav2 {
namespace {

constexpr double kMostSafe = 252.0;       // of a cell's cost, and of c' on a line
constexpr double kUnknownOnLine = 253.0;  // c' of a cell of 255 there

/// Adds up the cells of a line.
class LineSum {
 public:
  LineSum(const Costmap& costmap, const ThetaStarCosts& costs) : costmap_(costmap), costs_(costs) {}

  double sum() const { return sum_; }
  bool isSafe(Cell cell) const { return costs_.isSafe[costmap_.at(cell)]; }

  /// False where the line must not cross; else adds what the cell costs. The index wraps around.
  bool add(int column, int row) {
    const std::uint32_t index =
        static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(costmap_.width()) +
        static_cast<std::uint32_t>(column);
    if (index >= costmap_.costs().size()) {
      return false;
    }
    const std::uint8_t cost = costmap_.costs()[index];
    if (!costs_.isClear[cost]) {
      return false;
    }
    sum_ += costs_.crossed[cost];
    return true;
  }

 private:
  const Costmap& costmap_;
  const ThetaStarCosts& costs_;
  double sum_ = 0.0;
};

/// One axis of a line: where it begins and ends, which way it runs, and the cell beside a corner.
struct LineAxis {
  LineAxis(int from, int to)
      : begin(from),
        end(to),
        length(std::abs(to - from)),
        step(to > from ? 1 : -1),
        beside(to > from ? 0 : -1) {}

  int begin, end, length, step, beside;
};

/// The line of Humble to Kilted along its longer axis; `add(along, across)` is false where blocked.
template <class Add>
bool followCorners(const LineAxis& along, const LineAxis& across, const Add& add) {
  int error = 0, side = across.begin;
  for (int place = along.begin; place != along.end; place += along.step) {
    error += across.length;
    if (error >= along.length) {
      if (!add(place + along.beside, side + across.beside)) {
        return false;
      }
      side += across.step;
      error -= along.length;
    }
    if (error != 0 && !add(place + along.beside, side + across.beside)) {
      return false;
    }
    if (across.length == 0 && !add(place + along.beside, side) &&
        !add(place + along.beside, side - 1)) {
      return false;
    }
  }
  return true;
}

bool followCorners(const LineAxis& x, const LineAxis& y, LineSum& line) {
  if (x.length >= y.length) {
    return followCorners(x, y, [&](int along, int across) { return line.add(along, across); });
  }
  return followCorners(y, x, [&](int along, int across) { return line.add(across, along); });
}

bool followCells(const LineAxis& x, const LineAxis& y, LineSum& line) {
  int error = x.length - y.length;
  for (Cell cell{x.begin, y.begin}; cell != Cell{x.end, y.end};) {
    if (!line.add(cell.column, cell.row)) {
      return false;
    }
    const bool stepsX = 2 * error > -y.length, stepsY = 2 * error <= x.length;
    if (stepsX && stepsY &&
        !(line.isSafe({cell.column + x.step, cell.row}) &&
          line.isSafe({cell.column, cell.row + y.step}))) {
      return false;
    }
    if (stepsX) {
      error -= y.length;
      cell.column += x.step;
    }
    if (stepsY) {
      error += x.length;
      cell.row += y.step;
    }
  }
  return true;
}

}  // namespace

ThetaStarCosts::ThetaStarCosts(const ThetaStarParameters& parameters) {
  const auto traversal = [&](double weighed) {  // in Nav2's order of operations
    return parameters.traversalCost * weighed * weighed / kMostSafe / kMostSafe;
  };
  for (std::size_t cost = 0; cost < entered.size(); ++cost) {
    const bool isUnknown = cost == kNoInformation;
    const double weighed = 26.0 + 0.9 * static_cast<double>(cost);  // c'
    entered[cost] = traversal(weighed);
    crossed[cost] = traversal(isUnknown ? kUnknownOnLine : weighed);
    isSafe[cost] = isUnknown ? parameters.allowUnknown : static_cast<double>(cost) <= kMostSafe;
    isClear[cost] = isUnknown ? parameters.allowUnknown : weighed <= kMostSafe;
  }
}

std::optional<double> thetaStarLine(const Costmap& costmap, const ThetaStarCosts& costs,
                                    Distro distro, Cell from, Cell to) {
  const LineAxis x(from.column, to.column), y(from.row, to.row);
  LineSum line(costmap, costs);
  const bool isFree =
      distro >= Distro::Lyrical ? followCells(x, y, line) : followCorners(x, y, line);
  return isFree ? std::optional<double>(line.sum()) : std::nullopt;
}

double hypotAsGlibc(double x, double y) {
  const double large = std::max(std::fabs(x), std::fabs(y));
  const double small = std::min(std::fabs(x), std::fabs(y));
  constexpr double kNegligible = 0x1p-54;
  if (small <= large * kNegligible) {
    return large + small;
  }
  const double root = std::sqrt(large * large + small * small);
  double first = 0.0, second = 0.0;  // of the remainder large^2 + small^2 - root^2, negated
  if (root <= 2.0 * small) {
    const double delta = root - small;
    first = large * (2.0 * delta - large);
    second = (delta - 2.0 * (large - small)) * delta;
  } else {
    const double delta = root - large;
    first = 2.0 * delta * (large - 2.0 * small);
    second = (4.0 * delta - small) * small + delta * delta;
  }
  return root - (first + second) / (2.0 * root);
}

}  // namespace sim2d::nav2

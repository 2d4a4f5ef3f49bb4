#include "sim2d/map/DistanceTransform.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sim2d {

namespace {

constexpr float kNowhere = std::numeric_limits<float>::infinity();

float stepFrom(float neighbour) {
  return neighbour == 0.0F ? 0.5F : neighbour + 1.0F;
}

std::uint16_t stepFrom(std::uint16_t neighbour) {
  constexpr int kCell = static_cast<int>(kStepsPerCell);
  const int far = neighbour == 0 ? kCell / 2 : neighbour + kCell;
  return static_cast<std::uint16_t>(std::min<int>(far, kMaxSteps));
}

std::uint16_t stepsOf(float steps) {
  return static_cast<std::uint16_t>(std::min(steps, static_cast<float>(kMaxSteps)));
}

/// Distances within each column.
template <class Value>
std::vector<Value> columnDistances(std::size_t width, std::size_t height,
                                   const std::vector<char>& marked, Value none,
                                   const base::StopFlag& stop) {
  std::vector<Value> distance(marked.size());
  for (std::size_t row = 0; row < height; ++row) {
    stop.check();
    for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
      distance[i] = marked[i] != 0 ? Value{0} : (row == 0 ? none : stepFrom(distance[i - width]));
    }
  }
  for (std::size_t row = height - 1; row-- > 0;) {
    stop.check();
    for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
      distance[i] = std::min(distance[i], stepFrom(distance[i + width]));
    }
  }
  return distance;
}

/// Combines the column distances along one row. The nearest square in another column is reached at
/// its left or right border, so the parabolas are placed on the borders k - 0.5.
class RowPass {
 public:
  explicit RowPass(std::size_t width) : width_(width), height_(width + 1) {
    borders_.reserve(width + 1);
    from_.reserve(width + 1);
  }

  void run(float* row) {
    buildEnvelope(row);
    std::size_t at = 0;
    for (std::size_t x = 0; x < width_ && !borders_.empty(); ++x) {
      const auto place = static_cast<double>(x);
      while (at + 1 < borders_.size() && from_[at + 1] < place) {
        ++at;
      }
      const double offset = place - positionOf(borders_[at]);
      const double square = offset * offset + height_[borders_[at]];
      row[x] = std::min(row[x], static_cast<float>(std::sqrt(square)));
    }
  }

 private:
  static double positionOf(std::size_t border) { return static_cast<double>(border) - 0.5; }

  void buildEnvelope(const float* row) {
    borders_.clear();
    from_.clear();
    for (std::size_t border = 0; border <= width_; ++border) {
      const std::size_t right = std::min(border, width_ - 1);
      const std::size_t left = border > 0 ? border - 1 : 0;
      const double lower = std::min(row[left], row[right]);
      if (std::isinf(lower)) {
        continue;
      }
      height_[border] = lower * lower;
      double start = -std::numeric_limits<double>::infinity();
      while (!borders_.empty()) {
        start = crossing(borders_.back(), border);
        if (start > from_.back()) {
          break;
        }
        borders_.pop_back();
        from_.pop_back();
        start = -std::numeric_limits<double>::infinity();
      }
      borders_.push_back(border);
      from_.push_back(start);
    }
  }

  double crossing(std::size_t first, std::size_t second) const {
    const double a = positionOf(first);
    const double b = positionOf(second);
    return (height_[second] + b * b - height_[first] - a * a) / (2.0 * (b - a));
  }

  std::size_t width_;
  std::vector<double> height_;        // squared, by border
  std::vector<std::size_t> borders_;  // of the lower envelope
  std::vector<double> from_;          // where each parabola begins
};

}  // namespace

std::vector<float> distancesToMarked(int width, int height, const std::vector<char>& marked,
                                     const base::StopFlag& stop) {
  assert(width > 0 && height > 0);
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  assert(marked.size() == columns * rows);
  std::vector<float> distance = columnDistances(columns, rows, marked, kNowhere, stop);
  RowPass pass(columns);
  for (std::size_t row = 0; row < rows; ++row) {
    stop.check();
    pass.run(distance.data() + row * columns);
  }
  return distance;
}

std::vector<std::uint16_t> quantizedDistancesToMarked(int width, int height,
                                                      const std::vector<char>& marked,
                                                      const base::StopFlag& stop) {
  assert(width > 0 && height > 0);
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  std::vector<std::uint16_t> steps = columnDistances(columns, rows, marked, kMaxSteps, stop);
  RowPass pass(columns);
  std::vector<float> cells(columns);
  for (std::size_t row = 0; row < rows; ++row) {
    stop.check();
    std::uint16_t* const of = steps.data() + row * columns;
    std::transform(of, of + columns, cells.begin(), [](std::uint16_t value) {
      return value == kMaxSteps ? kNowhere : static_cast<float>(value) / kStepsPerCell;
    });
    pass.run(cells.data());
    std::transform(cells.begin(), cells.end(), of,
                   [](float value) { return stepsOf(value * kStepsPerCell); });
  }
  return steps;
}

CellDistances::CellDistances(int width, int height, const std::vector<char>& marked, float cell,
                             bool isQuantized, const base::StopFlag& stop)
    : step_(cell / kStepsPerCell) {
  if (isQuantized) {
    const bool isAny = std::find(marked.begin(), marked.end(), char{1}) != marked.end();
    saturatedValue_ = isAny ? static_cast<float>(kMaxSteps) * step_ : kNowhere;
    steps_ = quantizedDistancesToMarked(width, height, marked, stop);
    return;
  }
  exact_ = distancesToMarked(width, height, marked, stop);
  for (float& value : exact_) {
    value *= cell;
  }
}

void CellDistances::set(std::size_t index, float distance) {
  if (steps_.empty()) {
    exact_[index] = distance;
  } else {
    steps_[index] = stepsOf(distance / step_);
  }
}

void CellDistances::replaceInfinite(float distance) {
  const auto isFinite = [](float value) { return std::isfinite(value); };
  if (std::any_of(exact_.begin(), exact_.end(), isFinite)) {
    std::replace(exact_.begin(), exact_.end(), kNowhere, distance);
  }
  const auto isNear = [](std::uint16_t value) { return value < kMaxSteps; };
  if (std::isinf(saturatedValue_) && std::any_of(steps_.begin(), steps_.end(), isNear)) {
    saturatedValue_ = std::min(distance, static_cast<float>(kMaxSteps) * step_);
  }
}

}  // namespace sim2d

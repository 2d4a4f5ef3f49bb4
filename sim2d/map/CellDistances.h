#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim2d/base/Stop.h"

namespace sim2d {

/// Exact Euclidean distance, in cells, from the centre of each cell of a row-major grid to the
/// nearest square of a marked cell: 0 in marked cells, 0.5 beside them, infinity when none is
/// marked. Linear in the number of cells (Felzenszwalb and Huttenlocher 2012, lower envelope of
/// parabolas, here over the borders of cells).
std::vector<float> distancesToMarked(int width, int height, const std::vector<char>& marked,
                                     const base::StopFlag& stop = {});

/// The same in two bytes per cell: in steps of 1/256 cell, rounded down, `kMostSteps` where it is
/// more or nothing is marked.
std::vector<std::uint16_t> stepsToMarked(int width, int height, const std::vector<char>& marked,
                                         const base::StopFlag& stop = {});
constexpr std::uint16_t kMostSteps = 65535;
constexpr float kStepsPerCell = 256.0F;

/// Distances of all cells times a length, as floats or (`isSmall`) as steps.
class CellDistances {
 public:
  CellDistances() = default;
  CellDistances(int width, int height, const std::vector<char>& marked, float cell, bool isSmall,
                const base::StopFlag& stop);

  /// Infinite where nothing is marked.
  float at(std::size_t index) const {
    if (steps_.empty()) {
      return exact_[index];
    }
    return steps_[index] == kMostSteps ? beyond_ : static_cast<float>(steps_[index]) * step_;
  }
  void set(std::size_t index, float distance);
  /// Where it is infinite, unless it is so everywhere.
  void replaceInfinite(float distance);
  std::size_t bytes() const { return sizeof(float) * exact_.size() + 2 * steps_.size(); }

 private:
  std::vector<float> exact_;
  std::vector<std::uint16_t> steps_;
  float step_ = 0.0F;    // the length of one
  float beyond_ = 0.0F;  // where there are `kMostSteps`
};

}  // namespace sim2d

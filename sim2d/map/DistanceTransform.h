#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim2d/base/StopFlag.h"

namespace sim2d {

/// Exact Euclidean distance transform: distance [cells] from the centre of each cell of a row-major
/// grid to the nearest square of a marked cell; 0 in marked cells, 0.5 in adjacent ones, infinity
/// if no cell is marked. Linear time (Felzenszwalb and Huttenlocher 2012, lower envelope of
/// parabolas, here placed on cell borders).
std::vector<float> distancesToMarked(int width, int height, const std::vector<char>& marked,
                                     const base::StopFlag& stop = {});

/// The same in two bytes per cell: units of 1/256 cell, rounded down; `kMaxSteps` for larger
/// distances and if no cell is marked.
std::vector<std::uint16_t> quantizedDistancesToMarked(int width, int height,
                                                      const std::vector<char>& marked,
                                                      const base::StopFlag& stop = {});
constexpr std::uint16_t kMaxSteps = 65535;
constexpr float kStepsPerCell = 256.0F;

/// Distances of all cells multiplied by the cell size, as floats or (`isQuantized`) quantized to 16
/// bits.
class CellDistances {
 public:
  CellDistances() = default;
  CellDistances(int width, int height, const std::vector<char>& marked, float cell,
                bool isQuantized, const base::StopFlag& stop);

  /// Infinity if no cell is marked.
  float at(std::size_t index) const {
    if (steps_.empty()) {
      return exact_[index];
    }
    return steps_[index] == kMaxSteps ? saturatedValue_ : static_cast<float>(steps_[index]) * step_;
  }
  void set(std::size_t index, float distance);
  /// Replaces infinite values by `distance`, unless all are infinite.
  void replaceInfinite(float distance);
  std::size_t bytes() const { return sizeof(float) * exact_.size() + 2 * steps_.size(); }

 private:
  std::vector<float> exact_;
  std::vector<std::uint16_t> steps_;
  float step_ = 0.0F;            // length of one quantization step
  float saturatedValue_ = 0.0F;  // value for `kMaxSteps`
};

}  // namespace sim2d

#pragma once

#include <cstdint>
#include <vector>

#include "sim2d/map/GoalField.h"

namespace sim2d {

/// Which open cells of a terrain hang together: ways exist within a part and nowhere else. A
/// diagonal step passes two open cells, so cells hang together by their sides.
class OpenParts {
 public:
  explicit OpenParts(const Terrain& terrain);
  /// The part of a cell, from 1; 0 for closed cells.
  std::int32_t partOf(Terrain::Index index) const {
    return parts_[static_cast<std::size_t>(index)];
  }

 private:
  void fill(const Terrain& terrain, Terrain::Index from, std::int32_t part);
  std::vector<std::int32_t> parts_;
};

}  // namespace sim2d

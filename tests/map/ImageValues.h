#pragma once

#include <vector>

#include "sim2d/map/MapReader.h"

namespace sim2d {

/// Of all rows, one after the other.
inline std::vector<std::uint16_t> valuesOf(const MapImage& image) {
  std::vector<std::uint16_t> values;
  std::vector<std::uint16_t> row(image.valuesPerRow());
  for (int i = 0; i < image.height; ++i) {
    image.readRow(i, row.data());
    values.insert(values.end(), row.begin(), row.end());
  }
  return values;
}

}  // namespace sim2d

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/map/MapReader.h"

namespace sim2d {

/// A PGM image, first row on top: a quarter of the memory of a MapImage.
struct PgmImage {
  int width = 0, height = 0;
  int maximum = 255;                  // white, 1..65535
  std::vector<std::uint16_t> shades;  // 0..maximum
};

/// P2 and P5, 8 and 16 bit, comments.
base::Result<PgmImage> readPgm(const std::string& path);
/// The grid that gridFromImage makes of the same image.
OccupancyGrid gridFromPgm(const PgmImage& image, const MapDescription& description, MapRule rule);

}  // namespace sim2d

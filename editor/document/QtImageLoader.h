#pragma once

#include <string>

#include "sim2d/map/MapReader.h"

namespace editor {

/// Map images by Qt: PNG (also palette, grey with alpha, 16 bit, interlaced), BMP, JPEG … Refuses
/// files that are no image, and images over 100 million pixels before they are decoded.
base::Result<sim2d::MapImage> loadMapImage(const std::string& path);

}  // namespace editor

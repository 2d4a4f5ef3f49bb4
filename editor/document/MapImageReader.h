#pragma once

#include <string>

#include "sim2d/base/Result.h"
#include "sim2d/map/MapReader.h"

namespace editor {

/// Loads map images with Qt: PNG (also palette, grey with alpha, 16 bit, interlaced), BMP, JPEG …
/// Rejects files that are not images, and images of more than 100 million pixels before decoding.
base::Result<sim2d::MapImage> loadMapImage(const std::string& path);

}  // namespace editor

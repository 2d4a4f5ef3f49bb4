#pragma once

#include <string>

#include "sim2d/base/Result.h"
#include "sim2d/map/MapReader.h"

namespace app {

/// editor::loadMapImage, without the words that image libraries write to the standard error by
/// themselves: what is wrong is in the result. While no other thread writes there.
base::Result<sim2d::MapImage> loadMapImage(const std::string& path);

}  // namespace app

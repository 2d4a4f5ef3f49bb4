#pragma once

#include <string>

#include "sim2d/base/Result.h"
#include "sim2d/map/MapReader.h"

namespace app {

/// Calls editor::loadMapImage, but discards what image libraries write to standard error; problems
/// are in the result. No other thread may write to standard error meanwhile.
base::Result<sim2d::MapImage> loadMapImage(const std::string& path);

}  // namespace app

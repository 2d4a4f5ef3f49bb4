#pragma once

#include <string>
#include <vector>

#include "sim2d/base/FileSet.h"
#include "sim2d/map/OccupancyGrid.h"

namespace sim2d {

/// What writeMap (MapReader.h) would write: the image, then the YAML. An error for the open plane.
base::Result<std::vector<base::FileContent>> mapFileContents(const OccupancyGrid& grid,
                                                             const std::string& yamlPath);

}  // namespace sim2d

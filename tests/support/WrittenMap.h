#pragma once

#include <string>

#include "sim2d/map/MapReader.h"

namespace sim2d {

/// The YAML of a map and its image beside it. Empty: written.
inline base::Diagnostics writeMap(const OccupancyGrid& grid, const std::string& yamlPath) {
  const base::Result<std::vector<base::FileContent>> files = mapFileContents(grid, yamlPath);
  return files ? base::writeFilesAtomically(*files) : files.diagnostics();
}

}  // namespace sim2d

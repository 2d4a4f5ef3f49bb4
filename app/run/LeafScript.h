#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/Types.h"

namespace app {

/// What leaves answer while a tree is played: YAML, `IsRobotVisible: [FAILURE, SUCCESS]`. A key is
/// the name of a leaf or the ID of leaves; the statuses are those of its calls in order, the last
/// one repeats. One status alone needs no list.
struct LeafScript {
  struct Entry {
    std::string leaf;
    std::vector<base::NodeStatus> statuses;  // never empty; SUCCESS, FAILURE or RUNNING
    int line = 0, column = 0;
  };
  std::string path;
  std::vector<Entry> entries;  // in the order of the file

  const Entry* find(const std::string& leaf) const;  // nullptr = not in the script
};

/// Every problem with file, line and column.
base::Result<LeafScript> readLeafScript(const std::string& path);

}  // namespace app

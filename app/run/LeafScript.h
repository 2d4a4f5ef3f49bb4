#pragma once

#include <string>
#include <vector>

#include "bt/engine/Program.h"
#include "sim2d/base/Result.h"

namespace app {

/// What leaves answer while a tree is played.
struct LeafScript {
  struct Entry {
    std::string leaf;
    std::vector<base::NodeStatus> statuses;  // never empty; SUCCESS, FAILURE or RUNNING
    int line = 0, column = 0;
  };
  std::string path;
  std::vector<Entry> entries;  // in the order of the file

  const Entry* find(const std::string& leaf) const {  // nullptr = not in the script
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&leaf](const Entry& entry) { return entry.leaf == leaf; });
    return found == entries.end() ? nullptr : &*found;
  }
};

/// Every problem of the file with line and column.
base::Result<LeafScript> readLeafScript(const std::string& path);

/// Names of the script that no leaf has, as warnings: most likely a slip.
base::Diagnostics unusedNames(const bt::Program& program, const LeafScript& script);

}  // namespace app

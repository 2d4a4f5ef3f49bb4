#pragma once

#include <string>
#include <vector>

#include "app/run/BatchFolder.h"

namespace app {

/// Joins the folders of all shards of one study in `output`: its results.csv has the bytes of a
/// batch without shards; run folders that were kept are copied. Errors, all at once: shards of
/// different studies, twice, missing, not complete.
base::Result<std::unique_ptr<BatchFolder>> mergeShards(const std::string& output,
                                                       const std::vector<std::string>& shards,
                                                       Earlier earlier);

}  // namespace app

#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/trace/Frame.h"

namespace sim2d {

/// Rows of `scans.csv`, one per lidar scan (columns: FORMAT.md); reading returns equal values.
std::string scansHeader();
void appendScanRow(std::string& to, const RecordedScan& scan);
/// Reports all problems with their places; steps must not decrease.
base::Result<std::vector<RecordedScan>> parseScans(const std::string& text,
                                                   const std::string& file);

}  // namespace sim2d

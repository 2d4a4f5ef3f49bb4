#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/trace/Frame.h"

namespace sim2d {

/// Rows of `scans.csv`, one per turn (columns: FORMAT.md); reading gives equal values.
std::string scansHead();
void appendScanRow(std::string& to, const RecordedScan& scan);
/// Every problem with its place; steps must not run backwards.
base::Result<std::vector<RecordedScan>> parseScans(const std::string& text,
                                                   const std::string& file);

}  // namespace sim2d

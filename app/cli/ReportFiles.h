#pragma once

#include <string>
#include <vector>

#include "app/report/Page.h"
#include "sim2d/base/Files.h"

namespace app {

/// All files of a report, relative to its folder.
std::vector<base::FileContent> filesOf(const report::Report& report, bool withPdf);

/// The report of a batch with the design of a sensitivity analysis. Error: runs are missing.
base::Result<report::Report> sensitivityReport(const report::Study& study,
                                               const std::vector<std::string>& command);

/// Writes a report into the folder of a batch and removes figures and tables of an earlier one.
base::Diagnostics writeReport(const std::string& folder,
                              const std::vector<base::FileContent>& files, bool force);

}  // namespace app

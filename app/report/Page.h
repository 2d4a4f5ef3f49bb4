#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/report/Comparison.h"
#include "app/report/Figure.h"
#include "app/report/Markup.h"
#include "app/report/RunPictures.h"

namespace report {

/// A report: the page and its additional files.
struct Report {
  std::string html;
  std::vector<Figure> figures;
  std::vector<Table> tables;                                    // written as CSV and LaTeX
  std::vector<std::pair<std::string, std::string>> moreTables;  // name, CSV text
  std::vector<std::pair<std::string, std::string>> moreFiles;   // name, text
  base::Diagnostics problems;                                   // warnings
};

/// Progress callback.
using ProgressCallback = std::function<void(const std::string& what)>;

/// Creates the report. The output is deterministic. `command`: the command line of this report.
Report makeReport(const Study& study, const std::vector<std::pair<std::string, double>>& weights,
                  const std::vector<std::string>& command, const ProgressCallback& onProgress = {});

/// A page with the methods section alone. `command`: the command line that it is made for.
std::string methodsPage(const Study& study, const std::vector<std::string>& command);

}  // namespace report

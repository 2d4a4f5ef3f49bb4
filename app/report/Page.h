#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/report/Comparison.h"
#include "app/report/Figure.h"
#include "app/report/Markup.h"
#include "app/report/RunPictures.h"

namespace report {

/// A report: the page and what lies beside it.
struct Report {
  std::string html;
  std::vector<Figure> figures;
  std::vector<Table> tables;                                    // as CSV and LaTeX
  std::vector<std::pair<std::string, std::string>> moreTables;  // name, CSV text
  base::Diagnostics problems;                                   // warnings
};

/// Is told what is worked on.
using OnStep = std::function<void(const std::string& what)>;

/// The same study and words give the same bytes. `command`: the words that ask for this report.
Report makeReport(const Study& study, const std::vector<std::pair<std::string, double>>& weights,
                  const std::vector<std::string>& command, const OnStep& onStep = {});

}  // namespace report

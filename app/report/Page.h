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

/// A page that plays one run; `contacts` as for playerJson().
std::string playerPage(const sim2d::Trace& trace,
                       const std::vector<metrics::RobotContact>& contacts,
                       const std::string& title);

/// The skeleton with its holes filled; `withPlayer`: its script too.
std::string wholePage(const std::string& title, const std::string& body, bool withPlayer);
/// The player's box and the runs' data, JSON each.
std::string playerMarkup(const std::vector<std::string>& runs);

}  // namespace report

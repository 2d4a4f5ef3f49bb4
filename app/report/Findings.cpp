#include "app/report/Findings.h"

#include <vector>

#include "app/report/Markup.h"
#include "app/report/Tables.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

/// Those that are no leaders.
std::vector<std::string> namesOf(const Study& study, const MetricComparison& comparison,
                                 Standing standing) {
  std::vector<std::string> names;
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    if (!comparison.leads(option) && comparison.standings[option] == standing) {
      names.push_back(study.options[option]);
    }
  }
  return names;
}

std::string someOf(const std::vector<std::string>& names) {
  constexpr std::size_t kMostNames = 6;
  return names.size() > kMostNames ? std::to_string(names.size()) + " others"
                                   : escaped(base::join(names, ", "));
}

}  // namespace

std::string findingMarkup(const Study& study, const MetricComparison& comparison) {
  if (!comparison.best) {
    return {};
  }
  const Metric& metric = study.metrics[comparison.metric];
  const double best = comparison.estimates[*comparison.best].mean;
  std::vector<std::string> leaders;  // the best, and who equals it
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    if (comparison.leads(option)) {
      leaders.push_back(study.options[option]);
    }
  }
  const std::vector<std::string> beaten = namesOf(study, comparison, Standing::Beaten);
  const std::vector<std::string> close = namesOf(study, comparison, Standing::Close);
  const std::vector<std::string> ahead = namesOf(study, comparison, Standing::Ahead);
  const std::vector<std::string> pieces = namesOf(study, comparison, Standing::NoSuccess);
  const int decimals = decimalsFor(comparison.estimates, metric.isRate);
  const std::string unit = metric.unit.empty() || metric.unit == "-" ? "" : " " + metric.unit;
  std::string words = element("b", "", escaped(metric.name)) +
                      (leaders.size() == 1 ? ": best is " : ": best are ") +
                      escaped(base::join(leaders, ", ")) + " (" +
                      escaped(estimateText(metric, best, decimals) + unit) + ")";
  const bool beatsAll = close.empty() && ahead.empty() && pieces.empty() && beaten.size() > 1;
  const char* between = ", ";
  const auto add = [&](const std::vector<std::string>& names, const std::string& more) {
    words += names.empty() ? "" : between + more;
    between = names.empty() ? between : "; ";
  };
  add(beaten, "better than " + (beatsAll ? "all others" : someOf(beaten)));
  add(close, "not clearly different from " + someOf(close));
  add(ahead, "but " + someOf(ahead) + (ahead.size() == 1 ? " is" : " are") +
                 " better on the same cases and seeds");
  add(pieces, someOf(pieces) +
                  (pieces.size() == 1 ? " never succeeds and is" : " never succeed and are") +
                  " left out");
  return words + ".";
}

}  // namespace report

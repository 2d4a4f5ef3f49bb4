#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/Figure.h"

namespace report {

/// A metric over the time of a run.
struct TimeCurve {
  std::string name, unit;      // unit: empty = none
  std::vector<double> times;   // [s], ascending
  std::vector<double> values;  // NaN: undefined, a gap
};

/// Metrics over time for a paper, one panel above the other with a common time axis; at least one
/// curve. `width` [px]: below 900 the figure is for a column or page. `caption`: a line below;
/// `at` [s]: the time of a vertical line, if it is within the run.
Figure timePlot(const std::vector<TimeCurve>& curves, double width, const std::string& caption = {},
                std::optional<double> at = {});

}  // namespace report

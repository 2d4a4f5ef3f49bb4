#pragma once

#include <string>
#include <vector>

#include "app/report/Comparison.h"
#include "app/report/Study.h"

namespace report {

/// The result of a comparison as a sentence (markup); empty: nothing was compared. "Path length:
/// best is dwa (7.1 m), better than pursuit; not clearly different from mppi."
std::string findingMarkup(const Study& study, const MetricComparison& comparison);

/// The markup of the methods section: procedures with references, versions and inputs, and the
/// commands. `blocks`: number of blocks; `command`: the command line of this report.
std::string methodsMarkup(const Study& study, std::size_t blocks,
                          const std::vector<std::string>& command);

}  // namespace report

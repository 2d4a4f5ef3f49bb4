#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/Page.h"
#include "app/report/Sensitivity.h"

namespace report {

/// The page of a sensitivity analysis. The output is deterministic. `command`: its command line.
Report makeSensitivityReport(const Study& study, const SensitivityAnalysis& analysis,
                             const std::vector<std::string>& command);

/// Per metric, the factors that matter, as a sentence: "Path length [m]: max_vel (μ* 1.2), …".
std::vector<std::string> sensitivityFindings(const Study& study,
                                             const SensitivityAnalysis& analysis);
/// Per result, why its points or seeds are too few; empty: they suffice.
std::vector<std::string> sensitivityWarnings(const Study& study,
                                             const SensitivityAnalysis& analysis);

// Parts of the page.

/// The names of the factors: the last part of the path if it is unique, otherwise the path.
std::vector<std::string> factorNames(const Study& study);
/// Ranked bars of one metric, a panel per case: mu*, or the total and first-order index.
/// `metric`: in SensitivityAnalysis::metrics.
Figure importanceFigure(const Study& study, const SensitivityAnalysis& analysis,
                        std::size_t metric);
/// Mu* and sigma of one metric in a plane, a panel per case. Nothing: not of Morris' method.
std::optional<Figure> effectsFigure(const Study& study, const SensitivityAnalysis& analysis,
                                    std::size_t metric);

}  // namespace report

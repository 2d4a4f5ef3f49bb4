#pragma once

#include <string>

#include "app/report/Plots.h"

/// The results of a study as sentences (markup).
namespace report {

/// A paragraph for the top of a report: which option is better in which metrics, by how much and
/// with which confidence interval, and the metrics in which no difference could be shown, with the
/// number of seeds. Success comes first, then contacts, the time to the goal, and all others by the
/// size of the difference relative to the mean; except for success and contacts, differences below
/// 2 % of the mean come last, without numbers. Only paired tests with p < 0.05 after Holm's
/// adjustment count; neutral metrics are omitted. If all seeds gave the same values, nothing can be
/// tested, and the paragraph states only this. Empty: nothing is compared.
std::string verdictMarkup(const Study& study, const Comparisons& comparisons);

/// The result of one comparison as a sentence; empty: nothing was compared. "Path length: best is
/// dwa (7.1 m), better than pursuit; not clearly different from mppi."
std::string findingMarkup(const Study& study, const MetricComparison& comparison);

}  // namespace report

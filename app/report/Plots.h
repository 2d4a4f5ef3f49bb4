#pragma once

#include <optional>
#include <vector>

#include "app/report/Comparison.h"
#include "app/report/Figure.h"

/// Figures of a comparison. Each takes the comparisons of the metrics that are shown.
namespace report {

using Comparisons = std::vector<MetricComparison>;

/// Rates with Wilson's intervals; nothing when no rate is shown.
std::optional<Figure> ratesFigure(const Study& study, const Comparisons& comparisons);
/// Means with their intervals.
std::optional<Figure> intervalsFigure(const Study& study, const Comparisons& comparisons);
/// Boxes and strips of all values.
std::optional<Figure> distributionFigure(const Study& study, const Comparisons& comparisons);
/// Differences of pairs of options on the same seeds.
std::optional<Figure> differencesFigure(const Study& study, const Comparisons& comparisons);
/// Mean ranks with Nemenyi's critical difference (Demšar 2006, figure 1).
std::optional<Figure> ranksFigure(const Study& study, const Comparisons& comparisons);
/// Two metrics against each other, with the front.
std::optional<Figure> paretoFigure(const Study& study, const MetricComparison& x,
                                   const MetricComparison& y);
/// Mean of a metric per case and option, the hardest case first.
std::optional<Figure> difficultyFigure(const Study& study, std::size_t metric);

/// The pairs of a comparison worth showing: all of few, else those with the best.
std::vector<const PairResult*> shownPairs(const MetricComparison& comparison);
/// "Path length [m]".
std::string titleOf(const Metric& metric);

}  // namespace report

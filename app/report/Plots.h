#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/report/Comparison.h"
#include "app/report/Figure.h"

/// Comparison figures, each of which takes the comparisons of the displayed metrics, and placement
/// of point labels without overlaps.

namespace report {

using Comparisons = std::vector<MetricComparison>;

/// Rates with Wilson intervals, or means with their intervals. Nothing: none is displayed.
std::optional<Figure> intervalsFigure(const Study& study, const Comparisons& comparisons,
                                      bool rates);
/// Box plots and strips of all values.
std::optional<Figure> distributionFigure(const Study& study, const Comparisons& comparisons);
/// Paired differences of options on the same seeds.
std::optional<Figure> differencesFigure(const Study& study, const Comparisons& comparisons);
/// Mean ranks with Nemenyi's critical difference (Demšar 2006, figure 1).
std::optional<Figure> ranksFigure(const Study& study, const Comparisons& comparisons);
/// A scatter plot of two metrics with the Pareto front.
std::optional<Figure> paretoFigure(const Study& study, const MetricComparison& x,
                                   const MetricComparison& y);
/// The mean of a metric per case and option, hardest case first.
std::optional<Figure> difficultyFigure(const Study& study, std::size_t metric);

/// The displayed pairs: all if there are few, otherwise those with the best option.
std::vector<const PairResult*> shownPairs(const MetricComparison& comparison);
/// The title of a metric: "Path length [m]".
std::string titleOf(const Metric& metric);

/// Shared parts of the comparison figures.

constexpr double kTitle = 22.0;         // [px], title above a panel
constexpr double kAxis = 24.0;          // [px], axis below a panel
constexpr std::size_t kMostDots = 150;  // per row

/// The range of defined numbers.
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value);  // NaN is ignored
  void add(const Interval& interval) {
    add(interval.low);
    add(interval.high);
  }
  bool isEmpty() const { return low > high; }
};

/// The means and intervals of all options.
Extent extentOf(const MetricComparison& comparison);
/// As paddedScale; if all values are 0, the scale is [0, 1] with a margin.
Scale scaleOfValues(const Extent& values, double from, double to);
/// The comparisons of rates, or of all other metrics.
std::vector<const MetricComparison*> comparisonsOfKind(const Study& study,
                                                       const Comparisons& comparisons, bool rates);
/// The width [px] for the option names beside a panel, including the gap: that of the longest name,
/// at most `most`.
double namesWidth(const Study& study, double most);
/// The number of columns for `count` panels with option names of `names` px: two if the names leave
/// more than half of a panel.
int columnsOfPanels(std::size_t count, double names);
void panelTitle(Figure& figure, const std::string& title, double left, double top);
/// The option name, shortened to the width [px].
std::string nameOfOption(const Study& study, std::size_t option, double room);
std::string levelText(double level);  // "95 %", "97.5 %"
/// Draws all values, or an evenly spaced selection of the sorted values, as dots with vertical
/// jitter.
void stripPlot(Figure& figure, const Numbers& values, const Scale& scale, double y, double height,
               const std::string& role);

constexpr double kMostNames = 0.6;  // share of a panel's width

/// Draws panels of one height in columns: draw(figure, index, left, top, width).
template <class Draw>
Figure panels(const char* name, std::size_t count, double height, int columns, Draw draw,
              double gap = 24.0) {
  PanelGrid grid;
  grid.count = count;
  grid.panelHeight = height;
  grid.columns = columns;
  grid.gap = gap;
  Figure figure(name, grid.width, grid.height());
  grid.forEach([&](std::size_t k, double left, double top) {
    draw(figure, k, left, top, grid.panelWidth());
  });
  return figure;
}

struct Box {
  base::Vec2 low = base::Vec2::Zero(), high = base::Vec2::Zero();  // [px]
};
struct Segment {
  base::Vec2 from = base::Vec2::Zero(), to = base::Vec2::Zero();  // [px]
};

struct Label {
  std::string words;
  base::Vec2 point = base::Vec2::Zero();  // [px], centre of its mark
};

/// The position of a label.
struct PlacedLabel {
  Box box;
  bool hasLeader = false;  // far from its point: drawn with a leader line
  Segment leader;          // from the mark to the label
};

/// Places each label within the bounds without covering labels or marks; lines are covered only if
/// no other position is near. Greedy, repeated a few times.
std::vector<PlacedLabel> placeLabels(const std::vector<Label>& labels,
                                     const std::vector<Segment>& lines, const Box& bounds);

void drawLabels(Figure& figure, const std::vector<Label>& labels,
                const std::vector<PlacedLabel>& places);

}  // namespace report

#pragma once

#include <limits>
#include <string>
#include <vector>

#include "app/report/Plots.h"

/// What the figures of a comparison share.
namespace report {

constexpr double kTitle = 22.0;         // px above a panel
constexpr double kAxis = 24.0;          // px below it
constexpr std::size_t kMostDots = 150;  // per strip

/// Smallest and largest of numbers that are defined.
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value);  // NaN: nothing
  void add(const Interval& interval) {
    add(interval.low);
    add(interval.high);
  }
  bool isEmpty() const { return low > high; }
};

/// As roomyScale does; where there is nothing but zeros, from them to one.
Scale scaleOfValues(const Extent& values, double from, double to);
/// The comparisons of rates, or of the other metrics.
std::vector<const MetricComparison*> ofKind(const Study& study, const Comparisons& comparisons,
                                            bool rates);
/// Width [px] for the names of the options beside a panel, including the gap: as the longest name
/// needs, up to `most`.
double namesWidth(const Study& study, double most);
/// Number of columns for so many panels, with `names` px for names beside them when width is not
/// limited: two where the names leave more than half of a panel.
int columnsOfPanels(std::size_t count, double names);
/// Draws the names of all options beside their rows, in a width of so many px.
void optionNames(Figure& figure, const Study& study, double left, double top, double rowHeight,
                 double width);
void panelTitle(Figure& figure, const std::string& title, double left, double top);
/// As much of the text as fits into the width [px].
std::string nameOfOption(const Study& study, std::size_t option, double room);
std::string percentText(double share);  // "95 %"
std::string levelText(double level);    // "95 %", "97.5 %"
/// Dots of all values, or of evenly many of the sorted ones, across a strip.
void strip(Figure& figure, const Numbers& values, const Scale& scale, double y, double height,
           const std::string& role);

constexpr double kMostNames = 0.6;  // of a panel

/// Panels of one height in columns: draw(figure, index, left, top, width).
template <class Draw>
Figure panels(const char* name, std::size_t count, double height, int columns, Draw draw) {
  PanelGrid grid;
  grid.count = count;
  grid.panelHeight = height;
  grid.columns = columns;
  grid.gap = 24.0;
  Figure figure(name, grid.width, grid.height());
  grid.forEach([&](std::size_t k, double left, double top) {
    draw(figure, k, left, top, grid.panelWidth());
  });
  return figure;
}

}  // namespace report

#pragma once

#include <limits>
#include <string>
#include <vector>

#include "app/report/Plots.h"

/// What the figures of a comparison share.
namespace report {

constexpr double kNames = 104.0;        // px for the names of options
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
/// Names of all options beside their rows.
void optionNames(Figure& figure, const Study& study, double left, double top, double rowHeight);
void panelTitle(Figure& figure, const std::string& title, double left, double top);
std::string nameOfOption(const Study& study, std::size_t option);  // as long as there is room
std::string percentText(double share);                             // "95 %"
std::string levelText(double level);                               // "95 %", "97.5 %"
/// Dots of all values, or of evenly many of the sorted ones, across a strip.
void strip(Figure& figure, const Numbers& values, const Scale& scale, double y, double height,
           const std::string& role);

/// Panels of one height in two columns, one alone in one: draw(figure, index, left, top, width).
template <class Draw>
Figure panels(const char* name, std::size_t count, double height, Draw draw) {
  PanelGrid grid;
  grid.count = count;
  grid.panelHeight = height;
  grid.columns = count == 1 ? 1 : 2;
  grid.gap = 24.0;
  Figure figure(name, grid.width, grid.height());
  grid.forEach([&](std::size_t k, double left, double top) {
    draw(figure, k, left, top, grid.panelWidth());
  });
  return figure;
}

}  // namespace report

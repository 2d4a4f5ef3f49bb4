#include "app/report/PlotParts.h"

#include <algorithm>
#include <cmath>

#include "app/report/Markup.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

/// Numbers to place as dots.
Numbers dotsOf(Numbers values) {
  if (values.size() <= kMostDots) {
    return values;
  }
  std::sort(values.begin(), values.end());
  Numbers dots;
  dots.reserve(kMostDots);
  for (std::size_t k = 0; k < kMostDots; ++k) {
    dots.push_back(values[k * (values.size() - 1) / (kMostDots - 1)]);
  }
  return dots;
}

/// A place across a strip that looks random and is not: golden ratio.
double scatter(std::size_t k) {
  const double turns = static_cast<double>(k) * 0.6180339887498949;
  return turns - std::floor(turns) - 0.5;
}

}  // namespace

void Extent::add(double value) {
  if (!std::isnan(value)) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
}

Scale scaleOfValues(const Extent& values, double from, double to) {
  const bool areZeros = values.low == 0.0 && values.high == 0.0;
  return roomyScale(values.low, areZeros ? 1.0 : values.high, from, to);
}

std::vector<const MetricComparison*> ofKind(const Study& study, const Comparisons& comparisons,
                                            bool rates) {
  std::vector<const MetricComparison*> found;
  for (const MetricComparison& comparison : comparisons) {
    if (study.metrics[comparison.metric].isRate == rates) {
      found.push_back(&comparison);
    }
  }
  return found;
}

double namesWidth(const Study& study, double most) {
  constexpr double kLeast = 104.0;
  constexpr double kGap = 16.0;
  std::size_t longest = 0;
  for (const std::string& option : study.options) {
    longest = std::max(longest, characterCount(option));
  }
  return std::min(std::max(kLeast, kLetter * static_cast<double>(longest) + kGap), most);
}

int columnsOfPanels(std::size_t count, double names) {
  PanelGrid two;
  return count == 1 || names > 0.5 * two.panelWidth() ? 1 : two.columns;
}

std::string nameOfOption(const Study& study, std::size_t option, double room) {
  return shortened(study.options[option], static_cast<std::size_t>(room / kLetter));
}

void optionNames(Figure& figure, const Study& study, double left, double top, double rowHeight,
                 double width) {
  constexpr double kGap = 10.0;
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    const double y = top + (static_cast<double>(option) + 0.5) * rowHeight;
    figure.text(left + width - kGap, y + 4.0, nameOfOption(study, option, width - kGap), "ink",
                Figure::Anchor::End);
  }
}

void panelTitle(Figure& figure, const std::string& title, double left, double top) {
  constexpr std::size_t kTitleLength = 46;
  constexpr double kSize = 11.5;
  figure.text(left, top + 12.0, shortened(title, kTitleLength), "ink", Figure::Anchor::Start,
              kSize);
}

std::string percentText(double share) {
  return numberText(100.0 * share, 0) + " %";
}

std::string levelText(double level) {
  return base::formatDouble(std::round(1e8 * level) / 1e6) + " %";
}

void strip(Figure& figure, const Numbers& values, const Scale& scale, double y, double height,
           const std::string& role) {
  const Numbers dots = dotsOf(values);
  for (std::size_t k = 0; k < dots.size(); ++k) {
    figure.disc(scale.at(dots[k]), y + scatter(k) * height, 1.6, role, 0.45);
  }
}

}  // namespace report

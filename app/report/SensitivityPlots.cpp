#include <algorithm>
#include <cmath>
#include <map>

#include "app/report/Markup.h"
#include "app/report/Plots.h"
#include "app/report/SensitivityPage.h"

namespace report {

namespace {

using Anchor = Figure::Anchor;

constexpr std::size_t kMostRows = 15;  // factors in a panel
constexpr double kBarRow = 20.0;       // [px]

/// The width of the names beside the bars [px].
double factorNamesWidth(const Study& study, double most) {
  std::size_t longest = 0;
  for (const std::string& name : factorNames(study)) {
    longest = std::max(longest, characterCount(name));
  }
  return std::min(kLetter * static_cast<double>(longest) + 16.0, most);
}

/// The largest number that the bars or intervals of a panel show.
double barsEnd(const SensitivityResult& result) {
  double end = 0.0;
  for (const std::size_t factor : result.ranking().order) {
    const double high = result.importanceInterval(factor).high;
    end = std::max({end, result.importance(factor), std::isnan(high) ? 0.0 : high});
  }
  return end > 0.0 ? end : 1.0;
}

void bar(Figure& figure, const Scale& scale, double y, const SensitivityResult& result,
         std::size_t factor) {
  constexpr double kHalf = 6.0;
  const double value = result.importance(factor);
  if (std::isnan(value)) {
    figure.text(scale.from + 4.0, y + 4.0, "no values", "dim");
    return;
  }
  const auto draw = [&](double to, double opacity) {
    const double width = scale.at(std::max(0.0, to)) - scale.from;
    figure.rect(scale.from, y - kHalf, width, 2.0 * kHalf, fillOf(0), opacity);
  };
  draw(value, result.sobol ? 0.3 : 0.55);
  if (result.sobol) {
    draw(std::min(value, result.sobol->factors[factor].first), 0.6);
  }
  const statistics::Interval interval = result.importanceInterval(factor);
  if (interval.isDefined()) {
    figure.line(scale.at(interval.low), y, scale.at(interval.high), y, "line", 1.4);
  }
}

void barsPanel(Figure& figure, const Study& study, const SensitivityResult& result,
               const base::Vec2& corner, double width) {
  const std::vector<std::string> names = factorNames(study);
  const double left = corner.x(), top = corner.y() + kTitle;
  const double namesEnd = left + factorNamesWidth(study, 0.5 * width);
  const Scale scale{0.0, 1.04 * barsEnd(result), namesEnd, left + width - 18.0};
  const std::size_t rows = std::min(kMostRows, names.size());
  const double bottom = top + static_cast<double>(rows) * kBarRow;
  for (const double tick : axisTicks(scale)) {
    figure.line(scale.at(tick), top, scale.at(tick), bottom, "grid");
  }
  const auto room = static_cast<std::size_t>((namesEnd - left - 10.0) / kLetter);
  for (std::size_t place = 0; place < std::min(rows, result.ranking().order.size()); ++place) {
    const std::size_t factor = result.ranking().order[place];
    const double y = top + (static_cast<double>(place) + 0.5) * kBarRow;
    figure.text(namesEnd - 10.0, y + 4.0, shortened(names[factor], room), "ink", Anchor::End);
    if (result.varies) {
      bar(figure, scale, y, result, factor);
    }
  }
  if (!result.varies) {
    figure.text(scale.from + 4.0, top + 14.0, "does not vary", "dim");
  }
  horizontalAxis(figure, scale, bottom);
}

/// Lines on which sigma is a multiple of mu* (Garcia Sanchez et al. 2014, Energy Build. 68): below
/// 0.1 almost linear, below 0.5 monotonic, below 1 almost monotonic.
void drawRatios(Figure& figure, const Scale& across, const Scale& up) {
  for (const double ratio : {0.1, 0.5, 1.0}) {
    const double end = std::min(across.high, up.high / ratio);
    figure.line(across.at(0.0), up.at(0.0), across.at(end), up.at(ratio * end), "zero");
    figure.text(across.at(end) + (end < across.high ? -4.0 : 4.0), up.at(ratio * end) + 10.0,
                ratio < 1.0 ? numberText(ratio, 1) : "1", "dim", Anchor::Start, 9.0);
  }
}

struct PlaneRange {
  double across = 0.0, up = 0.0;
};
PlaneRange rangeOf(const SensitivityResult& result) {
  PlaneRange range;
  for (const statistics::MorrisFactor& factor : result.morris->factors) {
    range.across = std::max(range.across, factor.meanSize);
    range.up = std::max(range.up, factor.deviation);
  }
  range.across = range.across > 0.0 ? range.across : 1.0;
  range.up = range.up > 0.0 ? range.up : range.across;
  return range;
}

constexpr double kPlaneHeight = 230.0;

void planePanel(Figure& figure, const Study& study, const SensitivityResult& result,
                const base::Vec2& corner, double width) {
  const std::vector<std::string> names = factorNames(study);
  const PlaneRange range = rangeOf(result);
  const Scale across{0.0, 1.08 * range.across, corner.x() + 46.0, corner.x() + width - 30.0};
  const Scale up{0.0, 1.08 * range.up, corner.y() + kPlaneHeight - 34.0, corner.y() + kTitle + 6.0};
  verticalAxis(figure, up, ticks(up.low, up.high, 4), across.from, across.to);
  horizontalAxis(figure, across, up.from);
  figure.text(across.to, up.from + 28.0, "μ*", "ink", Anchor::End);
  figure.text(corner.x() + 2.0, up.to + 4.0, "σ", "ink");
  drawRatios(figure, across, up);
  std::vector<Label> labels;
  for (std::size_t factor = 0; factor < names.size(); ++factor) {
    const statistics::MorrisFactor& each = result.morris->factors[factor];
    if (std::isnan(each.meanSize) || std::isnan(each.deviation)) {
      continue;
    }
    const base::Vec2 at(across.at(each.meanSize), up.at(each.deviation));
    figure.mark(at.x(), at.y(), factor);
    if (result.relativeImportance(factor) >= kNegligible) {
      labels.push_back({shortened(names[factor], 28), at});
    }
  }
  const Box bounds{{across.from, up.to - 8.0}, {across.to + 28.0, up.from - 2.0}};
  drawLabels(figure, labels, placeLabels(labels, {}, bounds));
}

std::string panelTitleOf(const SensitivityAnalysis& analysis, const SensitivityResult& result) {
  return analysis.cases[result.caseNumber];
}

}  // namespace

std::vector<std::string> factorNames(const Study& study) {
  std::vector<std::string> names;
  std::map<std::string, int> counts;
  for (const Study::Factor& factor : study.sensitivity->factors) {
    names.push_back(factor.path.substr(factor.path.rfind('.') + 1));
    ++counts[names.back()];
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (counts[names[k]] > 1) {
      names[k] = study.sensitivity->factors[k].path;
    }
  }
  return names;
}

Figure importanceFigure(const Study& study, const SensitivityAnalysis& analysis,
                        std::size_t metric) {
  const Metric& shown = study.metrics[analysis.metrics[metric]];
  const bool isMorris = analysis.of(metric, 0).morris.has_value();
  const std::size_t factors = study.sensitivity->factors.size();
  const double height =
      kTitle + kBarRow * static_cast<double>(std::min(kMostRows, factors)) + kAxis;
  Figure figure = panels(("importance_" + shown.key).c_str(), analysis.cases.size(), height,
                         columnsOfPanels(analysis.cases.size(), factorNamesWidth(study, 400.0)),
                         [&](Figure& to, std::size_t k, double left, double top, double width) {
                           const SensitivityResult& result = analysis.of(metric, k);
                           panelTitle(to, panelTitleOf(analysis, result), left, top);
                           barsPanel(to, study, result, {left, top}, width);
                         });
  figure.caption =
      titleOf(shown) + ": " +
      (isMorris ? "mean size of the elementary effects, μ*, per full range of each value"
                : "total Sobol index of each value; the dark part is the first-order index") +
      ", with bootstrap confidence intervals, level " + levelText(study.level) +
      (factors > kMostRows ? "; the first " + std::to_string(kMostRows) + " values." : ".");
  return figure;
}

std::optional<Figure> effectsFigure(const Study& study, const SensitivityAnalysis& analysis,
                                    std::size_t metric) {
  if (!analysis.of(metric, 0).morris) {
    return std::nullopt;
  }
  const Metric& shown = study.metrics[analysis.metrics[metric]];
  Figure figure = panels(("effects_" + shown.key).c_str(), analysis.cases.size(), kPlaneHeight,
                         analysis.cases.size() > 1 ? 2 : 1,
                         [&](Figure& to, std::size_t k, double left, double top, double width) {
                           const SensitivityResult& result = analysis.of(metric, k);
                           panelTitle(to, panelTitleOf(analysis, result), left, top);
                           planePanel(to, study, result, {left, top}, width);
                         },
                         28.0);
  figure.caption =
      titleOf(shown) +
      ": mean size μ* and standard deviation σ of the elementary effects. On the dashed lines σ is "
      "0.1, 0.5 and 1 times μ*: below 0.1 the effect is almost linear, below 0.5 monotonic, below "
      "1 "
      "almost monotonic; above, it depends on the other values or changes its sign. Values with "
      "less "
      "than 10 % of the largest μ* have no name.";
  return figure;
}

}  // namespace report

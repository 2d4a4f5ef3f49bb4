#include <algorithm>
#include <cmath>

#include "app/report/Labels.h"
#include "app/report/Markup.h"
#include "app/report/PlotParts.h"
#include "app/report/Plots.h"
#include "metrics/statistics/Choices.h"

namespace report {

namespace {

using Anchor = Figure::Anchor;

statistics::Sense senseOf(const Metric& metric) {
  return metric.sense > 0 ? statistics::Sense::Higher : statistics::Sense::Lower;
}

Extent extentOf(const MetricComparison& comparison) {
  Extent extent;
  for (const Estimate& estimate : comparison.estimates) {
    extent.add(estimate.mean);
    extent.add(estimate.interval);
  }
  return extent;
}

/// " (better ←)".
std::string betterText(const Metric& metric, const char* less, const char* more) {
  return metric.sense < 0   ? std::string(" (better ") + less + ")"
         : metric.sense > 0 ? std::string(" (better ") + more + ")"
                            : std::string();
}

/// The plane of two metrics: scales, axes and their titles.
struct Plane {
  Scale across, up;

  void draw(Figure& figure, const Metric& x, const Metric& y) const {
    const std::vector<double> at = ticks(up.low, up.high, 5);
    const double step = at.size() > 1 ? at[1] - at[0] : 1.0;
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
    for (const double tick : at) {
      figure.line(across.from, up.at(tick), across.to, up.at(tick), "grid");
      figure.text(across.from - 8.0, up.at(tick) + 4.0, numberText(tick, decimals), "dim",
                  Anchor::End, 10.0);
    }
    horizontalAxis(figure, across, up.from);
    figure.text(across.to, up.from + 34.0, titleOf(x) + betterText(x, "←", "→"), "ink",
                Anchor::End);
    figure.text(8.0, 16.0, titleOf(y) + betterText(y, "↓", "↑"), "ink");
  }
};

/// Points of options in a plane, lines that are in the way of their names.
struct PlaneMarks {
  std::vector<Label> labels;
  std::vector<Segment> lines;
};

/// Through the options that no other beats.
void drawFront(Figure& figure, const Plane& plane, const std::vector<bool>& front, const Numbers& x,
               const Numbers& y, PlaneMarks& marks) {
  std::vector<base::Vec2> line;
  for (std::size_t option = 0; option < front.size(); ++option) {
    if (front[option]) {
      line.emplace_back(plane.across.at(x[option]), plane.up.at(y[option]));
    }
  }
  std::sort(line.begin(), line.end(),
            [](const base::Vec2& a, const base::Vec2& b) { return a.x() < b.x(); });
  figure.polyline(line, "zero", 1.2);
  for (std::size_t k = 1; k < line.size(); ++k) {
    marks.lines.push_back({line[k - 1], line[k]});
  }
}

void drawOption(Figure& figure, const Plane& plane, std::size_t option, const Estimate& x,
                const Estimate& y, PlaneMarks& marks) {
  const base::Vec2 at(plane.across.at(x.mean), plane.up.at(y.mean));
  const auto draw = [&](const base::Vec2& from, const base::Vec2& to) {
    figure.line(from.x(), from.y(), to.x(), to.y(), strokeOf(option));
    marks.lines.push_back({from, to});
  };
  if (x.interval.isDefined()) {
    draw({plane.across.at(x.interval.low), at.y()}, {plane.across.at(x.interval.high), at.y()});
  }
  if (y.interval.isDefined()) {
    draw({at.x(), plane.up.at(y.interval.low)}, {at.x(), plane.up.at(y.interval.high)});
  }
  figure.mark(at.x(), at.y(), option, 5.5);
}

/// Points with their names, and the front of those of two metrics that are judged.
void drawOptions(Figure& figure, const Plane& plane, const Study& study, const MetricComparison& x,
                 const MetricComparison& y) {
  const Metric& metricX = study.metrics[x.metric];
  const Metric& metricY = study.metrics[y.metric];
  Numbers atX;
  Numbers atY;
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    atX.push_back(x.estimates[option].mean);
    atY.push_back(y.estimates[option].mean);
  }
  PlaneMarks marks;
  if (metricX.sense != 0 && metricY.sense != 0) {
    Numbers ranked = atX;  // what never succeeds is not on the front
    for (std::size_t option = 0; option < ranked.size(); ++option) {
      ranked[option] = x.succeeds[option] ? ranked[option] : statistics::kUndefined;
    }
    drawFront(figure, plane,
              statistics::paretoFront(ranked, senseOf(metricX), atY, senseOf(metricY)), atX, atY,
              marks);
  }
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    if (!std::isnan(atX[option]) && !std::isnan(atY[option])) {
      drawOption(figure, plane, option, x.estimates[option], y.estimates[option], marks);
      marks.labels.push_back({nameOfOption(study, option, 260.0),
                              {plane.across.at(atX[option]), plane.up.at(atY[option])}});
    }
  }
  const Box room{{plane.across.from + 2.0, 22.0}, {plane.across.to + 130.0, plane.up.from - 2.0}};
  drawLabels(figure, marks.labels, placeLabels(marks.labels, marks.lines, room));
}

/// Means of a metric in one case, per option.
struct CaseRow {
  std::size_t ofCase = 0;
  Numbers means;                         // NaN: no values
  double mean = statistics::kUndefined;  // over the options
};

std::vector<CaseRow> caseRows(const Study& study, std::size_t metric) {
  std::vector<std::vector<Numbers>> values(study.cases.size(),
                                           std::vector<Numbers>(study.options.size()));
  for (std::size_t run = 0; run < study.runCount(); ++run) {
    const double value = valueOf(study, metric, run);
    if (!std::isnan(value)) {
      values[study.caseOf[run]][study.optionOf[run]].push_back(value);
    }
  }
  std::vector<CaseRow> rows(study.cases.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].ofCase = k;
    Numbers defined;
    for (const Numbers& each : values[k]) {
      rows[k].means.push_back(statistics::mean(each));
      if (!each.empty()) {
        defined.push_back(rows[k].means.back());
      }
    }
    rows[k].mean = statistics::mean(defined);
  }
  const double sign = study.metrics[metric].sense > 0 ? 1.0 : -1.0;  // the hardest first
  std::stable_sort(rows.begin(), rows.end(), [sign](const CaseRow& a, const CaseRow& b) {
    return std::isnan(b.mean) ? !std::isnan(a.mean) : sign * a.mean < sign * b.mean;
  });
  return rows;
}

constexpr std::size_t kCaseLength = 38;

/// A cell of the table of cases, tinted by how hard it is.
void drawCell(Figure& figure, const Metric& metric, const Extent& extent, double mean,
              const base::Vec2& corner, const base::Vec2& size) {
  if (!std::isnan(mean)) {
    const double span = extent.high > extent.low ? extent.high - extent.low : 1.0;
    const double share = metric.isRate ? mean : (mean - extent.low) / span;
    const double hardness = metric.sense > 0 ? 1.0 - share : share;
    figure.rect(corner.x() + 1.0, corner.y() + 1.0, size.x() - 2.0, size.y() - 2.0, "hot",
                0.04 + 0.5 * hardness);
  }
  const bool asPercent = metric.isRate && !std::isnan(mean);
  figure.text(corner.x() + 0.5 * size.x(), corner.y() + 16.0,
              asPercent ? percentText(mean) : numberText(mean, 2), "ink", Anchor::Middle);
}

}  // namespace

std::optional<Figure> paretoFigure(const Study& study, const MetricComparison& x,
                                   const MetricComparison& y) {
  const Metric& metricX = study.metrics[x.metric];
  const Metric& metricY = study.metrics[y.metric];
  const Extent wide = extentOf(x);
  const Extent high = extentOf(y);
  if (study.options.size() < 2 || wide.isEmpty() || high.isEmpty()) {
    return std::nullopt;
  }
  constexpr double kWidth = 720.0;
  constexpr double kHeight = 360.0;
  Figure figure("pareto", kWidth, kHeight);
  const Plane plane{scaleOfValues(wide, 64.0, kWidth - 130.0),
                    scaleOfValues(high, kHeight - 52.0, 34.0)};
  plane.draw(figure, metricX, metricY);
  const bool isJudged = metricX.sense != 0 && metricY.sense != 0;
  drawOptions(figure, plane, study, x, y);
  figure.caption =
      titleOf(metricX) + " against " + titleOf(metricY) + ": means with their intervals" +
      (isJudged ? "; the dashed line joins the options that no other beats in both." : ".") +
      (isJudged && std::count(x.succeeds.begin(), x.succeeds.end(), false) > 0
           ? " What never succeeds is not among them."
           : "");
  return figure;
}

std::optional<Figure> difficultyFigure(const Study& study, std::size_t metric) {
  const Metric& what = study.metrics[metric];
  std::vector<CaseRow> rows = caseRows(study, metric);
  Extent extent;
  for (const CaseRow& row : rows) {
    for (const double mean : row.means) {
      extent.add(mean);
    }
  }
  if (rows.size() < 2 || extent.isEmpty()) {
    return std::nullopt;
  }
  constexpr std::size_t kMostRows = 60;
  const bool isCut = rows.size() > kMostRows;
  rows.resize(std::min(rows.size(), kMostRows));
  std::size_t longest = 0;
  for (const CaseRow& row : rows) {
    longest = std::max(longest, shortened(study.cases[row.ofCase], kCaseLength).size());
  }
  const double names = 6.4 * static_cast<double>(longest) + 16.0;
  constexpr double kRow = 24.0;
  constexpr double kLine = 13.0;
  const double cell = std::min(110.0, (720.0 - names) / static_cast<double>(study.options.size()));
  std::vector<std::vector<std::string>> heads;  // lines of the names of options
  std::size_t lines = 1;
  for (const std::string& option : study.options) {
    heads.push_back(wrapped(option, static_cast<std::size_t>(std::max(1.0, cell / kLetter))));
    lines = std::max(lines, heads.back().size());
  }
  const double top = 26.0 + kLine * static_cast<double>(lines - 1);
  Figure figure("difficulty", 720.0, top + kRow * static_cast<double>(rows.size()) + 4.0);
  const auto leftOf = [cell, names](std::size_t option) {
    return names + static_cast<double>(option) * cell;
  };
  for (std::size_t option = 0; option < heads.size(); ++option) {
    double y = top - 10.0 - kLine * static_cast<double>(heads[option].size() - 1);
    for (const std::string& line : heads[option]) {
      figure.text(leftOf(option) + 0.5 * cell, y, line, "ink", Anchor::Middle);
      y += kLine;
    }
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double y = top + kRow * static_cast<double>(k);
    figure.text(names - 10.0, y + 16.0, shortened(study.cases[rows[k].ofCase], kCaseLength), "ink",
                Anchor::End);
    for (std::size_t option = 0; option < study.options.size(); ++option) {
      drawCell(figure, what, extent, rows[k].means[option], {leftOf(option), y}, {cell, kRow});
    }
  }
  figure.caption = titleOf(what) +
                   ", mean per case; the hardest first, the stronger the colour the harder" +
                   (isCut ? " (the first " + std::to_string(kMostRows) + ")." : ".");
  return figure;
}

}  // namespace report

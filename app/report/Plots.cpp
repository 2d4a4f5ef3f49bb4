#include "app/report/Plots.h"

#include <algorithm>
#include <cmath>

#include "app/report/Markup.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

constexpr std::size_t kFewPairs = 3;  // up to this number, all pairs are displayed

/// Draws the option names beside their rows, within this width [px].
void optionNames(Figure& figure, const Study& study, double left, double top, double rowHeight,
                 double width) {
  constexpr double kGap = 10.0;
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    const double y = top + (static_cast<double>(option) + 0.5) * rowHeight;
    figure.text(left + width - kGap, y + 4.0, nameOfOption(study, option, width - kGap), "ink",
                Figure::Anchor::End);
  }
}

/// A panel with one row per option: dot and interval.
void intervalPanel(Figure& figure, const Study& study, const MetricComparison& comparison,
                   double left, double top, double width) {
  constexpr double kRow = 22.0;
  const Metric& metric = study.metrics[comparison.metric];
  panelTitle(figure, titleOf(metric), left, top);
  const Extent extent = extentOf(comparison);
  const double right = left + width - 18.0;
  const double names = namesWidth(study, kMostNames * width);
  const Scale scale = metric.isRate ? Scale{0.0, 1.0, left + names, right}
                                    : scaleOfValues(extent, left + names, right);
  optionNames(figure, study, left, top + kTitle, kRow, names);
  const double bottom = top + kTitle + static_cast<double>(study.options.size()) * kRow;
  for (const double tick : axisTicks(scale)) {
    figure.line(scale.at(tick), top + kTitle, scale.at(tick), bottom, "grid");
  }
  for (std::size_t option = 0; option < comparison.estimates.size(); ++option) {
    const Estimate& estimate = comparison.estimates[option];
    const double y = top + kTitle + (static_cast<double>(option) + 0.5) * kRow;
    if (estimate.interval.isDefined()) {
      figure.line(scale.at(estimate.interval.low), y, scale.at(estimate.interval.high), y,
                  strokeOf(option), 2.0);
    }
    if (!std::isnan(estimate.mean)) {
      figure.mark(scale.at(estimate.mean), y, option);
    } else {
      figure.text(scale.from + 4.0, y + 4.0, "no values", "dim");
    }
  }
  horizontalAxis(figure, scale, bottom, metric.isRate);
}

/// Draws a box plot (Tukey): quartiles, median, whiskers to the farthest values within 1.5
/// interquartile ranges.
void box(Figure& figure, const Numbers& values, const Scale& scale, double y, std::size_t option) {
  const Numbers quartiles = statistics::quantiles(values, {0.25, 0.5, 0.75});
  const double reach = 1.5 * (quartiles[2] - quartiles[0]);
  double low = quartiles[0];
  double high = quartiles[2];
  for (const double value : values) {
    low = value >= quartiles[0] - reach ? std::min(low, value) : low;
    high = value <= quartiles[2] + reach ? std::max(high, value) : high;
  }
  const std::string role = strokeOf(option);
  constexpr double kHalf = 5.0;
  figure.line(scale.at(low), y, scale.at(quartiles[0]), y, role);
  figure.line(scale.at(quartiles[2]), y, scale.at(high), y, role);
  const double left = scale.at(quartiles[0]);
  const double width = std::max(0.5, scale.at(quartiles[2]) - left);
  figure.rect(left, y - kHalf, width, 2.0 * kHalf, fillOf(option), 0.18);
  figure.path("M" + pixel(left) + " " + pixel(y - kHalf) + "h" + pixel(width) + "v" +
                  pixel(2.0 * kHalf) + "h" + pixel(-width) + "Z",
              role);
  figure.line(scale.at(quartiles[1]), y - kHalf, scale.at(quartiles[1]), y + kHalf, role, 2.4);
}

void distributionPanel(Figure& figure, const Study& study, const MetricComparison& comparison,
                       double left, double top, double width) {
  constexpr double kRow = 36.0;
  const Metric& metric = study.metrics[comparison.metric];
  panelTitle(figure, titleOf(metric), left, top);
  Extent extent;
  for (const Estimate& estimate : comparison.estimates) {
    for (const double value : estimate.values) {
      extent.add(value);
    }
  }
  const double names = namesWidth(study, kMostNames * width);
  const Scale scale = scaleOfValues(extent, left + names, left + width - 18.0);
  optionNames(figure, study, left, top + kTitle, kRow, names);
  for (std::size_t option = 0; option < comparison.estimates.size(); ++option) {
    const Numbers& values = comparison.estimates[option].values;
    const double y = top + kTitle + (static_cast<double>(option) + 0.5) * kRow;
    if (!values.empty()) {
      box(figure, values, scale, y - 7.0, option);
      stripPlot(figure, values, scale, y + 9.0, 12.0, fillOf(option));
    }
  }
  horizontalAxis(figure, scale, top + kTitle + static_cast<double>(study.options.size()) * kRow);
}

/// Says that an interval is missing.
std::string singleValueText(const std::vector<const MetricComparison*>& comparisons) {
  for (const MetricComparison* comparison : comparisons) {
    for (const Estimate& estimate : comparison->estimates) {
      if (!std::isnan(estimate.mean) && !estimate.interval.isDefined()) {
        return " Without a line: a single value or equal values have no interval.";
      }
    }
  }
  return {};
}

}  // namespace

std::string titleOf(const Metric& metric) {
  return metric.unit.empty() || metric.unit == "-" ? metric.name
                                                   : metric.name + " [" + metric.unit + "]";
}

std::vector<const PairResult*> shownPairs(const MetricComparison& comparison) {
  std::vector<const PairResult*> pairs;
  for (const PairResult& pair : comparison.pairs) {
    const std::size_t best = comparison.best.value_or(0);
    if (comparison.pairs.size() <= kFewPairs || pair.first == best || pair.second == best) {
      pairs.push_back(&pair);
    }
  }
  return pairs;
}

std::optional<Figure> intervalsFigure(const Study& study, const Comparisons& comparisons,
                                      bool rates) {
  const auto chosen = comparisonsOfKind(study, comparisons, rates);
  if (chosen.empty()) {
    return std::nullopt;
  }
  Figure figure = panels(
      rates ? "success" : "intervals", chosen.size(),
      kTitle + 22.0 * static_cast<double>(study.options.size()) + kAxis,
      columnsOfPanels(chosen.size(), namesWidth(study, PanelGrid().width)),
      [&](Figure& to, std::size_t k, double left, double top, double width) {
        intervalPanel(to, study, *chosen[k], left, top, width);
      },
      20.0);
  figure.caption = std::string(rates ? "Rates with Wilson confidence intervals"
                                     : "Means with bootstrap confidence intervals (BCa)") +
                   ", level " + levelText(study.level) + "." + singleValueText(chosen);
  return figure;
}

std::optional<Figure> distributionFigure(const Study& study, const Comparisons& comparisons) {
  const auto chosen = comparisonsOfKind(study, comparisons, false);
  if (chosen.empty()) {
    return std::nullopt;
  }
  bool isThinned = false;
  for (const MetricComparison* comparison : chosen) {
    for (const Estimate& estimate : comparison->estimates) {
      isThinned = isThinned || estimate.values.size() > kMostDots;
    }
  }
  Figure figure = panels("distributions", chosen.size(),
                         kTitle + 36.0 * static_cast<double>(study.options.size()) + kAxis,
                         columnsOfPanels(chosen.size(), namesWidth(study, PanelGrid().width)),
                         [&](Figure& to, std::size_t k, double left, double top, double width) {
                           distributionPanel(to, study, *chosen[k], left, top, width);
                         });
  figure.caption =
      "All runs: box plots with quartiles, median and whiskers up to 1.5 interquartile ranges; "
      "each dot is a run" +
      std::string(isThinned
                      ? " (at most " + std::to_string(kMostDots) + ", evenly selected by value)."
                      : ".");
  return figure;
}

namespace {

/// The values to draw as dots.
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

/// A deterministic jitter in [-0.5, 0.5] from the golden ratio.
double jitter(std::size_t k) {
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

Extent extentOf(const MetricComparison& comparison) {
  Extent extent;
  for (const Estimate& estimate : comparison.estimates) {
    extent.add(estimate.mean);
    extent.add(estimate.interval);
  }
  return extent;
}

Scale scaleOfValues(const Extent& values, double from, double to) {
  const bool areZeros = values.low == 0.0 && values.high == 0.0;
  return paddedScale(values.low, areZeros ? 1.0 : values.high, from, to);
}

std::vector<const MetricComparison*> comparisonsOfKind(const Study& study,
                                                       const Comparisons& comparisons, bool rates) {
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

void panelTitle(Figure& figure, const std::string& title, double left, double top) {
  constexpr std::size_t kTitleLength = 46;
  constexpr double kSize = 11.5;
  figure.text(left, top + 12.0, shortened(title, kTitleLength), "ink", Figure::Anchor::Start,
              kSize);
}

std::string levelText(double level) {
  return base::formatDouble(std::round(1e8 * level) / 1e6) + " %";
}

void stripPlot(Figure& figure, const Numbers& values, const Scale& scale, double y, double height,
               const std::string& role) {
  const Numbers dots = dotsOf(values);
  for (std::size_t k = 0; k < dots.size(); ++k) {
    figure.disc(scale.at(dots[k]), y + jitter(k) * height, 1.6, role, 0.45);
  }
}

namespace {

constexpr double kMark = 7.0;  // [px], half the size of a mark
constexpr double kAscent = 9.0, kDescent = 3.0;

bool overlap(const Box& a, const Box& b) {
  return a.low.x() < b.high.x() && b.low.x() < a.high.x() && a.low.y() < b.high.y() &&
         b.low.y() < a.high.y();
}

bool isWithin(const Box& a, const Box& bounds) {
  return a.low.x() >= bounds.low.x() && a.low.y() >= bounds.low.y() &&
         a.high.x() <= bounds.high.x() && a.high.y() <= bounds.high.y();
}

Box markOf(const base::Vec2& point) {
  const base::Vec2 half(kMark, kMark);
  return {point - half, point + half};
}

/// The length of a line inside a box [px] (Liang and Barsky 1984).
double lengthWithin(const Segment& line, const Box& box) {
  const base::Vec2 along = line.to - line.from;
  double begin = 0.0;
  double end = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = box.low[axis] - line.from[axis];
    const double high = box.high[axis] - line.from[axis];
    if (std::abs(along[axis]) < 1e-9) {
      end = low > 0.0 || high < 0.0 ? -1.0 : end;
      continue;
    }
    const double a = low / along[axis];
    const double b = high / along[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return std::max(0.0, end - begin) * along.norm();
}

base::Vec2 nearestIn(const Box& box, const base::Vec2& point) {
  return point.cwiseMax(box.low).cwiseMin(box.high);
}

PlacedLabel placedAt(const base::Vec2& point, const Box& box) {
  constexpr double kNear = 14.0;
  PlacedLabel place;
  place.box = box;
  const base::Vec2 end = nearestIn(box, point);
  const base::Vec2 along = end - point;
  place.hasLeader = along.norm() > kNear;
  if (place.hasLeader) {
    place.leader = {point + along * (kMark / along.norm()), end};
  }
  return place;
}

/// Candidate positions around a point, in order of preference: upper right, lower right, and so on,
/// then on rings with increasing distance.
std::vector<PlacedLabel> candidatesOf(const Label& label) {
  constexpr double kGap = 9.0;  // [px], distance to the centre of the mark
  constexpr int kDirections = 16;
  const double width = kLetter * static_cast<double>(characterCount(label.words));
  const base::Vec2 half(0.5 * width, 0.5 * (kAscent + kDescent));
  std::vector<PlacedLabel> found;
  found.reserve(9 + 6 * kDirections);
  const auto add = [&](double x, double y) {
    const base::Vec2 middle = label.point + base::Vec2(x, y);
    found.push_back(placedAt(label.point, {middle - half, middle + half}));
  };
  const double beside = kGap + half.x();
  const double across = kGap + half.y();
  const double corner = half.y() + 4.0;
  for (const base::Vec2& at :
       {base::Vec2(beside, -corner), base::Vec2(beside, corner), base::Vec2(-beside, -corner),
        base::Vec2(-beside, corner), base::Vec2(beside, 0.0), base::Vec2(-beside, 0.0),
        base::Vec2(0.0, -across), base::Vec2(0.0, across)}) {
    add(at.x(), at.y());
  }
  for (const double ring : {14.0, 24.0, 38.0, 56.0, 80.0, 110.0}) {
    for (int k = 0; k < kDirections; ++k) {
      const double angle = 2.0 * base::kPi * k / kDirections;
      add(std::cos(angle) * (ring + beside), std::sin(angle) * (ring + across));
    }
  }
  return found;
}

/// Assigns positions with a cost function, given the positions of the other labels.
class LabelPlacer {
 public:
  LabelPlacer(const std::vector<Label>& labels, const std::vector<Segment>& lines,
              const Box& bounds)
      : labels_(labels), lines_(lines), bounds_(bounds), places_(labels.size()) {}

  /// Moves a label to the position with the lowest cost.
  void place(std::size_t which) {
    const std::vector<PlacedLabel> all = candidatesOf(labels_[which]);
    std::vector<double> costs;
    costs.reserve(all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      costs.push_back(costOf(which, all[k]) +
                      0.1 * static_cast<double>(std::min<std::size_t>(k, 8)));
    }
    places_[which] =
        all[static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin())];
    placedCount_ = std::max(placedCount_, which + 1);
  }
  const std::vector<PlacedLabel>& places() const { return places_; }

 private:
  static constexpr double kForbidden = 1000.0;

  double costOf(std::size_t which, const PlacedLabel& place) const {
    double cost = isWithin(place.box, bounds_) ? 0.0 : 10.0 * kForbidden;
    const base::Vec2 away = nearestIn(place.box, labels_[which].point) - labels_[which].point;
    cost += 0.4 * away.norm() + (place.hasLeader ? 4.0 : 0.0);
    for (const Segment& line : lines_) {
      const double inside = lengthWithin(line, place.box);
      cost += inside > 0.0 ? 6.0 + 0.5 * inside : 0.0;
    }
    for (std::size_t other = 0; other < labels_.size(); ++other) {
      const Box mark = markOf(labels_[other].point);
      cost += overlap(place.box, mark) ? kForbidden : 0.0;
      cost +=
          other != which && place.hasLeader && lengthWithin(place.leader, mark) > 0.0 ? 30.0 : 0.0;
      cost += other != which && other < placedCount_ ? overlapCost(place, places_[other]) : 0.0;
    }
    return cost;
  }

  static double overlapCost(const PlacedLabel& place, const PlacedLabel& other) {
    double cost = overlap(place.box, other.box) ? kForbidden : 0.0;
    cost += place.hasLeader && lengthWithin(place.leader, other.box) > 0.0 ? 60.0 : 0.0;
    cost += other.hasLeader && lengthWithin(other.leader, place.box) > 0.0 ? 60.0 : 0.0;
    return cost;
  }

  const std::vector<Label>& labels_;
  const std::vector<Segment>& lines_;
  const Box& bounds_;
  std::vector<PlacedLabel> places_;
  std::size_t placedCount_ = 0;  // number of labels placed so far
};

}  // namespace

std::vector<PlacedLabel> placeLabels(const std::vector<Label>& labels,
                                     const std::vector<Segment>& lines, const Box& bounds) {
  constexpr int kRounds = 4;
  LabelPlacer crowd(labels, lines, bounds);
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t k = 0; k < labels.size(); ++k) {
      crowd.place(k);
    }
  }
  return crowd.places();
}

void drawLabels(Figure& figure, const std::vector<Label>& labels,
                const std::vector<PlacedLabel>& places) {
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const PlacedLabel& place = places[k];
    if (place.hasLeader) {
      figure.line(place.leader.from.x(), place.leader.from.y(), place.leader.to.x(),
                  place.leader.to.y(), "axis", 0.8);
    }
    const double base = place.box.high.y() - kDescent;
    const double middle = 0.5 * (place.box.low.x() + place.box.high.x());
    // Fonts are narrower than kLetter: the text is anchored on the side of its point.
    if (place.box.low.x() >= labels[k].point.x()) {
      figure.text(place.box.low.x(), base, labels[k].words);
    } else if (place.box.high.x() <= labels[k].point.x()) {
      figure.text(place.box.high.x(), base, labels[k].words, "ink", Figure::Anchor::End);
    } else {
      figure.text(middle, base, labels[k].words, "ink", Figure::Anchor::Middle);
    }
  }
}

}  // namespace report

#include "app/report/Labels.h"

#include <algorithm>
#include <cmath>

namespace report {

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

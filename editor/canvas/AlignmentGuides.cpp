#include "editor/canvas/AlignmentGuides.h"

#include <cmath>

namespace editor {

namespace {

constexpr double kEqual = 1e-6;  // Positions that differ less are equal [m].

/// The edges and the centre of a box along an axis.
std::vector<double> anchorsOf(const Extent& extent, int axis) {
  if (extent.high(axis) - extent.low(axis) < kEqual) {
    return {extent.low(axis)};
  }
  return {extent.low(axis), extent.centre()(axis), extent.high(axis)};
}

/// The smallest offered correction within reach.
struct Correction {
  double reach = 0.0;
  std::optional<double> best;

  void offer(double correction) {
    const double size = std::abs(correction);
    if (size <= reach && (!best || size < std::abs(*best) - kEqual)) {
      best = correction;
    }
  }
};

/// A position along an axis at which two distances between neighbours are equal.
struct EqualGaps {
  double low = 0.0;  // Position of the lower edge of the moving box.
  std::array<std::pair<double, double>, 2> gaps = {};  // From, to.
};

/// The row (axis 0) or column (axis 1) of boxes that contains `moving`.
class BoxRow {
 public:
  /// Neighbours may overlap `moving` by `overlap`, which the correction removes.
  BoxRow(const Extent& moving, const std::vector<Extent>& others, int axis, double overlap)
      : moving_(moving), axis_(axis), overlap_(overlap) {
    const int across = 1 - axis;
    for (const Extent& other : others) {
      if (other.low(across) <= moving.high(across) + kEqual &&
          other.high(across) >= moving.low(across) - kEqual) {
        members_.push_back(other);
      }
    }
  }

  std::vector<EqualGaps> positions() const {
    std::vector<EqualGaps> all;
    const double size = high(moving_) - low(moving_);
    const Extent* before = below(low(moving_) + std::min(overlap_, 0.5 * size) + kEqual);
    const Extent* after = above(high(moving_) - std::min(overlap_, 0.5 * size) - kEqual);
    if (before != nullptr && after != nullptr && low(*after) - high(*before) > size) {
      const double gap = 0.5 * (low(*after) - high(*before) - size);
      const double at = high(*before) + gap;
      all.push_back({at, {{{high(*before), at}, {at + size, low(*after)}}}});
    }
    const Extent* first = before == nullptr ? nullptr : below(low(*before));
    if (first != nullptr && low(*before) - high(*first) > kEqual) {
      const double at = high(*before) + low(*before) - high(*first);
      all.push_back({at, {{{high(*first), low(*before)}, {high(*before), at}}}});
    }
    const Extent* last = after == nullptr ? nullptr : above(high(*after));
    if (last != nullptr && low(*last) - high(*after) > kEqual) {
      const double end = low(*after) - (low(*last) - high(*after));
      all.push_back({end - size, {{{end, low(*after)}, {high(*after), low(*last)}}}});
    }
    return all;
  }

 private:
  double low(const Extent& extent) const { return extent.low(axis_); }
  double high(const Extent& extent) const { return extent.high(axis_); }
  /// The nearest member that ends before `position`.
  const Extent* below(double position) const {
    const Extent* nearest = nullptr;
    for (const Extent& member : members_) {
      if (high(member) <= position - kEqual &&
          (nearest == nullptr || high(member) > high(*nearest))) {
        nearest = &member;
      }
    }
    return nearest;
  }
  /// The nearest member that begins after `position`.
  const Extent* above(double position) const {
    const Extent* nearest = nullptr;
    for (const Extent& member : members_) {
      if (low(member) >= position + kEqual && (nearest == nullptr || low(member) < low(*nearest))) {
        nearest = &member;
      }
    }
    return nearest;
  }

  Extent moving_;
  int axis_;
  double overlap_;
  std::vector<Extent> members_;
};

Vec2 pointOn(int axis, double along, double across) {
  return axis == 0 ? Vec2(along, across) : Vec2(across, along);
}

std::optional<double> edgeCorrection(const Extent& moving, const std::vector<Extent>& others,
                                     int axis, double reach) {
  Correction correction{reach, {}};
  for (const Extent& other : others) {
    for (const double there : anchorsOf(other, axis)) {
      for (const double own : anchorsOf(moving, axis)) {
        correction.offer(there - own);
      }
    }
  }
  return correction.best;
}

/// Each distance is shown once.
void addGap(Alignment& result, const AlignmentGap& gap) {
  const auto isSame = [&gap](const AlignmentGap& each) {
    return (each.from - gap.from).norm() < kEqual && (each.to - gap.to).norm() < kEqual;
  };
  if (std::none_of(result.gaps.begin(), result.gaps.end(), isSame)) {
    result.gaps.push_back(gap);
  }
}

/// Adds a line through each edge or centre that `moving` shares with others, and the distance to
/// the nearest of them.
void addLines(Alignment& result, const Extent& moving, const std::vector<Extent>& others,
              int axis) {
  const int across = 1 - axis;
  const Extent* nearest = nullptr;
  double nearestGap = 0.0;
  for (const double own : anchorsOf(moving, axis)) {
    double from = moving.low(across);
    double to = moving.high(across);
    for (const Extent& other : others) {
      const std::vector<double> there = anchorsOf(other, axis);
      if (std::none_of(there.begin(), there.end(),
                       [own](double each) { return std::abs(each - own) < kEqual; })) {
        continue;
      }
      from = std::min(from, other.low(across));
      to = std::max(to, other.high(across));
      const double gap = std::max(other.low(across) - moving.high(across),
                                  moving.low(across) - other.high(across));
      if (gap > kEqual && (nearest == nullptr || gap < nearestGap)) {
        nearest = &other;
        nearestGap = gap;
      }
    }
    if (to - from > moving.high(across) - moving.low(across) + kEqual) {
      result.lines.emplace_back(pointOn(axis, own, from), pointOn(axis, own, to));
    }
  }
  if (nearest != nullptr) {
    const bool isAfter = nearest->low(across) >= moving.high(across);
    const double along = std::clamp(moving.centre()(axis), nearest->low(axis), nearest->high(axis));
    addGap(result, {pointOn(axis, along, isAfter ? moving.high(across) : nearest->high(across)),
                    pointOn(axis, along, isAfter ? nearest->low(across) : moving.low(across))});
  }
}

/// Adds the first pair of distances that are equal.
void addEqualGaps(Alignment& result, const Extent& moving, const std::vector<Extent>& others,
                  int axis) {
  for (const EqualGaps& each : BoxRow(moving, others, axis, 0.0).positions()) {
    if (std::abs(each.low - moving.low(axis)) < kEqual) {
      const double across = moving.centre()(1 - axis);
      for (const auto& [from, to] : each.gaps) {
        addGap(result, {pointOn(axis, from, across), pointOn(axis, to, across)});
      }
      return;
    }
  }
}

}  // namespace

Alignment alignmentOf(const Extent& moving, const std::vector<Extent>& others, double reach) {
  Vec2 edges = Vec2::Zero();
  std::array<std::optional<double>, 2> found;
  for (const int axis : {0, 1}) {
    found.at(static_cast<std::size_t>(axis)) = edgeCorrection(moving, others, axis, reach);
    edges(axis) = found.at(static_cast<std::size_t>(axis)).value_or(0.0);
  }
  Alignment result;
  for (const int axis : {0, 1}) {
    Vec2 aside = edges;
    aside(axis) = 0.0;  // Rows are those after the alignment across.
    const Extent shifted = movedBy(moving, aside);
    const std::optional<double>& edge = found.at(static_cast<std::size_t>(axis));
    Correction correction{edge ? std::abs(*edge) : reach, edge};
    for (const EqualGaps& each : BoxRow(shifted, others, axis, reach).positions()) {
      correction.offer(each.low - shifted.low(axis));
    }
    result.isAligned.at(static_cast<std::size_t>(axis)) = correction.best.has_value();
    result.offset(axis) = correction.best.value_or(0.0);
  }
  const Extent final = movedBy(moving, result.offset);
  for (const int axis : {0, 1}) {
    if (!result.isAligned.at(static_cast<std::size_t>(axis))) {
      continue;
    }
    addEqualGaps(result, final, others, axis);
    addLines(result, final, others, axis);
  }
  return result;
}

}  // namespace editor

#pragma once

#include <vector>

/// Which directions are hidden from an eye, as a union of intervals.
namespace sim2d {

/// Angles are about one eye, [rad]; an interval runs counter-clockwise from `from` over `width` in
/// [0, 2 pi], and may pass the seam. Exact up to rounding.
class AngularCover {
 public:
  void clear() { intervals_.clear(); }
  void add(double from, double width);
  /// How much of the interval is covered [rad].
  double covered(double from, double width) const;

 private:
  struct Interval {
    double low = 0.0, high = 0.0;  // in [-pi, pi]
  };
  void addPlain(double low, double high);
  double coveredPlain(double low, double high) const;

  std::vector<Interval> intervals_;  // ascending, apart from each other
};

}  // namespace sim2d

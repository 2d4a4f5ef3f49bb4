#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>

namespace metrics {

/// Jerk of a speed that is sampled, with a bandwidth that does not depend on the sampling: the
/// second derivative of the parabola that fits the speed, taken as linear between the samples, best
/// (least squares) within half a window to each side of a sample. Samples farther apart than that
/// limit the bandwidth themselves: there it is the second difference of the three speeds. Holds the
/// samples of one window. Source: the smoothing differentiator of Savitzky and Golay 1964 for
/// continuous signals.
class Jerk {
 public:
  /// `halfWindow` [s].
  explicit Jerk(double halfWindow) : half_(halfWindow) {}

  /// Takes the next speed [m/s] at a time [s] that is not before the one before. Calls
  /// `take(jerk)` [m/s³] for each sample that has its whole window by now, in order, from the
  /// second one on; NaN: no time passes beside it, or its window begins before the first sample.
  /// `between(jerk)` gets that of the middle between it and the one before, if there is one: what
  /// is largest depends less on where samples lie.
  void add(double time, double speed, const std::function<void(double)>& take,
           const std::function<void(double)>& between);

 private:
  struct Point {
    double time = 0.0, speed = 0.0;
  };
  bool isCoarse() const;  // around the next one to be told
  double secondDifference() const;
  double windowed(const Point& centre) const;
  double integral(const Point& from, const Point& to, const Point& centre) const;

  double half_;
  std::deque<Point> points_;     // of the window of the next one
  std::size_t next_ = 1;         // its place in points_
  std::optional<double> first_;  // time of the first sample [s]
};

}  // namespace metrics

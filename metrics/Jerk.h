#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>

namespace metrics {

/// Jerk of a sampled speed with a bandwidth that does not depend on the sampling: the second
/// derivative of the least-squares parabola of the speed, interpolated linearly between samples,
/// within half a window to each side of a sample. Samples farther apart than half a window limit
/// the bandwidth themselves; then the second difference of three speeds is used. Stores the samples
/// of one window. Source: the smoothing differentiator of Savitzky and Golay 1964 for continuous
/// signals.
class Jerk {
 public:
  /// `halfWindow` [s].
  explicit Jerk(double halfWindow) : half_(halfWindow) {}

  /// Adds the next speed [m/s] at a time [s] that is not earlier than the previous one. Calls
  /// `take(jerk)` [m/s³] for each sample whose window is complete, in order, from the second sample
  /// on; NaN: a neighbour has the same time, or the window starts before the first sample.
  /// `between(jerk)` receives the jerk at the midpoint between that sample and the previous one, if
  /// defined, so that the maximum depends less on the sampling times.
  void add(double time, double speed, const std::function<void(double)>& take,
           const std::function<void(double)>& between);

 private:
  struct Point {
    double time = 0.0, speed = 0.0;
  };
  bool isCoarse() const;  // around the next sample to be reported
  double secondDifference() const;
  double windowed(const Point& centre) const;
  double integral(const Point& from, const Point& to, const Point& centre) const;

  double half_;
  std::deque<Point> points_;     // samples of the next window
  std::size_t next_ = 1;         // index in points_
  std::optional<double> first_;  // time of the first sample [s]
};

}  // namespace metrics

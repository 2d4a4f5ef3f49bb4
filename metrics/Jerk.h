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

  /// Takes the next speed [m/s] at a time [s] that is not earlier than the previous one. Calls
  /// `take(jerk)` [m/s³] for each sample whose window is complete, in order, from the second sample
  /// on; NaN: a neighbour has the same time, or its window begins before the first sample.
  /// `between(jerk)` receives the jerk at the middle between it and the previous sample, if there
  /// is one: with it, the maximum depends less on the times of the samples.
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
  std::deque<Point> points_;     // of the window of the next one
  std::size_t next_ = 1;         // its place in points_
  std::optional<double> first_;  // time of the first sample [s]
};

}  // namespace metrics

#include "metrics/Jerk.h"

#include <algorithm>
#include <limits>

namespace metrics {

namespace {

constexpr double kSlack = 1e-9;  // [s]
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Integral from 0 of P(x / h), where P is the Legendre polynomial of degree two.
double ofParabola(double x, double h) {
  return 0.5 * (x * x * x / (h * h) - x);
}

/// The same for x P(x / h).
double ofSlope(double x, double h) {
  return 0.5 * (0.75 * x * x * x * x / (h * h) - 0.5 * x * x);
}

}  // namespace

bool Jerk::isCoarse() const {
  const double time = points_[next_].time;
  return time - points_[next_ - 1].time > half_ + kSlack ||
         points_[next_ + 1].time - time > half_ + kSlack;
}

double Jerk::secondDifference() const {
  const Point& before = points_[next_ - 1];
  const Point& at = points_[next_];
  const Point& after = points_[next_ + 1];
  if (!(at.time > before.time) || !(after.time > at.time)) {
    return kNone;
  }
  const double former = (at.speed - before.speed) / (at.time - before.time);
  const double latter = (after.speed - at.speed) / (after.time - at.time);
  return (latter - former) / ((after.time - before.time) / 2.0);
}

/// Integral of (speed - speed at the centre) P between two samples, within the window.
double Jerk::integral(const Point& from, const Point& to, const Point& centre) const {
  const double a = std::max(from.time - centre.time, -half_);
  const double b = std::min(to.time - centre.time, half_);
  if (!(b > a)) {
    return 0.0;
  }
  const double slope = (to.speed - from.speed) / (to.time - from.time);
  const double atCentre =
      from.speed - centre.speed - slope * (from.time - centre.time);  // of the line
  return atCentre * (ofParabola(b, half_) - ofParabola(a, half_)) +
         slope * (ofSlope(b, half_) - ofSlope(a, half_));
}

double Jerk::windowed(const Point& centre) const {
  if (centre.time - half_ < *first_ - kSlack) {
    return kNone;
  }
  double sum = 0.0;
  for (std::size_t k = 1; k < points_.size(); ++k) {
    sum += integral(points_[k - 1], points_[k], centre);
  }
  return 7.5 * sum / (half_ * half_ * half_);
}

void Jerk::add(double time, double speed, const std::function<void(double)>& take,
               const std::function<void(double)>& between) {
  first_ = first_.value_or(time);
  points_.push_back({time, speed});
  while (next_ + 1 < points_.size()) {
    const bool coarse = isCoarse();
    if (!coarse && time < points_[next_].time + half_ - kSlack) {
      return;
    }
    const Point& at = points_[next_];
    const Point& before = points_[next_ - 1];
    if (!coarse) {
      between(windowed({0.5 * (before.time + at.time), 0.5 * (before.speed + at.speed)}));
    }
    take(coarse ? secondDifference() : windowed(at));
    ++next_;
    while (next_ > 1 && points_[1].time <= points_[next_ - 1].time - half_) {
      points_.pop_front();
      --next_;
    }
  }
}

}  // namespace metrics

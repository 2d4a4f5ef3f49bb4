#pragma once

#include <deque>

#include "sim2d/nav/Body.h"

namespace sim2d::nav2 {

/// Mean of the velocities measured within a time (nav2_util::OdomSmoother).
class OdometrySmoother {
 public:
  explicit OdometrySmoother(double duration) : duration_(duration) {}

  void add(double time, const BodyTwist& twist) {  // [s], not before the last one
    constexpr double kRounding = 1e-9;             // [s]
    while (!history_.empty() && time - history_.front().time > duration_ + kRounding) {
      history_.pop_front();
    }
    history_.push_back({time, twist});
  }
  BodyTwist mean() const {  // zero before the first
    BodyTwist sum;
    for (const Entry& entry : history_) {
      sum.linear += entry.twist.linear / static_cast<double>(history_.size());
      sum.angular += entry.twist.angular / static_cast<double>(history_.size());
      sum.lateral += entry.twist.lateral / static_cast<double>(history_.size());
    }
    return sum;
  }

 private:
  struct Entry {
    double time = 0.0;  // [s]
    BodyTwist twist;
  };
  double duration_;  // [s]
  std::deque<Entry> history_;
};

}  // namespace sim2d::nav2

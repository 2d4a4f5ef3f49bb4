#include "sim2d/nav/MotionFilter.h"

namespace sim2d {

void MotionFilter::start(const Vec2& place) {
  position_ = place;
  velocity_ = Vec2::Zero();
  pp_ = placeVariance_;
  pv_ = 0.0;
  vv_ = 1.0;
}

void MotionFilter::predict(double duration) {
  const double t = duration;
  const double q = accelerationPower_;
  position_ += t * velocity_;
  pp_ += t * (2.0 * pv_ + t * vv_) + q * t * t * t / 3.0;
  pv_ += t * vv_ + q * t * t / 2.0;
  vv_ += q * t;
}

void MotionFilter::correct(const Vec2& place) {
  const double variance = pp_ + placeVariance_;  // S
  if (variance <= 0.0) {                         // seen twice at one time, without errors
    return;
  }
  const double forPosition = pp_ / variance;
  const double forVelocity = pv_ / variance;
  const Vec2 innovation = place - position_;
  position_ += forPosition * innovation;
  velocity_ += forVelocity * innovation;
  vv_ -= forVelocity * pv_;
  pv_ -= forPosition * pv_;
  pp_ -= forPosition * pp_;
}

}  // namespace sim2d

#pragma once

#include "sim2d/base/Types.h"

/// Velocities from places seen one after the other.
namespace sim2d {

using base::Vec2;

/// Kalman filter of a body of nearly constant velocity, by axis. State (p, v), measured z = p + w,
/// w ~ N(0, sigma_w²); the acceleration is white noise of the power q. From one time to another, T
/// on:
///   F = (1 T; 0 1),  Q = q (T³/3 T²/2; T²/2 T),  x' = F x,  P' = F P F^T + Q;
/// with a measurement:
///   S = P_pp + sigma_w²,  K = (P_pp, P_vp)^T / S,  x' = x + K (z - p),  P' = P - K (P_pp P_pv).
/// Both axes share P. Source: Bar-Shalom, Li & Kirubarajan 2001, Estimation with Applications to
/// Tracking and Navigation, ch. 5.2.3 and 6.2.2 (continuous white noise acceleration). With equal T
/// it settles to an alpha-beta filter.
class MotionFilter {
 public:
  /// sigma_w [m] >= 0, q [m²/s³] > 0: over a second the velocity changes by sqrt(q) on each axis.
  MotionFilter(double placeNoise, double accelerationPower)
      : placeVariance_(placeNoise * placeNoise), accelerationPower_(accelerationPower) {}

  /// Seen for the first time: its velocity is 0 ± 1 m/s on each axis.
  void start(const Vec2& place);
  void predict(double duration);  // T [s] >= 0
  void correct(const Vec2& place);

  const Vec2& position() const { return position_; }  // [m]
  const Vec2& velocity() const { return velocity_; }  // [m/s]

 private:
  double placeVariance_, accelerationPower_;
  Vec2 position_ = Vec2::Zero(), velocity_ = Vec2::Zero();
  double pp_ = 0.0, pv_ = 0.0, vv_ = 0.0;  // P [m²], [m²/s], [m²/s²]
};

}  // namespace sim2d

#pragma once

#include <array>
#include <cstddef>

#include "sim2d/world/SocialForce.h"

namespace sim2d {

/// Not less than the fastest of a crowd, and changed seldom: tables hang on it.
class SpeedBound {
 public:
  /// Before a step of so many people; true: `value` has changed. It becomes smaller once that is
  /// worth the time of new tables.
  bool update(double fastest, std::size_t people);
  double value() const { return value_; }  // [m/s]

 private:
  double value_ = -1.0;
  double largest_ = 0.0;    // of the fastest since the bound became too wide
  std::size_t wasted_ = 0;  // people since then, all steps together
};

/// Where those can be whom a walking person feels. Forces reach far towards people who come head
/// on and hardly back, so the place is a disc with its middle ahead of the person.
class CrowdReach {
 public:
  struct Disc {
    double ahead = 0.0;   // of its middle, along the velocity [m]
    double radius = 0.0;  // [m]
  };

  /// For forces above `share` = exp(-cutOff) of k_s, nobody faster than `fastest` [m/s], > 0.
  CrowdReach(const ForceParameters& parameters, double cutOff, double fastest);

  const ForceParameters& parameters() const { return parameters_; }
  /// Of a person with this speed, at most the fastest [m/s].
  const Disc& discOf(double speed) const;

 private:
  static constexpr std::size_t kDiscs = 16;  // by speed

  double boundOf(double along, double across) const;
  double farthestAt(double cosine, double sine, double speed) const;
  Disc discOver(double low, double high) const;

  ForceParameters parameters_;
  double cutOff_;
  double fastest_;  // [m/s], > 0
  std::array<Disc, kDiscs> discs_;
};

/// Equal in all that the reach and the form of the force depend on, but for the side preference.
bool haveOneShape(const ForceParameters& a, const ForceParameters& b);

}  // namespace sim2d

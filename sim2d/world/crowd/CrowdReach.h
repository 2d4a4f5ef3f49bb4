#pragma once

#include <array>
#include <cstddef>

#include "sim2d/world/SocialForce.h"

namespace sim2d {

/// Where those can be whom a walking person feels. Forces reach far towards people who come head
/// on and hardly back, so the place is a disc with its middle ahead of the person.
class CrowdReach {
 public:
  struct Disc {
    double ahead = 0.0;   // of its middle, along the velocity [m]
    double radius = 0.0;  // [m]
  };

  /// For forces above `share` = exp(-cutOff) of k_s, nobody faster than `fastest` [m/s].
  CrowdReach(const ForceParameters& parameters, double cutOff, double fastest);

  const ForceParameters& parameters() const { return parameters_; }
  /// Holds for a crowd whose fastest has this speed, and is not much too wide for it.
  bool isFor(double fastest) const;
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

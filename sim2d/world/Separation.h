#pragma once

#include <vector>

#include "sim2d/map/Obstacles.h"

namespace sim2d {

/// A disc on its way.
struct MovingDisc {
  Vec2 position = Vec2::Zero();  // [m]
  Vec2 velocity = Vec2::Zero();  // wanted; what is left of it afterwards [m/s]
  double radius = 0.35;          // [m]
  double mass = 80.0;            // [kg]
  const std::vector<Obstacles::Point>* walls = nullptr;  // boundary points near the disc
};
struct DiscPair {
  int first = 0, second = 0;
  double shift = 0.0;  // of the second along x, to where it acts [m]
};

/// Takes from the velocities what would press discs into each other or into walls before the step
/// ends: each pair that would, loses closing speed by a plastic impact shared by mass, in the order
/// given, repeated until nothing changes. Discs stop half a
/// millimetre before they meet.
void keepApart(std::vector<MovingDisc>& discs, const std::vector<DiscPair>& pairs, double dt);

}  // namespace sim2d

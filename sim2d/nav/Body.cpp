#include "sim2d/nav/Body.h"

#include <algorithm>

namespace sim2d {

const char* kinematicsName(Kinematics kinematics) {
  switch (kinematics) {
    case Kinematics::Omnidirectional:
      return "omnidirectional";
    case Kinematics::Ackermann:
      return "ackermann";
    default:
      return "differential";
  }
}

double circumscribedRadius(const Footprint& footprint) {
  double reach = footprint.isDisc() ? footprint.radius : 0.0;
  for (const Vec2& corner : footprint.corners) {
    reach = std::max(reach, corner.norm());
  }
  return reach;
}

}  // namespace sim2d

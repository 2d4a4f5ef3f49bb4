#include "sim2d/world/SpeedZones.h"

#include "sim2d/base/Math.h"
#include "sim2d/map/Outlines.h"

namespace sim2d {

double speedFactorAt(const WorldModel& model, const Vec2& position) {
  double factor = 1.0;
  for (const Area* zone : model.speedZones) {
    if (zone->factor && isInside(zone->points, position)) {
      factor *= *zone->factor;
    }
  }
  return factor;
}

Vec2 carryingVelocityAt(const WorldModel& model, const Vec2& position) {
  Vec2 velocity = Vec2::Zero();
  for (const Area* zone : model.speedZones) {
    if (zone->carrySpeed && isInside(zone->points, position)) {
      velocity +=
          *zone->carrySpeed * base::directionOf(base::wrapToPi(zone->carryHeading.value_or(0.0)));
    }
  }
  return velocity;
}

}  // namespace sim2d

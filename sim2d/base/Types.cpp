#include "sim2d/base/Types.h"

#include <array>
#include <cmath>

#include "sim2d/base/Math.h"

namespace base {

double wrapToPi(double angle) {
  if (angle > -kPi && angle <= kPi) {
    return angle;
  }
  const double wrapped = std::remainder(angle, 2.0 * kPi);  // exact; NaN for infinities
  return wrapped <= -kPi ? kPi : wrapped;
}

double angleDiff(double to, double from) {
  return wrapToPi(to - from);
}

Vec2 directionOf(double heading) {
  const SinCos direction = sinCos(heading);
  return {direction.cos, direction.sin};
}

double headingOf(const Vec2& direction) {
  return atan2(direction.y(), direction.x());
}

Vec2 Pose2::toWorld(const Vec2& pointInPose) const {
  const Vec2 d = direction();
  return position + Vec2(d.x() * pointInPose.x() - d.y() * pointInPose.y(),
                         d.y() * pointInPose.x() + d.x() * pointInPose.y());
}

Vec2 Pose2::toLocal(const Vec2& pointInWorld) const {
  const Vec2 d = direction();
  const Vec2 offset = pointInWorld - position;
  return {d.dot(offset), cross(d, offset)};
}

const char* nodeStatusName(NodeStatus status) {
  static constexpr std::array<const char*, 5> kNames = {"IDLE", "RUNNING", "SUCCESS", "FAILURE",
                                                        "SKIPPED"};
  return kNames.at(static_cast<std::size_t>(status));
}

}  // namespace base

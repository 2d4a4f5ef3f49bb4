#include "sim2d/nav/nav2/control/TrackingError.h"

#include <algorithm>
#include <limits>

#include "sim2d/base/Math.h"

namespace sim2d::nav2 {
namespace {

/// The nearest point of a segment as a fraction of its length.
double shareOf(const Vec2& from, const Vec2& along, const Vec2& place) {
  const double length = along.squaredNorm();
  return length > 0.0 ? std::clamp((place - from).dot(along) / length, 0.0, 1.0) : 0.0;
}

double lengthFrom(const Path& path, std::size_t segment, double share) {
  double length = 0.0;
  for (std::size_t i = segment; i + 1 < path.size(); ++i) {
    const double whole = (path[i + 1].position - path[i].position).norm();
    length += i == segment ? (1.0 - share) * whole : whole;
  }
  return length;
}

}  // namespace

TrackingFeedback trackingError(const Path& path, const Pose2& robot, std::size_t first,
                               double window) {
  TrackingFeedback feedback;
  if (path.empty()) {
    return feedback;
  }
  feedback.distanceToGoal = (path.back().position - robot.position).norm();
  feedback.positionError = (path.front().position - robot.position).norm();
  feedback.headingError = base::wrapToPi(path.front().heading - robot.heading);
  double nearest = std::numeric_limits<double>::infinity();
  double share = 0.0, way = 0.0;
  for (std::size_t i = first; i + 1 < path.size(); ++i) {
    const Vec2 from = path[i].position, along = path[i + 1].position - from;
    const double part = shareOf(from, along, robot.position);
    const Vec2 off = robot.position - (from + part * along);
    if (off.norm() < nearest) {
      nearest = off.norm();
      share = part;
      feedback.index = i;
      const double side = along.x() * off.y() - along.y() * off.x();
      feedback.positionError = side < 0.0 ? -nearest : nearest;
      const double heading =
          along.squaredNorm() > 0.0 ? base::atan2(along.y(), along.x()) : path[i].heading;
      feedback.headingError = base::wrapToPi(heading - robot.heading);
    }
    way += along.norm();
    if (window >= 0.0 && way > window) {
      break;
    }
  }
  feedback.remaining = lengthFrom(path, feedback.index, share);
  return feedback;
}

}  // namespace sim2d::nav2

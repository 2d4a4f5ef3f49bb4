#include "metrics/GaussianSpace.h"

#include <algorithm>
#include <cmath>

namespace metrics {

using base::Vec2;

GaussianSpace gaussianSpaceOf(double speed) {
  const double front = std::max(2.0 * speed, 0.5);
  return {front, front / 2.0, front * 2.0 / 3.0};
}

std::vector<Vec2> contourOf(const GaussianSpace& space, const base::Pose2& person, double level,
                            int corners) {
  const double reach = -2.0 * std::log(level);  // of a variance of 1 m², squared
  const double side = std::sqrt(space.side * reach);
  const Vec2 ahead = base::directionOf(person.heading);
  const Vec2 left(-ahead.y(), ahead.x());
  std::vector<Vec2> contour;
  contour.reserve(static_cast<std::size_t>(corners));
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * base::kPi * k / corners;
    const double along = std::cos(angle);
    const double half = std::sqrt((along > 0.0 ? space.ahead : space.behind) * reach);
    contour.push_back(person.position + half * along * ahead + side * std::sin(angle) * left);
  }
  return contour;
}

}  // namespace metrics

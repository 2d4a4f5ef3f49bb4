#include "metrics/Interaction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace metrics {

namespace {

constexpr double kSmall = 1e-9;       // [m] or [1]
constexpr double kSmallAngle = 1e-6;  // [rad] a smaller one is noise around 0
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Vec2 socialForce(const Body& source, const Body& target, double factor,
                 const MetricParameters& parameters) {
  const Vec2 between = source.position - target.position;
  const double separation = lengthOf(between);  // D
  const bool corrected = parameters.profile == Profile::Corrected;
  if (corrected && separation < kSmall) {
    return Vec2::Zero();
  }
  const Vec2 towards = between / separation;  // e
  const Vec2 interaction =
      parameters.socialLambda * (target.velocity - source.velocity) + towards;  // I
  const double length = lengthOf(interaction);                                  // L
  if (length < kSmall) {
    return corrected ? Vec2(0.0, 0.0) : Vec2(kNaN, kNaN);
  }
  const Vec2 direction = interaction / length;  // h
  double theta = base::wrapToPi(std::atan2(towards.y(), towards.x()) -
                                std::atan2(direction.y(), direction.x()));
  if (std::fabs(theta) < kSmallAngle) {
    theta = 0.0;
  }
  const double reach = parameters.socialGamma * length;  // B
  const double slowing = parameters.socialNPrime * reach * theta;
  const double turning = parameters.socialN * reach * theta;
  const double along = -std::exp(-separation / reach - slowing * slowing);
  const double sign = theta > 0.0 ? 1.0 : (theta < 0.0 ? -1.0 : 0.0);
  const double aside = -sign * std::exp(-separation / reach - turning * turning);
  return factor * (along * direction + aside * Vec2(-direction.y(), direction.x()));
}

Vec2 obstacleForce(const Body& body, const MetricParameters& parameters) {
  Vec2 sum = Vec2::Zero();
  for (const ObstaclePoint& point : body.obstacles) {
    const Vec2 away = body.position - point.position;
    const double length = lengthOf(away);
    if (length < kSmall) {
      continue;  // no direction
    }
    const double side = point.inside ? -1.0 : 1.0;
    const double strength = parameters.obstacleFactor *
                            std::exp(-(side * length - body.radius) / parameters.obstacleSigma);
    sum += side * strength / length * away;
  }
  if (!body.obstacles.empty()) {
    sum /= static_cast<double>(body.obstacles.size());
  }
  return sum;
}

std::optional<double> timeToCollision(const Body& robot, const Body& person) {
  const Vec2 centres = person.position - robot.position;  // C
  const Vec2 closing = robot.velocity - person.velocity;  // V
  const double radii = robot.radius + person.radius;      // R
  const double squared = centres.squaredNorm();           // d^2
  if (std::sqrt(squared) <= radii) {
    return 0.0;
  }
  const double along = centres.dot(closing);
  const double speed2 = closing.squaredNorm();
  const double discriminant = along * along - speed2 * (squared - radii * radii);
  if (along <= 0.0 || discriminant <= 0.0) {
    return std::nullopt;
  }
  return (along - std::sqrt(discriminant)) / speed2;
}

double fearCost(const Body& robot, const Body& person, const MetricParameters& parameters) {
  if (parameters.profile == Profile::Hunav2) {
    const Vec2 centres = person.position - robot.position;
    const Vec2 closing = robot.velocity - person.velocity;
    return centres.dot(closing) > 0.0 ? lengthOf(closing) / lengthOf(centres) : 0.0;
  }
  const std::optional<double> time = timeToCollision(robot, person);
  if (!time) {
    return 0.0;
  }
  return *time * parameters.fearCap <= 1.0 ? parameters.fearCap : 1.0 / *time;
}

double panicCost(const Body& robot, const Body& person, const MetricParameters& parameters) {
  const Vec2 centres = person.position - robot.position;
  const Vec2 closing = robot.velocity - person.velocity;
  const double radii = robot.radius + person.radius;
  const double along = centres.dot(closing);
  if (along <= 0.0) {
    return 0.0;
  }
  if (parameters.profile == Profile::Hunav2) {
    const double speed = lengthOf(closing);
    const double separation = lengthOf(centres);
    const double sine = std::fabs(base::cross(centres, closing)) / (separation * speed);
    const double miss = separation * sine;
    return miss > radii && sine > kSmallAngle ? speed / ((miss - radii) * sine) : 0.0;
  }
  // In this order of operations the last digits are those of the published reference values.
  const double speed2 = closing.squaredNorm();
  const double squared = centres.squaredNorm();
  const double aside = std::sqrt(std::max(speed2 * squared - along * along, 0.0));  // g
  const double margin = aside - std::sqrt(speed2) * radii;  // not above 0 on a collision course
  return margin > parameters.panicEpsilon ? std::sqrt(speed2 / squared) * aside / margin : 0.0;
}

double viewAngle(const Person& person, const Body& robot) {
  const Vec2 towards = robot.position - person.position;
  const double length = lengthOf(towards);
  if (length <= 0.0) {
    return 0.0;
  }
  const double along =
      towards.x() * std::cos(person.heading) + towards.y() * std::sin(person.heading);
  return std::acos(std::clamp(along / length, -1.0, 1.0));
}

namespace {

/// Calls `isFree(cell)` for the cells of a Bresenham line until one is not; both ends included.
template <class IsFree>
bool allOnLine(sim2d::Cell from, sim2d::Cell to, IsFree isFree) {
  constexpr int kLongest = 1000000;  // beyond any map
  const long long width = std::llabs(static_cast<long long>(to.column) - from.column);
  const long long height = std::llabs(static_cast<long long>(to.row) - from.row);
  if (width > kLongest || height > kLongest) {
    return false;
  }
  const int stepX = from.column < to.column ? 1 : -1;
  const int stepY = from.row < to.row ? 1 : -1;
  long long error = width - height;
  sim2d::Cell cell = from;
  while (isFree(cell)) {
    if (cell == to) {
      return true;
    }
    const long long twice = 2 * error;
    if (twice > -height) {
      error -= height;
      cell.column += stepX;
    }
    if (twice < width) {
      error += width;
      cell.row += stepY;
    }
  }
  return false;
}

/// Rounds towards zero as the original does.
sim2d::Cell truncatedCell(const sim2d::OccupancyGrid& map, const Vec2& point) {
  const Vec2 local = map.origin().toLocal(point) / map.resolution();
  constexpr double kLimit = 1e9;
  return {static_cast<int>(std::clamp(local.x(), -kLimit, kLimit)),
          static_cast<int>(std::clamp(local.y(), -kLimit, kLimit))};
}

Sight originalSight(const Person& person, const Body& robot, const sim2d::OccupancyGrid& map) {
  bool outside = false;
  const auto wrapped = [&outside](int index, int size) {  // a negative index counts from the end
    outside = outside || index >= size || index < -size;
    return index < 0 ? index + size : index;
  };
  const bool free = allOnLine(truncatedCell(map, person.position),
                              truncatedCell(map, robot.position), [&](sim2d::Cell cell) {
                                const sim2d::Cell place = {wrapped(cell.column, map.width()),
                                                           wrapped(cell.row, map.height())};
                                return !outside && !map.isWall(place) && !map.isUnknown(place);
                              });
  if (outside) {
    return Sight::OutsideMap;
  }
  return free ? Sight::Free : Sight::Blocked;
}

}  // namespace

Sight lineOfSight(const Person& person, const Body& robot, const sim2d::OccupancyGrid& map,
                  Profile profile) {
  if (profile == Profile::Hunav2) {
    return originalSight(person, robot, map);
  }
  if (person.screened) {
    return Sight::Blocked;
  }
  if (map.isEmpty()) {
    return Sight::Free;
  }
  const bool free =
      allOnLine(map.worldToCell(person.position), map.worldToCell(robot.position),
                [&](sim2d::Cell cell) { return !map.isWall(cell) && !map.isUnknown(cell); });
  return free ? Sight::Free : Sight::Blocked;
}

}  // namespace metrics

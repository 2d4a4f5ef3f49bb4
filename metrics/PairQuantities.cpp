// Quantities of the robot and each person: forces, collision courses, sight.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "metrics/Samples.h"

namespace metrics {

namespace {

constexpr double kSmall = 1e-9;       // [m] or [1]
constexpr double kSmallAngle = 1e-6;  // [rad] smaller angles are noise around 0
constexpr int kHighestFree = 50;      // maximum cell value of free space

/// Common part of the forces of a pair on each other; reversed() changes the signs.
struct SocialInteraction {
  double separation = 0.0;        // D
  double length = 0.0;            // L
  Vec2 towards = Vec2::Zero();    // e
  Vec2 direction = Vec2::Zero();  // h
  bool isZero = false;            // no force
  bool isUndefined = false;

  SocialInteraction(const Body& source, const Body& target, const MetricParameters& parameters) {
    const Vec2 between = source.position - target.position;
    separation = lengthOf(between);
    const bool corrected = parameters.profile == Profile::Corrected;
    isZero = corrected && separation < kSmall;
    towards = between / separation;
    const Vec2 interaction =
        parameters.socialLambda * (target.velocity - source.velocity) + towards;  // I
    length = lengthOf(interaction);
    isZero = isZero || (corrected && length < kSmall);
    isUndefined = !isZero && length < kSmall;
    direction = interaction / length;
  }
  /// As seen by the source. Avoids -0, which would turn an angle of pi into -pi.
  SocialInteraction reversed() const {
    SocialInteraction other = *this;
    other.towards = Vec2::Zero() - towards;
    other.direction = Vec2::Zero() - direction;
    return other;
  }
};

/// Moussaid 2009 with the constants of lightsfm, multiplied by `factor`. Equal positions or a
/// vanishing interaction: zero in the corrected profile, NaN in hunav2.
Vec2 socialForceOf(const SocialInteraction& pair, double factor,
                   const MetricParameters& parameters) {
  if (pair.isZero) {
    return Vec2::Zero();
  }
  if (pair.isUndefined) {
    return {kNaN, kNaN};
  }
  double theta = base::wrapToPi(std::atan2(pair.towards.y(), pair.towards.x()) -
                                std::atan2(pair.direction.y(), pair.direction.x()));
  if (std::fabs(theta) < kSmallAngle) {
    theta = 0.0;
  }
  const double reach = parameters.socialGamma * pair.length;  // B
  const double slowing = parameters.socialNPrime * reach * theta;
  const double turning = parameters.socialN * reach * theta;
  const double along = -std::exp(-pair.separation / reach - slowing * slowing);
  const double sign = theta > 0.0 ? 1.0 : (theta < 0.0 ? -1.0 : 0.0);
  const double aside =
      theta != 0.0 ? -sign * std::exp(-pair.separation / reach - turning * turning) : 0.0;
  return factor * (along * pair.direction + aside * Vec2(-pair.direction.y(), pair.direction.x()));
}

/// Time until the discs touch at constant velocities, 0 if they do; infinite if never (Singamaneni
/// et al. 2023).
double timeToCollision(const Body& robot, const Body& person) {
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
    return HUGE_VAL;
  }
  return (along - std::sqrt(discriminant)) / speed2;
}

/// Calls `isFree(cell)` for the cells of a Bresenham line, both ends included, until one returns
/// false.
template <class IsFree>
bool allOnLine(sim2d::Cell from, sim2d::Cell to, IsFree isFree) {
  constexpr int kMaxCells = 1000000;  // larger than any map
  const long long width = std::llabs(static_cast<long long>(to.column) - from.column);
  const long long height = std::llabs(static_cast<long long>(to.row) - from.row);
  if (width > kMaxCells || height > kMaxCells) {
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

/// Rounds towards zero like HuNavSim's evaluator.
sim2d::Cell truncatedCell(const sim2d::OccupancyGrid& map, const Vec2& point) {
  const Vec2 local = map.origin().toLocal(point) / map.resolution();
  constexpr double kLimit = 1e9;
  return {static_cast<int>(std::clamp(local.x(), -kLimit, kLimit)),
          static_cast<int>(std::clamp(local.y(), -kLimit, kLimit))};
}

Sight originalSight(const Pedestrian& person, const Body& robot, const sim2d::OccupancyGrid& map) {
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

/// Tests the cells between person and robot; in the corrected profile also obstacles and doors.
Sight lineOfSight(const Pedestrian& person, const Body& robot, const sim2d::OccupancyGrid& map,
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
  const bool free = allOnLine(map.worldToCell(person.position), map.worldToCell(robot.position),
                              [&map](sim2d::Cell cell) {
                                const std::int8_t value = map.valueAt(cell);
                                return value >= 0 && value <= kHighestFree;
                              });
  return free ? Sight::Free : Sight::Blocked;
}

/// The person's own force factor, where it applies.
double factorOf(const Pedestrian& person, const MetricParameters& parameters) {
  const bool own = parameters.profile == Profile::Corrected && parameters.personForceParameters > 0;
  return own ? person.socialFactor.value_or(parameters.socialFactor) : parameters.socialFactor;
}

void computePair(Pedestrian& person, const Robot& robot, const MetricParameters& parameters) {
  RobotPersonPair& pair = person.pair;
  const Vec2 towards = robot.position - person.position;
  pair.isKnown = true;
  pair.distance = lengthOf(towards);
  pair.bearing = std::atan2(-towards.y(), -towards.x());
  pair.ahead = Vec2(std::cos(person.heading), std::sin(person.heading));
  pair.viewAngle = pair.distance > 0.0
                       ? std::acos(std::clamp(pair.ahead.dot(towards) / pair.distance, -1.0, 1.0))
                       : 0.0;
  pair.timeToCollision = timeToCollision(robot, person);
  const SocialInteraction meeting(person, robot, parameters);
  pair.forceOnRobot = socialForceOf(meeting, parameters.socialFactor, parameters);
  pair.forceOnPerson =
      lengthOf(socialForceOf(meeting.reversed(), factorOf(person, parameters), parameters));
}

}  // namespace

void computePairs(Sample& sample, const sim2d::OccupancyGrid* map,
                  const MetricParameters& parameters) {
  for (Pedestrian& person : sample.people) {
    if (person.pair.isKnown) {
      continue;
    }
    computePair(person, sample.robot, parameters);
    if (map != nullptr && person.pair.viewAngle <= parameters.fieldOfView / 2.0) {
      person.pair.sight = lineOfSight(person, sample.robot, *map, parameters.profile);
    }
  }
}

}  // namespace metrics

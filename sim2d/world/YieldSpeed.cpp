#include <algorithm>
#include <cmath>

#include "sim2d/map/Outlines.h"
#include "sim2d/world/YieldModel.h"

/// Visibility of robots for people, and speed limits near robots.
namespace sim2d {
namespace {

constexpr double kHalfView = 100.0 / 180.0 * base::kPi;  // [rad] to each side of the heading
constexpr double kMinClearance = 0.08;                   // [m]; clearance that is always kept
constexpr double kBraking = 1.5;                         // [m/s²]
constexpr double kEmergencyDeceleration = 5.0;           // [m/s²], in an emergency
constexpr double kReaction = 0.3;                        // [s]
constexpr double kRetreatTime = 0.5;                     // [s]
constexpr double kMaxRetreatSpeed = 0.3;                 // [m/s], maximum
constexpr double kNearby = 5.0;                          // [m]; robots farther away need no braking
constexpr double kStepAsideSpeed = 0.8;   // [m/s]; allowed even if the desired speed is lower
constexpr double kWallTime = 0.2;         // [s]; horizon of walls while giving way
constexpr double kBoundTolerance = 1e-6;  // [m/s]
constexpr int kBoundRounds = 4;

Vec2 outwardsOf(const std::vector<Vec2>& polygon, std::size_t edge) {
  const Vec2 along = polygon[edge + 1 < polygon.size() ? edge + 1 : 0] - polygon[edge];
  return Vec2(along.y(), -along.x()) / along.norm();
}

}  // namespace

double maxClosingSpeed(double room) {
  if (room <= 0.0) {
    return std::max(room / kRetreatTime, -kMaxRetreatSpeed);
  }
  return kBraking * (std::sqrt(kReaction * kReaction + 2.0 * room / kBraking) - kReaction);
}

bool YieldModel::isSeen(const FrozenWorld& world, const Vec2& eye, const Vec2& point) {
  return world.navigation.isOpenBetween(eye, point) || world.obstacles.isVisible(eye, point);
}

bool YieldModel::isInFront(const FrozenWorld& world, std::size_t human, const Vec2& point) {
  const double bearing =
      base::headingOf(point - world.state.position(human)) - world.state.heading[human];
  return std::fabs(base::wrapToPi(bearing)) <= kHalfView;
}

/// Bound on the speed towards the edge of the robot's outline that the person would walk into;
/// none: already satisfied.
std::optional<HalfPlane> YieldModel::speedBound(const FrozenWorld& world, std::size_t human,
                                                std::size_t robot, const Vec2& velocity) const {
  const RobotState& now = world.state.robots[robot];
  const Vec2 place = world.state.position(human);
  const double radius = world.model.people[human].constants.radius;
  const Vec2 apart = now.pose.position - place;
  if (apart.norm() > kNearby + circumscribedRadius(footprints_[robot])) {
    return std::nullopt;
  }
  const Obstacles::Point nearest = nearestPointOf(world.model.robots[robot], now.pose, place);
  const Vec2 arm = nearest.position - now.pose.position;
  Vec2 drives = now.velocity + now.omega * Vec2(-arm.y(), arm.x());
  if (drives.dot(apart) < 0.0 && !isInFront(world, human, nearest.position)) {
    drives = Vec2::Zero();  // robots behind are not seen
  }
  const Segment ahead{place, place + kForesight * (velocity - drives)};
  const double reach =
      kOutlineInflation * (circumscribedRadius(footprints_[robot]) + radius + kMinClearance);
  if (distanceToSegment(ahead, now.pose.position) > reach) {
    return std::nullopt;  // early exit, since computing the outline is expensive
  }
  const std::vector<Vec2> outline =
      inflatedOutline(footprints_[robot], now.pose, radius + kMinClearance, directions_[robot]);
  const std::optional<PolygonEntry> entry = entryPoint(outline, ahead.a, ahead.b);
  if (!entry) {
    return std::nullopt;
  }
  const Vec2 inwards = -outwardsOf(outline, entry->edge);
  const double room = (outline[entry->edge] - place).dot(inwards);
  const double most = maxClosingSpeed(room) + drives.dot(inwards);
  if (velocity.dot(inwards) <= most + kBoundTolerance ||
      !(isSeen(world, place, nearest.position) || isSeen(world, place, now.pose.position))) {
    return std::nullopt;
  }
  return HalfPlane{most * inwards, Vec2(-inwards.y(), inwards.x())};
}

Vec2 YieldModel::limited(const FrozenWorld& world, std::size_t human, const Vec2& wanted,
                         const std::vector<Obstacles::Point>* walls) const {
  std::vector<HalfPlane> planes;
  std::size_t fixed = 0;
  Vec2 velocity = wanted;
  const auto [first, last] = nearRange(human);
  for (int round = 0; round < kBoundRounds; ++round) {
    const std::size_t before = planes.size();
    for (std::size_t i = first; i < last; ++i) {
      const std::optional<HalfPlane> plane = speedBound(world, human, near_[i].second, velocity);
      if (!plane) {
        continue;
      }
      if (planes.empty() && walls != nullptr) {
        const Walker self{0, world.state.position(human), velocity,
                          world.model.people[human].constants.radius};
        for (const Obstacles::Point& point : *walls) {
          planes.push_back(pointHalfPlane(self, point, kWallTime, world.model.dt));
        }
        fixed = planes.size();
      }
      planes.push_back(*plane);
    }
    if (planes.size() == before) {
      break;
    }
    velocity =
        nearestFeasibleVelocity(planes, fixed, wanted, std::max(wanted.norm(), kStepAsideSpeed));
  }
  if (planes.empty()) {
    return wanted;
  }
  const Vec2 now = world.state.velocity(human);
  const double most = std::max(kEmergencyDeceleration * world.model.dt, (wanted - now).norm());
  const Vec2 change = velocity - now;
  return now + std::min(1.0, most / std::max(change.norm(), kBoundTolerance)) * change;
}

}  // namespace sim2d

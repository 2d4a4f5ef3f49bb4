#include "sim2d/world/YieldModel.h"

#include <algorithm>
#include <cmath>

#include "sim2d/map/Outlines.h"
#include "sim2d/map/PathPlanner.h"

namespace sim2d {
namespace {

constexpr double kSightRange = 6.0;   // [m]
constexpr double kRobotStands = 0.1;  // [m/s]; slower robots count as standing
constexpr double kLookAhead = 6.0;    // [m] along the path

// Clearances between the bodies [m]:
constexpr double kPreferredGap = 0.3;     // preferred
constexpr double kMinGap = 0.15;          // minimum for passing
constexpr double kWaitingGap = 1.2;       // to a robot that stands in the way
constexpr double kMakeRoomGap = 0.8;      // to a robot that may want to move to the person's place
constexpr double kApproachGap = 2.5;      // to an approaching robot, below which people step aside
constexpr double kStripClearance = 0.25;  // beside the strip that an approaching robot drives along

constexpr double kGoalMissRatio = 0.8;  // fraction of the goal radius by which a goal may be missed
constexpr double kFrontCosine = 0.3;    // cosine of the half angle of a robot's front
constexpr double kDetourTolerance = 0.01;    // [m]; accepted loss of wall clearance on a detour
constexpr double kOutlineTolerance = 0.001;  // [m]
constexpr double kShortestLeg = 0.02;        // [m]; shorter ones have no direction
constexpr double kRecentStopTime = 5.0;      // [s]; a robot that stopped more recently may continue
constexpr double kSideMemoryTime = 2.0;      // [s]; memory of the passing side
constexpr double kSideHysteresis = 1.5;      // [m]; the other side must be shorter by this length
constexpr double kMovingSideHysteresis = 0.5;
constexpr double kRightPreference = 0.1;  // [m]; initial preference for the right

/// The position and the path points up to kLookAhead.
std::vector<Vec2> pathLine(const YieldModel::Walking& who) {
  std::vector<Vec2> line = {who.position};
  double left = kLookAhead;
  for (const Vec2& point : who.way) {
    const Vec2 leg = point - line.back();
    const double length = leg.norm();
    if (length < kOutlineTolerance) {
      continue;
    }
    line.emplace_back(line.back() + std::min(1.0, left / length) * leg);
    left -= length;
    if (left <= 0.0) {
      break;
    }
  }
  return line;
}

/// Time until the distance to the robot is minimal, at constant velocities [s].
std::optional<double> meetingTime(const Vec2& apart, const Vec2& relative) {
  constexpr double kSameSpeed = 0.2;  // [m/s]
  const double closing = apart.dot(relative);
  if (closing <= 0.0 || relative.norm() < kSameSpeed) {
    return std::nullopt;
  }
  const double time = closing / relative.squaredNorm();
  return time <= YieldModel::kForesight ? std::optional(time) : std::nullopt;
}

/// True if no outline at this distance or nearer intersects the line.
bool isClearOfLine(const Footprint& footprint, const Vec2& place, double distance,
                   const std::vector<Vec2>& line) {
  const double reach =
      (circumscribedRadius(footprint) + distance) * kOutlineInflation + kOutlineTolerance;
  for (std::size_t leg = 0; leg + 1 < line.size(); ++leg) {
    if (distanceToSegment({line[leg], line[leg + 1]}, place) < reach) {
      return false;
    }
  }
  return true;
}

double lengthOrInfinity(const std::vector<Vec2>* way) {
  return way != nullptr ? polylineLength(*way) : 1e300;
}

}  // namespace

void YieldModel::update(const FrozenWorld& world) {
  near_.clear();
  people_.clear();
  const WorldState& state = world.state;
  if (state.robots.empty() || world.model.compatibility.hunav2()) {
    return;
  }
  memory_.resize(state.present.size());
  movedAt_.resize(state.robots.size(), state.time);
  directions_.resize(state.robots.size());
  for (std::size_t robot = 0; robot < state.robots.size(); ++robot) {
    const ResolvedRobot& constants = world.model.robots[robot];
    if (footprints_.size() == robot) {
      footprints_.push_back({constants.radius, constants.footprint});
    }
    const RobotState& now = state.robots[robot];
    directions_[robot] = outlineDirections(now.pose.heading);
    movedAt_[robot] = now.velocity.norm() < kRobotStands ? movedAt_[robot] : state.time;
    world.grid.forEachNear(now.pose.position, kSightRange + circumscribedRadius(constants),
                           [&](int human) {
                             const auto at = static_cast<std::size_t>(human);
                             if (world.model.people[at].model->yieldsToRobots()) {
                               near_.emplace_back(at, robot);
                             }
                           });
  }
  std::sort(near_.begin(), near_.end());
  for (const auto& [human, robot] : near_) {
    if (people_.empty() || people_.back() != human) {
      people_.push_back(human);
    }
  }
}

bool YieldModel::isNearRobot(std::size_t human) const {
  return !people_.empty() && std::binary_search(people_.begin(), people_.end(), human);
}

std::pair<std::size_t, std::size_t> YieldModel::nearRange(std::size_t human) const {
  const auto first = std::lower_bound(near_.begin(), near_.end(), std::make_pair(human, 0UL));
  const auto last = std::lower_bound(first, near_.end(), std::make_pair(human + 1, 0UL));
  return {static_cast<std::size_t>(first - near_.begin()),
          static_cast<std::size_t>(last - near_.begin())};
}

/// Standing robots at their current pose; of the others those in view that come near, at the
/// predicted pose.
std::vector<YieldModel::MetRobot> YieldModel::metRobots(const FrozenWorld& world,
                                                        const Walking& who) const {
  std::vector<MetRobot> met;
  const auto [first, last] = nearRange(who.human);
  for (std::size_t i = first; i < last; ++i) {
    const std::size_t robot = near_[i].second;
    const RobotState& now = world.state.robots[robot];
    const Vec2& place = now.pose.position;
    MetRobot item{robot, now.pose, now.velocity.norm() < kRobotStands, {}};
    if (!item.stands) {
      const std::optional<double> time =
          meetingTime(place - who.position, who.speed * who.direction - now.velocity);
      if (!time || !isInFront(world, who.human, place)) {
        continue;
      }
      item.pose.position += *time * now.velocity;
    }
    if (isSeen(world, who.position, place)) {
      met.push_back(std::move(item));
    }
  }
  return met;
}

/// Computes outlines at a distance that leaves the person outside.
void YieldModel::computeOutlines(std::vector<MetRobot>& met, const Walking& who,
                                 double room) const {
  for (MetRobot& item : met) {
    const Footprint& footprint = footprints_[item.robot];
    const double own = footprint.isDisc() ? footprint.radius : 0.0;
    const double apart = gapToDisc(footprint, item.pose, who.position, 0.0) + own;
    const double most = apart / kOutlineInflation - own - kOutlineTolerance;
    const double wide = std::min(who.radius + room, most);
    item.outline = wide > 0.0 ? inflatedOutline(footprint, item.pose, wide, directions_[item.robot])
                              : std::vector<Vec2>();
    if (!item.outline.empty() && isInside(item.outline, who.position)) {
      item.outline.clear();  // at a concave corner
    }
  }
}

/// First intersection on the first leg that intersects an outline.
std::optional<YieldModel::Conflict> YieldModel::firstConflict(const std::vector<MetRobot>& met,
                                                              const std::vector<Vec2>& line) {
  std::optional<Conflict> first;
  for (std::size_t leg = 0; leg + 1 < line.size() && !first; ++leg) {
    for (std::size_t i = 0; i < met.size(); ++i) {
      const std::optional<PolygonEntry> entry =
          entryPoint(met[i].outline, line[leg], line[leg + 1]);
      if (entry && (!first || entry->share < first->share)) {
        first = Conflict{i, leg, entry->share};
      }
    }
  }
  return first;
}

YieldModel::Guidance YieldModel::lead(const FrozenWorld& world, const Walking& who) {
  Guidance lead;
  lead.direction = who.direction;
  std::vector<MetRobot> met = metRobots(world, who);
  if (met.empty()) {
    return lead;
  }
  const std::vector<Vec2> line = pathLine(who);
  if (std::all_of(met.begin(), met.end(), [&](const MetRobot& item) {
        return isClearOfLine(footprints_[item.robot], item.pose.position,
                             who.radius + kPreferredGap, line);
      })) {
    return lead;
  }
  std::optional<Conflict> conflict;
  for (const double room : {kPreferredGap, kMinGap}) {
    computeOutlines(met, who, room);
    conflict = firstConflict(met, line);
    if (!conflict) {
      return lead;
    }
    if (const std::optional<Vec2> direction = directionPast(world, who, met, line, *conflict)) {
      lead.direction = *direction;
      return lead;
    }
  }
  return waiting(world, who, met, conflict->met);
}

/// A point beside the robot, as near to `place` as its outline allows.
Vec2 YieldModel::pointBeside(const FrozenWorld& world, const MetRobot& met, const Vec2& place,
                             double radius) const {
  const Footprint& footprint = footprints_[met.robot];
  const Obstacles::Point foot = nearestPointOf(world.model.robots[met.robot], met.pose, place);
  Vec2 outwards = foot.inside ? Vec2(foot.position - place) : Vec2(place - foot.position);
  const double length = outwards.norm();
  outwards =
      length > kOutlineTolerance ? Vec2(outwards / length) : base::directionOf(met.pose.heading);
  const double own = footprint.isDisc() ? footprint.radius : 0.0;
  const double distance = (radius + kMinGap + own) * kOutlineInflation - own + kOutlineTolerance;
  return foot.position + distance * outwards;
}

/// Whether the path is free of walls, with the person's current clearance, and of the other robots.
bool YieldModel::isPathFree(const FrozenWorld& world, const Walking& who,
                            const std::vector<MetRobot>& met, std::size_t around,
                            const std::vector<Vec2>& way) {
  const double clear =
      std::min(who.radius, world.obstacles.clearance(who.position, who.radius)) - kDetourTolerance;
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (!isSegmentFree(way[i - 1], way[i], world.obstacles, clear)) {
      return false;
    }
    for (std::size_t other = 0; other < met.size(); ++other) {
      if (other != around && entryPoint(met[other].outline, way[i - 1], way[i])) {
        return false;
      }
    }
  }
  return true;
}

/// Walking direction around the robot on the better side; none: no space on either side.
std::optional<Vec2> YieldModel::directionPast(const FrozenWorld& world, const Walking& who,
                                              const std::vector<MetRobot>& met,
                                              const std::vector<Vec2>& line,
                                              const Conflict& conflict) {
  const MetRobot& around = met[conflict.met];
  const auto isWithin = [&](const Vec2& place) { return isInside(around.outline, place); };
  std::size_t begin = conflict.leg;
  while (begin > 0 && isWithin(line[begin])) {
    --begin;
  }
  std::size_t end = conflict.leg + 1;
  while (end + 1 < line.size() && isWithin(line[end])) {
    ++end;
  }
  const bool isTaken = isWithin(line[end]);
  const Vec2 aim = isTaken ? pointBeside(world, around, line[end], who.radius) : line[end];
  const bool isTarget = (line[end] - who.way.back()).norm() < kOutlineTolerance;
  if (isTaken && isTarget && (aim - line[end]).norm() > kGoalMissRatio * who.goalRadius) {
    return std::nullopt;  // the goal cannot be reached while the robot stands there
  }
  PathsAround ways = pathsAround(around.outline, line[begin], aim);
  if (ways.left.empty()) {
    ways.left = ways.right = {line[begin], aim};
  }
  const auto ifFree = [&](const std::vector<Vec2>& way) {
    return isPathFree(world, who, met, conflict.met, way) ? &way : nullptr;
  };
  const std::vector<Vec2>* const way =
      choosePath(ifFree(ways.left), ifFree(ways.right), who.human, around, world.state.time);
  if (way == nullptr || begin > 0) {
    return way == nullptr ? std::nullopt : std::optional(who.direction);
  }
  for (std::size_t i = 1; i < way->size(); ++i) {
    const Vec2 leg = (*way)[i] - who.position;
    if (leg.norm() > kShortestLeg) {
      return Vec2(leg.normalized());
    }
  }
  return who.direction;
}

/// Keeps the side chosen before unless it is much longer, to avoid oscillation.
const std::vector<Vec2>* YieldModel::choosePath(const std::vector<Vec2>* left,
                                                const std::vector<Vec2>* right, std::size_t human,
                                                const MetRobot& met, double time) {
  if (left == nullptr && right == nullptr) {
    return nullptr;
  }
  Memory& memory = memory_[human];
  double advantage = kRightPreference;  // in favour of the right side
  if (memory.robot == met.robot && time - memory.at <= kSideMemoryTime) {
    const double loyalty = met.stands ? kSideHysteresis : kMovingSideHysteresis;
    advantage = memory.isLeft ? -loyalty : loyalty;
  }
  memory = {met.robot, lengthOrInfinity(left) < lengthOrInfinity(right) - advantage, time};
  return memory.isLeft ? left : right;
}

/// Waits at a distance; steps out of the strip of an approaching robot.
YieldModel::Guidance YieldModel::waiting(const FrozenWorld& world, const Walking& who,
                                         const std::vector<MetRobot>& met,
                                         std::size_t blocking) const {
  const std::size_t robot = met[blocking].robot;
  const RobotState& now = world.state.robots[robot];
  Guidance lead;
  lead.waits = true;
  lead.direction = who.direction;
  lead.stoodFor = world.state.time - movedAt_[robot];
  for (const MetRobot& item : met) {
    if (met[blocking].stands && item.stands && !item.outline.empty()) {
      lead.closed.push_back(item.outline);
    }
  }
  const double gap = gapToDisc(footprints_[robot], now.pose, who.position, who.radius);
  const Vec2 drives =
      now.velocity.norm() < kRobotStands ? now.pose.direction() : Vec2(now.velocity.normalized());
  const Vec2 apart = who.position - now.pose.position;
  const double left = base::cross(drives, apart);
  const double missing =
      circumscribedRadius(footprints_[robot]) + who.radius + kStripClearance - std::fabs(left);
  const bool isBefore = apart.dot(drives) > kFrontCosine * apart.norm();
  const bool comes = lead.stoodFor <= kRecentStopTime && gap < kApproachGap;
  if (gap < kWaitingGap || (isBefore && comes)) {
    lead.direction = Vec2::Zero();
  }
  if (!isBefore || !((comes && missing > 0.0) || gap < kMakeRoomGap)) {
    return lead;
  }
  const Vec2 aside = (left >= 0.0 ? 1.0 : -1.0) * Vec2(-drives.y(), drives.x());
  for (const Vec2& away : {aside, Vec2(apart.normalized()), Vec2(-aside)}) {
    const Vec2 to = who.position + std::max(missing, kMakeRoomGap - gap) * away;
    if (isSegmentFree(who.position, to, world.obstacles, who.radius)) {
      lead.direction = away;
      break;
    }
  }
  return lead;
}

/// Visibility of robots for people, and speed limits near robots.
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

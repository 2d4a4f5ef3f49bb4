#include "sim2d/world/GivingWay.h"

#include <algorithm>
#include <cmath>

#include "sim2d/map/ConvexPolygon.h"
#include "sim2d/map/PathPlanner.h"
#include "sim2d/map/TautWay.h"

namespace sim2d {
namespace {

constexpr double kSight = 6.0;        // [m]
constexpr double kRobotStands = 0.1;  // [m/s]; slower robots stand
constexpr double kLookAhead = 6.0;    // [m] along the way

// Room between the bodies [m]:
constexpr double kLikedRoom = 0.3;   // that people like to leave
constexpr double kLeastRoom = 0.15;  // with which they still pass
constexpr double kWaiting = 1.2;     // to a robot that stands in the way
constexpr double kOffered = 0.8;     // to one that may want to go where the person stands
constexpr double kComingNear = 2.5;  // to one that comes, from which on people step aside
constexpr double kAside = 0.25;      // beside the strip that such a robot drives along

constexpr double kOfGoal = 0.8;   // so much of its radius may a goal be missed by
constexpr double kFront = 0.3;    // cosine of the bearing from which a robot has a person before it
constexpr double kGrazed = 0.01;  // [m]; so much nearer to walls may a way round lead
constexpr double kOutside = 0.001;     // [m]
constexpr double kShortestLeg = 0.02;  // [m]; shorter ones have no direction
constexpr double kJustStopped = 5.0;   // [s]; a robot that stands for less may go on
constexpr double kRemembered = 2.0;    // [s]; the side on which somebody passes
constexpr double kLoyalty = 1.5;       // [m]; the other side must be shorter by so much …
constexpr double kLoyaltyToMoving = 0.5;
constexpr double kToTheRight = 0.1;  // [m]; … or this one longer, in the first place

/// The place and the points of the way, up to where nobody looks any more.
std::vector<Vec2> lineOf(const GivingWay::Walking& who) {
  std::vector<Vec2> line = {who.position};
  double left = kLookAhead;
  for (const Vec2& point : who.way) {
    const Vec2 leg = point - line.back();
    const double length = leg.norm();
    if (length < kOutside) {
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

/// For how long the person walks until the robot, both as they go on now, is nearest [s].
std::optional<double> meetingTime(const Vec2& apart, const Vec2& relative) {
  constexpr double kSameSpeed = 0.2;  // [m/s]
  const double closing = apart.dot(relative);
  if (closing <= 0.0 || relative.norm() < kSameSpeed) {
    return std::nullopt;
  }
  const double time = closing / relative.squaredNorm();
  return time <= GivingWay::kForesight ? std::optional(time) : std::nullopt;
}

/// No outline at the distance or nearer comes to the line.
bool isOffLine(const Footprint& footprint, const Vec2& place, double distance,
               const std::vector<Vec2>& line) {
  const double reach = (reachOf(footprint) + distance) * kOutlineExcess + kOutside;
  for (std::size_t leg = 0; leg + 1 < line.size(); ++leg) {
    if (distanceToSegment({line[leg], line[leg + 1]}, place) < reach) {
      return false;
    }
  }
  return true;
}

double lengthOrNone(const std::vector<Vec2>* way) {
  return way != nullptr ? lengthOfWay(*way) : 1e300;
}

}  // namespace

void GivingWay::update(const FrozenWorld& world) {
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
    world.grid.forEachNear(now.pose.position, kSight + reachOf(constants), [&](int human) {
      const auto at = static_cast<std::size_t>(human);
      if (world.model.people[at].model->givesWayToRobots()) {
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

bool GivingWay::concerns(std::size_t human) const {
  return !people_.empty() && std::binary_search(people_.begin(), people_.end(), human);
}

std::pair<std::size_t, std::size_t> GivingWay::nearOf(std::size_t human) const {
  const auto first = std::lower_bound(near_.begin(), near_.end(), std::make_pair(human, 0UL));
  const auto last = std::lower_bound(first, near_.end(), std::make_pair(human + 1, 0UL));
  return {static_cast<std::size_t>(first - near_.begin()),
          static_cast<std::size_t>(last - near_.begin())};
}

/// Those that stand are met where they are; of the others those in view that come near.
std::vector<GivingWay::Met> GivingWay::metBy(const FrozenWorld& world, const Walking& who) const {
  std::vector<Met> met;
  const auto [first, last] = nearOf(who.human);
  for (std::size_t i = first; i < last; ++i) {
    const std::size_t robot = near_[i].second;
    const RobotState& now = world.state.robots[robot];
    const Vec2& place = now.pose.position;
    Met item{robot, now.pose, now.velocity.norm() < kRobotStands, {}};
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

/// Outlines at a distance that leaves the person outside.
void GivingWay::draw(std::vector<Met>& met, const Walking& who, double room) const {
  for (Met& item : met) {
    const Footprint& footprint = footprints_[item.robot];
    const double own = footprint.isDisc() ? footprint.radius : 0.0;
    const double apart = gapToDisc(footprint, item.pose, who.position, 0.0) + own;
    const double most = apart / kOutlineExcess - own - kOutside;
    const double wide = std::min(who.radius + room, most);
    item.outline = wide > 0.0 ? outlineAround(footprint, item.pose, wide, directions_[item.robot])
                              : std::vector<Vec2>();
    if (!item.outline.empty() && isInside(item.outline, who.position)) {
      item.outline.clear();  // in a notch
    }
  }
}

/// Of the first leg that meets somebody, where it does so first.
std::optional<GivingWay::Conflict> GivingWay::firstConflict(const std::vector<Met>& met,
                                                            const std::vector<Vec2>& line) {
  std::optional<Conflict> first;
  for (std::size_t leg = 0; leg + 1 < line.size() && !first; ++leg) {
    for (std::size_t i = 0; i < met.size(); ++i) {
      const std::optional<Entry> entry = entryInto(met[i].outline, line[leg], line[leg + 1]);
      if (entry && (!first || entry->share < first->share)) {
        first = Conflict{i, leg, entry->share};
      }
    }
  }
  return first;
}

GivingWay::Lead GivingWay::lead(const FrozenWorld& world, const Walking& who) {
  Lead lead;
  lead.direction = who.direction;
  std::vector<Met> met = metBy(world, who);
  if (met.empty()) {
    return lead;
  }
  const std::vector<Vec2> line = lineOf(who);
  if (std::all_of(met.begin(), met.end(), [&](const Met& item) {
        return isOffLine(footprints_[item.robot], item.pose.position, who.radius + kLikedRoom,
                         line);
      })) {
    return lead;
  }
  std::optional<Conflict> conflict;
  for (const double room : {kLikedRoom, kLeastRoom}) {
    draw(met, who, room);
    conflict = firstConflict(met, line);
    if (!conflict) {
      return lead;
    }
    if (const std::optional<Vec2> direction = wayPast(world, who, met, line, *conflict)) {
      lead.direction = *direction;
      return lead;
    }
  }
  return waiting(world, who, met, conflict->met);
}

/// Beside the robot, as near to `place` as its outline allows.
Vec2 GivingWay::besideOf(const FrozenWorld& world, const Met& met, const Vec2& place,
                         double radius) const {
  const Footprint& footprint = footprints_[met.robot];
  const Obstacles::Point foot = nearestPointOf(world.model.robots[met.robot], met.pose, place);
  Vec2 outwards = foot.inside ? Vec2(foot.position - place) : Vec2(place - foot.position);
  const double length = outwards.norm();
  outwards = length > kOutside ? Vec2(outwards / length) : base::directionOf(met.pose.heading);
  const double own = footprint.isDisc() ? footprint.radius : 0.0;
  const double distance = (radius + kLeastRoom + own) * kOutlineExcess - own + kOutside;
  return foot.position + distance * outwards;
}

/// Of walls, as far as the person is now, and of the other robots.
bool GivingWay::isWayFree(const FrozenWorld& world, const Walking& who, const std::vector<Met>& met,
                          std::size_t around, const std::vector<Vec2>& way) {
  const double clear =
      std::min(who.radius, world.obstacles.clearance(who.position, who.radius)) - kGrazed;
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (!isWayClear(way[i - 1], way[i], world.obstacles, clear)) {
      return false;
    }
    for (std::size_t other = 0; other < met.size(); ++other) {
      if (other != around && entryInto(met[other].outline, way[i - 1], way[i])) {
        return false;
      }
    }
  }
  return true;
}

/// Where to head, round the robot on the better side; nothing: there is no room on either.
std::optional<Vec2> GivingWay::wayPast(const FrozenWorld& world, const Walking& who,
                                       const std::vector<Met>& met, const std::vector<Vec2>& line,
                                       const Conflict& conflict) {
  const Met& around = met[conflict.met];
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
  const Vec2 aim = isTaken ? besideOf(world, around, line[end], who.radius) : line[end];
  const bool isTarget = (line[end] - who.way.back()).norm() < kOutside;
  if (isTaken && isTarget && (aim - line[end]).norm() > kOfGoal * who.goalRadius) {
    return std::nullopt;  // as long as it stands there the goal cannot be reached
  }
  WaysRound ways = waysRound(around.outline, line[begin], aim);
  if (ways.left.empty()) {
    ways.left = ways.right = {line[begin], aim};
  }
  const auto ifFree = [&](const std::vector<Vec2>& way) {
    return isWayFree(world, who, met, conflict.met, way) ? &way : nullptr;
  };
  const std::vector<Vec2>* const way =
      choose(ifFree(ways.left), ifFree(ways.right), who.human, around, world.state.time);
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

/// The side chosen before, if it is not much longer, so that nobody dithers.
const std::vector<Vec2>* GivingWay::choose(const std::vector<Vec2>* left,
                                           const std::vector<Vec2>* right, std::size_t human,
                                           const Met& met, double time) {
  if (left == nullptr && right == nullptr) {
    return nullptr;
  }
  Memory& memory = memory_[human];
  double advantage = kToTheRight;  // of the right
  if (memory.robot == met.robot && time - memory.at <= kRemembered) {
    const double loyalty = met.stands ? kLoyalty : kLoyaltyToMoving;
    advantage = memory.isLeft ? -loyalty : loyalty;
  }
  memory = {met.robot, lengthOrNone(left) < lengthOrNone(right) - advantage, time};
  return memory.isLeft ? left : right;
}

/// At some distance; out of the strip of one that comes through.
GivingWay::Lead GivingWay::waiting(const FrozenWorld& world, const Walking& who,
                                   const std::vector<Met>& met, std::size_t blocking) const {
  const std::size_t robot = met[blocking].robot;
  const RobotState& now = world.state.robots[robot];
  Lead lead;
  lead.waits = true;
  lead.direction = who.direction;
  lead.stoodFor = world.state.time - movedAt_[robot];
  for (const Met& item : met) {
    if (met[blocking].stands && item.stands && !item.outline.empty()) {
      lead.closed.push_back(item.outline);
    }
  }
  const double gap = gapToDisc(footprints_[robot], now.pose, who.position, who.radius);
  const Vec2 drives =
      now.velocity.norm() < kRobotStands ? now.pose.direction() : Vec2(now.velocity.normalized());
  const Vec2 apart = who.position - now.pose.position;
  const double left = base::cross(drives, apart);
  const double missing = reachOf(footprints_[robot]) + who.radius + kAside - std::fabs(left);
  const bool isBefore = apart.dot(drives) > kFront * apart.norm();
  const bool comes = lead.stoodFor <= kJustStopped && gap < kComingNear;
  if (gap < kWaiting || (isBefore && comes)) {
    lead.direction = Vec2::Zero();
  }
  if (!isBefore || !((comes && missing > 0.0) || gap < kOffered)) {
    return lead;
  }
  const Vec2 aside = (left >= 0.0 ? 1.0 : -1.0) * Vec2(-drives.y(), drives.x());
  for (const Vec2& away : {aside, Vec2(apart.normalized()), Vec2(-aside)}) {
    const Vec2 to = who.position + std::max(missing, kOffered - gap) * away;
    if (isWayClear(who.position, to, world.obstacles, who.radius)) {
      lead.direction = away;
      break;
    }
  }
  return lead;
}

}  // namespace sim2d

#include "sim2d/world/DensityForce.h"

#include <algorithm>
#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/base/Ranges.h"
#include "sim2d/nav/ReciprocalVelocity.h"
#include "sim2d/nav/SocialForce.h"

namespace sim2d {
namespace {

constexpr double kSamePlace = 1e-9;        // [m]
constexpr double kCrowdRange = 4.0;        // [m] ahead
constexpr double kCrowdLength = 2.0;       // [m]
constexpr double kCrowdWidth = 1.0;        // [m]
constexpr double kSideScale = 0.2;         // [m]
constexpr double kSideShift = 0.02;        // [m]; a person exactly ahead counts as left
constexpr double kCapRange = 3.0;          // [m]
constexpr double kNarrowWidth = 2.0;       // [m]; width between walls
constexpr double kWideWidth = 3.2;         // [m]
constexpr double kBeside = 0.8;            // sine of the angle above which a wall is beside
constexpr double kNoForce = 1e-24;         // [m²/s⁴]
constexpr double kMinCapWeight = 0.001;    // smallest relevant weight of the headway rule
constexpr double kMaxSquaredOffset = 7.0;  // squared; e^-7 < kMinCapWeight

// Constants of the contact guard:
constexpr double kMinHorizon = 0.05;       // t_c [s]
constexpr double kPersonRange = 6.0;       // [m/s]; range of people, times t_c
constexpr double kWallRange = 1.5;         // [m]
constexpr double kMaxPartingSpeed = -0.3;  // [m/s], maximum, of overlapping bodies
constexpr double kMaxYieldSpeedup = 0.6;   // [m/s]; maximum speed increase when giving way
constexpr double kTie = 1e-9;
constexpr double kTolerance = 1e-6;  // [m/s], tolerance of a bound

/// A neighbour in the frame of the walking direction.
struct Neighbor {
  const Pedestrian& who;
  Vec2 apart = Vec2::Zero();  // D [m]
  double distance = 0.0;      // d [m]
  double ahead = 0.0;         // x [m]
  double left = 0.0;          // y [m]
  double alike = 0.0;         // c: 1 same direction, -1 oncoming, 0 across or no goal
  bool hasGoal = false;
  bool isGroupMember = false;
};

/// Valid until the next call.
const std::vector<Neighbor>& visibleNeighbors(const Pedestrian& self,
                                              const std::vector<Pedestrian>& others) {
  const Vec2& way = self.desired.direction;
  thread_local std::vector<Neighbor> seen;
  seen.clear();
  seen.reserve(others.size());
  for (const Pedestrian& other : others) {
    Neighbor item{other};
    item.apart = other.body.position - self.body.position;
    item.distance = item.apart.norm();
    if (item.distance >= kDensityRange || item.distance < kSamePlace) {
      continue;
    }
    item.ahead = item.apart.dot(way);
    item.left = base::cross(way, item.apart);
    item.hasGoal = !other.desired.direction.isZero(0.0);
    item.alike = item.hasGoal ? other.desired.heading.dot(way) : 0.0;
    item.isGroupMember = self.desired.group >= 0 && other.desired.group == self.desired.group;
    seen.push_back(item);
  }
  return seen;
}

/// Neighbours ahead that have a goal, weighted by proximity.
struct CrowdAhead {
  double activation = 0.0;  // 0 with a single neighbour, towards 1 in a crowd
  double weight = 0.0;      // W
  double oncoming = 0.0;    // O
  double side = 0.0;        // S: > 0 if there is more space on the left
};

CrowdAhead crowdAhead(const DensityParameters& parameters, const std::vector<Neighbor>& seen) {
  CrowdAhead crowd;
  double largest = 0.0;
  for (const Neighbor& other : seen) {
    if (other.isGroupMember || !other.hasGoal || other.ahead <= 0.0 || other.ahead >= kCrowdRange) {
      continue;
    }
    const double nearness =
        base::exp(-other.ahead / kCrowdLength - std::fabs(other.left) / kCrowdWidth);
    const double onLeft = base::tanh((other.left + kSideShift) / kSideScale);
    const bool isOncoming = other.alike < 0.0;
    crowd.weight += nearness;
    largest = std::max(largest, nearness);
    crowd.oncoming += isOncoming ? -nearness * other.alike : 0.0;
    crowd.side += (isOncoming ? 1.0 : parameters.fileShare) * nearness * other.alike * onLeft;
  }
  const double beyondOne = crowd.weight - largest;
  crowd.activation = beyondOne / (beyondOne + parameters.crowdScale);
  return crowd;
}

double computeSpeedCap(const DensityParameters& parameters, const Pedestrian& self,
                       const std::vector<Neighbor>& seen) {
  double cap = self.desired.desiredSpeed;
  for (const Neighbor& other : seen) {
    if (other.isGroupMember || other.ahead <= 0.0 || other.distance >= kCapRange) {
      continue;
    }
    const double follows = other.hasGoal ? std::clamp(0.5 + other.alike, 0.0, 1.0) : 1.0;
    const double gap = std::max(0.0, other.distance - self.body.radius - other.who.body.radius);
    const double offset = other.left / (other.ahead * parameters.capWidth);
    if (offset * offset > kMaxSquaredOffset || gap >= cap * parameters.timeGap * follows) {
      continue;  // the weight would be too small, or the cap not lower
    }
    const double share = base::exp(-offset * offset) * follows;
    if (share >= kMinCapWeight) {
      cap = std::min(cap, gap / (parameters.timeGap * share));
    }
  }
  return cap;
}

/// The velocity that others react to: a mixture of the current and the desired one.
Vec2 intendedVelocity(const DensityParameters& parameters, const Pedestrian& who) {
  const Vec2 wanted = who.desired.desiredSpeed * who.desired.direction;
  return who.body.velocity + parameters.intentShare * (wanted - who.body.velocity);
}

Vec2 strangerForce(const DensityParameters& parameters, const Walker& intending,
                   const Vec2& direction, const Neighbor& other, double activation) {
  Walker stranger = other.who.body;
  if (other.hasGoal && !other.who.desired.isRobot) {
    stranger.velocity = intendedVelocity(parameters, other.who);
  }
  const Vec2 closing = intending.velocity - stranger.velocity;
  const double least = parameters.coMovingWeight;
  const double weight =
      least + (1.0 - least) * std::min(1.0, closing.norm() / parameters.fullWeightAt);
  Vec2 force = weight * socialForce(parameters.social, intending, stranger);
  const double braking = force.dot(direction);
  if (other.alike < 0.0 && braking < 0.0 && closing.dot(other.apart) > 0.0) {
    force += activation * (1.0 - parameters.brakingShare) * other.alike * braking * direction;
  }
  return force;
}

Vec2 socialSum(const DensityParameters& parameters, const Pedestrian& self,
               const std::vector<Neighbor>& seen, double activation) {
  ForceParameters forGroup = parameters.social;
  forGroup.epsilon = 0.0;
  forGroup.turnWidth = parameters.groupTurnWidth;
  Walker intending = self.body;
  intending.velocity = intendedVelocity(parameters, self);
  Vec2 sum = Vec2::Zero();
  for (const Neighbor& other : seen) {
    sum += other.isGroupMember
               ? socialForce(forGroup, self.body, other.who.body)
               : strangerForce(parameters, intending, self.desired.direction, other, activation);
  }
  return sum;
}

/// 1 between walls with a narrow gap, decreasing towards the width of a door, 0 where it is wide or
/// open.
double narrowness(const Pedestrian& self, const std::vector<Obstacles::Point>& points) {
  double right = kWideWidth;
  double left = kWideWidth;
  for (const Obstacles::Point& point : points) {
    const Vec2 apart = point.position - self.body.position;
    const double across = base::cross(self.desired.direction, apart);
    if (!point.inside && std::fabs(across) > kBeside * apart.norm()) {
      double& side = across > 0.0 ? left : right;
      side = std::min(side, std::fabs(across));
    }
  }
  const double width = left + right;
  return std::clamp((kWideWidth - width) / (kWideWidth - kNarrowWidth), 0.0,
                    std::min(1.0, width / kNarrowWidth));
}

// Contact guard.

/// velocity · towards <= most.
struct Bound {
  Vec2 towards = Vec2::Zero();  // unit vector
  double most = 0.0;            // [m/s]
  HalfPlane plane() const { return {most * towards, Vec2(-towards.y(), towards.x())}; }
};

/// Of two people, the one who has the other more directly ahead gives way.
bool hasToYield(const Pedestrian& self, const Pedestrian& other, const Vec2& apart) {
  const double ofOther = self.desired.direction.dot(apart);
  const double ofSelf = -other.desired.direction.dot(apart);
  if (std::fabs(ofOther - ofSelf) <= kTie) {
    return self.body.id > other.body.id;
  }
  return ofOther > ofSelf;
}

/// Hard bounds that keep bodies apart, and soft ones by which touching bodies separate.
void boundByPeople(const DensityParameters& parameters, const Pedestrian& self,
                   const std::vector<Pedestrian>& others, double look, std::vector<Bound>& contacts,
                   std::vector<Bound>& yielding) {
  for (const Pedestrian& other : others) {
    const Vec2 apart = other.body.position - self.body.position;
    const double distance = apart.norm();
    const double gap = distance - self.body.radius - other.body.radius;
    if (distance < kSamePlace || gap >= kPersonRange * look) {
      continue;
    }
    const Vec2 towards = apart / distance;
    contacts.push_back({towards, std::max(gap / (2.0 * look), kMaxPartingSpeed)});
    if (gap < parameters.yieldGap && hasToYield(self, other, apart)) {
      const double closeness = 1.0 - std::max(0.0, gap) / parameters.yieldGap;
      const double leaving = std::max(0.0, other.body.velocity.dot(towards));
      yielding.push_back({towards, leaving - parameters.yieldSpeed * closeness});
    }
  }
}

void boundByWalls(const Pedestrian& self, const std::vector<Obstacles::Point>& points, double look,
                  std::vector<Bound>& contacts) {
  for (const Obstacles::Point& point : points) {
    const Vec2 apart = point.position - self.body.position;
    const double distance = apart.norm();
    if (distance < kSamePlace || distance > kWallRange) {
      continue;
    }
    const double side = point.inside ? -1.0 : 1.0;
    const double room = side * distance - self.body.radius;
    contacts.push_back({side * apart / distance, std::max(room / look, kMaxPartingSpeed)});
  }
}

}  // namespace

base::ParameterTable<DensityParameters> densityTable() {
  using P = DensityParameters;
  constexpr base::Range kShare{0.0, 1.0};
  base::ParameterTable<DensityParameters> table;
  table.include(&P::social, forceTable())
      .add(&P::timeGap, "time_gap", "s", base::kTimeSpan,
           "T: time gap to the person straight ahead.", "Tordeux, Chraibi & Seyfried 2016")
      .add(&P::capWidth, "cap_width", "", base::kPositiveWeight,
           "Tangent of the angle from the walking direction that counts as ahead.")
      .add(&P::coMovingWeight, "co_moving_weight", "", kShare,
           "Share of the force between people with equal velocities.")
      .add(&P::fullWeightAt, "full_weight_at", "m/s", base::kPositiveSpeed,
           "Relative speed above which the force between people has full weight.")
      .add(&P::intentShare, "intent_share", "", kShare,
           "Share of the desired velocity in the velocity that people react to.")
      .add(&P::laneFactor, "lane_factor", "m/s²", base::kWeight,
           "Strength of lane formation in counterflow.")
      .add(&P::fileShare, "file_share", "", kShare,
           "Share of people with the same walking direction in the lane force.")
      .add(&P::crowdScale, "crowd_scale", "", base::kPositiveWeight,
           "Crowding ahead at which the crowd-only terms have half of their effect.")
      .add(&P::brakingShare, "braking_share", "", kShare,
           "Share of the braking for oncoming people that remains in a crowd.")
      .add(&P::yieldSpeed, "yield_speed", "m/s", base::kSpeed,
           "Speed at which people in contact separate.")
      .add(&P::yieldGap, "yield_gap", "m", base::kDistance,
           "Gap up to which neighbours count as in contact.")
      .add(&P::pushBackLimit, "push_back_limit", "", base::kWeight,
           "Maximum backward force of walls, as a share of the goal force.")
      .add(&P::crowdWallShare, "crowd_wall_share", "", kShare,
           "Share of the force of walls beside narrow passages that remains in a crowd.")
      .add(&P::groupTurnWidth, "mate_turn_width", "rad", base::kAngleWidth,
           "Angle below which group members side by side evade each other less.");
  return table;
}

DensityForce densityForce(const DensityParameters& parameters, const Pedestrian& self,
                          const std::vector<Pedestrian>& others) {
  const Vec2& way = self.desired.direction;
  const std::vector<Neighbor>& seen = visibleNeighbors(self, others);
  const CrowdAhead crowd = crowdAhead(parameters, seen);
  DensityForce force;
  force.activation = crowd.activation;
  force.speedCap = computeSpeedCap(parameters, self, seen);
  force.goal = goalForce(parameters.social, self.body.velocity, way, force.speedCap);
  force.social = socialSum(parameters, self, seen, crowd.activation);
  const double scale = parameters.crowdScale;
  force.lane = parameters.laneFactor * crowd.side / (scale + crowd.weight) * crowd.oncoming /
               (crowd.oncoming + scale) * crowd.activation * Vec2(-way.y(), way.x());
  return force;
}

Vec2 limitedObstacleForce(const DensityParameters& parameters, const Pedestrian& self,
                          const std::vector<Obstacles::Point>& points, double activation) {
  const Vec2& way = self.desired.direction;
  const double relief =
      activation > 0.0 ? (1.0 - parameters.crowdWallShare) * activation * narrowness(self, points)
                       : 0.0;
  thread_local std::vector<Vec2> forces;  // per point
  obstacleForces(parameters.social, self.body, points, forces);
  Vec2 force = Vec2::Zero();
  for (const Vec2& ofPoint : forces) {
    force += ofPoint;
  }
  for (std::size_t i = 0; relief > 0.0 && i < forces.size(); ++i) {
    const double along = forces[i].dot(way);
    const double aside = 1.0 - along * along / std::max(forces[i].squaredNorm(), kNoForce);
    force -= relief * aside * forces[i];
  }
  const double against = -force.dot(way);
  const double most = parameters.pushBackLimit * parameters.social.goalFactor *
                      self.desired.desiredSpeed / parameters.social.relaxationTime;
  return against <= most ? force : Vec2(force + (against - most) * way);
}

Vec2 avoidContacts(const DensityParameters& parameters, const Pedestrian& self,
                   const std::vector<Pedestrian>& others,
                   const std::vector<Obstacles::Point>& points, const Vec2& velocity, double dt) {
  const double look = std::max(dt, kMinHorizon);
  thread_local std::vector<Bound> contacts, yielding;
  thread_local std::vector<HalfPlane> planes;
  contacts.clear();
  yielding.clear();
  planes.clear();
  contacts.reserve(points.size() + others.size());
  boundByWalls(self, points, look, contacts);
  boundByPeople(parameters, self, others, look, contacts, yielding);
  planes.reserve(contacts.size() + yielding.size());
  for (const std::vector<Bound>* part : {&contacts, &yielding}) {
    for (const Bound& bound : *part) {
      planes.push_back(bound.plane());
    }
  }
  const Vec2 allowed = nearestFeasibleVelocity(planes, contacts.size(), velocity,
                                               velocity.norm() + kMaxYieldSpeedup);
  double share = 1.0;  // scale factor where bodies overlap and cannot separate
  for (const Bound& bound : contacts) {
    const double approach = allowed.dot(bound.towards);
    const double most = std::max(0.0, bound.most);
    if (approach > most + kTolerance) {
      share = std::min(share, most / approach);
    }
  }
  return share * allowed;
}

}  // namespace sim2d

#include "sim2d/world/DensityForce.h"

#include <algorithm>
#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/base/Ranges.h"
#include "sim2d/nav/ObstacleForces.h"
#include "sim2d/nav/ReciprocalVelocity.h"

namespace sim2d {
namespace {

constexpr double kSamePlace = 1e-9;    // [m]
constexpr double kCrowdRange = 4.0;    // [m] ahead
constexpr double kCrowdLength = 2.0;   // [m]
constexpr double kCrowdWidth = 1.0;    // [m]
constexpr double kSideScale = 0.2;     // [m]
constexpr double kSideShift = 0.02;    // [m]; somebody exactly ahead is on the left
constexpr double kCapRange = 3.0;      // [m]
constexpr double kNarrowWay = 2.0;     // [m]; between walls
constexpr double kWideWay = 3.2;       // [m]
constexpr double kBeside = 0.8;        // sine of the angle to the way from which a wall is beside
constexpr double kNoForce = 1e-24;     // [m²/s⁴]
constexpr double kLeastCap = 0.001;    // share of the headway rule that still counts
constexpr double kWidestOffset = 7.0;  // squared; e^-7 < kLeastCap

// Of the guard of contacts:
constexpr double kShortestLook = 0.05;  // t_c [s]
constexpr double kPersonLook = 6.0;     // [m/s]; people whose gap is below this times t_c count
constexpr double kWallLook = 1.5;       // [m]
constexpr double kPartingSpeed = -0.3;  // [m/s], at most, of bodies that overlap
constexpr double kGivingWay = 0.6;      // [m/s]; so much faster than wanted may who gives way be
constexpr double kTie = 1e-9;
constexpr double kTolerance = 1e-6;  // [m/s] of a bound

/// One neighbour as seen along the own way.
struct Seen {
  const Pedestrian& who;
  Vec2 apart = Vec2::Zero();  // D [m]
  double distance = 0.0;      // d [m]
  double ahead = 0.0;         // x [m]
  double left = 0.0;          // y [m]
  double alike = 0.0;         // c: 1 goes my way, -1 comes towards me, 0 across or no goal
  bool hasGoal = false;
  bool isMate = false;
};

/// Valid until the next call.
const std::vector<Seen>& seenBy(const Pedestrian& self, const std::vector<Pedestrian>& others) {
  const Vec2& way = self.desired.direction;
  thread_local std::vector<Seen> seen;
  seen.clear();
  seen.reserve(others.size());
  for (const Pedestrian& other : others) {
    Seen item{other};
    item.apart = other.body.position - self.body.position;
    item.distance = item.apart.norm();
    if (item.distance >= kDensityRange || item.distance < kSamePlace) {
      continue;
    }
    item.ahead = item.apart.dot(way);
    item.left = base::cross(way, item.apart);
    item.hasGoal = !other.desired.direction.isZero(0.0);
    item.alike = item.hasGoal ? other.desired.heading.dot(way) : 0.0;
    item.isMate = self.desired.group >= 0 && other.desired.group == self.desired.group;
    seen.push_back(item);
  }
  return seen;
}

/// Those ahead who have a goal, weighted by nearness.
struct CrowdAround {
  double activation = 0.0;  // 0 with a single neighbour, towards 1 in a crowd
  double weight = 0.0;      // W
  double oncoming = 0.0;    // O
  double side = 0.0;        // S: > 0 the way is freer on the left
};

CrowdAround crowdOf(const DensityParameters& parameters, const std::vector<Seen>& seen) {
  CrowdAround crowd;
  double largest = 0.0;
  for (const Seen& other : seen) {
    if (other.isMate || !other.hasGoal || other.ahead <= 0.0 || other.ahead >= kCrowdRange) {
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

double speedCapOf(const DensityParameters& parameters, const Pedestrian& self,
                  const std::vector<Seen>& seen) {
  double cap = self.desired.desiredSpeed;
  for (const Seen& other : seen) {
    if (other.isMate || other.ahead <= 0.0 || other.distance >= kCapRange) {
      continue;
    }
    const double follows = other.hasGoal ? std::clamp(0.5 + other.alike, 0.0, 1.0) : 1.0;
    const double gap = std::max(0.0, other.distance - self.body.radius - other.who.body.radius);
    const double offset = other.left / (other.ahead * parameters.capWidth);
    if (offset * offset > kWidestOffset || gap >= cap * parameters.timeGap * follows) {
      continue;  // the share below would be too small, or the cap no lower
    }
    const double share = base::exp(-offset * offset) * follows;
    if (share >= kLeastCap) {
      cap = std::min(cap, gap / (parameters.timeGap * share));
    }
  }
  return cap;
}

/// The velocity that others react to: partly the wanted one.
Vec2 intendedVelocity(const DensityParameters& parameters, const Pedestrian& who) {
  const Vec2 wanted = who.desired.desiredSpeed * who.desired.direction;
  return who.body.velocity + parameters.intentShare * (wanted - who.body.velocity);
}

Vec2 forceOfStranger(const DensityParameters& parameters, const Walker& intending,
                     const Vec2& direction, const Seen& other, double activation) {
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
               const std::vector<Seen>& seen, double activation) {
  ForceParameters forMates = parameters.social;
  forMates.epsilon = 0.0;
  forMates.turnWidth = parameters.mateTurnWidth;
  Walker intending = self.body;
  intending.velocity = intendedVelocity(parameters, self);
  Vec2 sum = Vec2::Zero();
  for (const Seen& other : seen) {
    sum += other.isMate
               ? socialForce(forMates, self.body, other.who.body)
               : forceOfStranger(parameters, intending, self.desired.direction, other, activation);
  }
  return sum;
}

/// 1 between walls that leave a narrow way, less the more it is a door, 0 where it is wide or open.
double narrowness(const Pedestrian& self, const std::vector<Obstacles::Point>& points) {
  double right = kWideWay;
  double left = kWideWay;
  for (const Obstacles::Point& point : points) {
    const Vec2 apart = point.position - self.body.position;
    const double across = base::cross(self.desired.direction, apart);
    if (!point.inside && std::fabs(across) > kBeside * apart.norm()) {
      double& side = across > 0.0 ? left : right;
      side = std::min(side, std::fabs(across));
    }
  }
  const double width = left + right;
  return std::clamp((kWideWay - width) / (kWideWay - kNarrowWay), 0.0,
                    std::min(1.0, width / kNarrowWay));
}

// The guard of contacts.

/// velocity · towards <= most.
struct Bound {
  Vec2 towards = Vec2::Zero();  // unit vector
  double most = 0.0;            // [m/s]
  HalfPlane plane() const { return {most * towards, Vec2(-towards.y(), towards.x())}; }
};

/// The one who sees more of the other ahead gives way.
bool givesWay(const Pedestrian& self, const Pedestrian& other, const Vec2& apart) {
  const double ofOther = self.desired.direction.dot(apart);
  const double ofSelf = -other.desired.direction.dot(apart);
  if (std::fabs(ofOther - ofSelf) <= kTie) {
    return self.body.id > other.body.id;
  }
  return ofOther > ofSelf;
}

/// What keeps bodies apart, and what of them should part beyond that, where it can.
void boundByPeople(const DensityParameters& parameters, const Pedestrian& self,
                   const std::vector<Pedestrian>& others, double look, std::vector<Bound>& contacts,
                   std::vector<Bound>& givingWay) {
  for (const Pedestrian& other : others) {
    const Vec2 apart = other.body.position - self.body.position;
    const double distance = apart.norm();
    const double gap = distance - self.body.radius - other.body.radius;
    if (distance < kSamePlace || gap >= kPersonLook * look) {
      continue;
    }
    const Vec2 towards = apart / distance;
    contacts.push_back({towards, std::max(gap / (2.0 * look), kPartingSpeed)});
    if (gap < parameters.yieldGap && givesWay(self, other, apart)) {
      const double closeness = 1.0 - std::max(0.0, gap) / parameters.yieldGap;
      const double leaving = std::max(0.0, other.body.velocity.dot(towards));
      givingWay.push_back({towards, leaving - parameters.yieldSpeed * closeness});
    }
  }
}

void boundByWalls(const Pedestrian& self, const std::vector<Obstacles::Point>& points, double look,
                  std::vector<Bound>& contacts) {
  for (const Obstacles::Point& point : points) {
    const Vec2 apart = point.position - self.body.position;
    const double distance = apart.norm();
    if (distance < kSamePlace || distance > kWallLook) {
      continue;
    }
    const double side = point.inside ? -1.0 : 1.0;
    const double room = side * distance - self.body.radius;
    contacts.push_back({side * apart / distance, std::max(room / look, kPartingSpeed)});
  }
}

}  // namespace

base::ParameterTable<DensityParameters> densityTable() {
  using P = DensityParameters;
  constexpr base::Range kShare{0.0, 1.0};
  base::ParameterTable<DensityParameters> table;
  table.include(&P::social, forceTable())
      .add(&P::timeGap, "time_gap", "s", base::kTimeSpan, "T: to whoever is straight ahead.",
           "Tordeux, Chraibi & Seyfried 2016")
      .add(&P::capWidth, "cap_width", "", base::kWeightAboveZero,
           "Tangent of the angle to the way that counts as ahead.")
      .add(&P::coMovingWeight, "co_moving_weight", "", kShare,
           "Share of the force between people of one velocity.")
      .add(&P::fullWeightAt, "full_weight_at", "m/s", base::kSpeedOfMotion,
           "Relative speed from which the force between people counts fully.")
      .add(&P::intentShare, "intent_share", "", kShare,
           "Share of the wanted velocity in what people react to.")
      .add(&P::laneFactor, "lane_factor", "m/s²", base::kWeight,
           "Strength of sorting into lanes in counter-flow.")
      .add(&P::fileShare, "file_share", "", kShare,
           "Share of those who walk the same way in the lane force.")
      .add(&P::crowdScale, "crowd_scale", "", base::kWeightAboveZero,
           "Crowding ahead at which what acts in crowds alone acts by half.")
      .add(&P::brakingShare, "braking_share", "", kShare,
           "Share of the braking for oncoming people that a crowd keeps.")
      .add(&P::yieldSpeed, "yield_speed", "m/s", base::kSpeed,
           "Speed with which touching people part.")
      .add(&P::yieldGap, "yield_gap", "m", base::kDistance,
           "Gap up to which neighbours count as touching.")
      .add(&P::pushBackLimit, "push_back_limit", "", base::kWeight,
           "Most that walls push back, as a share of the goal force.")
      .add(&P::crowdWallShare, "crowd_wall_share", "", kShare,
           "Share of the push of walls beside narrow ways that a crowd keeps.")
      .add(&P::mateTurnWidth, "mate_turn_width", "rad", base::kAngleWidth,
           "Angle below which mates side by side turn aside less.");
  return table;
}

DensityForce densityForce(const DensityParameters& parameters, const Pedestrian& self,
                          const std::vector<Pedestrian>& others) {
  const Vec2& way = self.desired.direction;
  const std::vector<Seen>& seen = seenBy(self, others);
  const CrowdAround crowd = crowdOf(parameters, seen);
  DensityForce force;
  force.activation = crowd.activation;
  force.speedCap = speedCapOf(parameters, self, seen);
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
  thread_local std::vector<Vec2> forces;  // of points
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

Vec2 guardContacts(const DensityParameters& parameters, const Pedestrian& self,
                   const std::vector<Pedestrian>& others,
                   const std::vector<Obstacles::Point>& points, const Vec2& velocity, double dt) {
  const double look = std::max(dt, kShortestLook);
  thread_local std::vector<Bound> contacts, givingWay;
  thread_local std::vector<HalfPlane> planes;
  contacts.clear();
  givingWay.clear();
  planes.clear();
  contacts.reserve(points.size() + others.size());
  boundByWalls(self, points, look, contacts);
  boundByPeople(parameters, self, others, look, contacts, givingWay);
  planes.reserve(contacts.size() + givingWay.size());
  for (const std::vector<Bound>* part : {&contacts, &givingWay}) {
    for (const Bound& bound : *part) {
      planes.push_back(bound.plane());
    }
  }
  const Vec2 allowed =
      nearestAllowed(planes, contacts.size(), velocity, velocity.norm() + kGivingWay);
  double share = 1.0;  // of it, where bodies overlap and cannot part
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

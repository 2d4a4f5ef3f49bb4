#include "sim2d/nav/SocialForce.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/base/MathEach.h"
#include "sim2d/base/Ranges.h"
#include "sim2d/nav/ObstacleForces.h"

namespace sim2d {
namespace {

constexpr double kShortest = 1e-6;  // below this a vector has no direction
constexpr double kSubStep = 0.2;    // of the time 1 / rate in which the goal force acts
constexpr int kMostSubSteps = 1000;

/// For two bodies in one place: some direction that both sides agree on and that differs from pair
/// to pair.
Vec2 directionOfPair(int selfId, int otherId) {
  const int low = std::min(selfId, otherId);
  const int high = std::max(selfId, otherId);
  const double turn = 2.399963229728653 * (low * 7.0 + high);  // golden angle
  const Vec2 direction = base::directionOf(base::wrapToPi(turn));
  return selfId < otherId ? direction : Vec2(-direction);
}

Vec2 directionTo(const Walker& self, const Walker& other, double distance) {
  if (distance < kShortest) {
    return directionOfPair(self.id, other.id);
  }
  return (other.position - self.position) / distance;
}

/// -1 to 1: on which side of the interaction the other is; a step, or a ramp of half width `width`.
double sideOf(double theta, double width) {
  if (std::fabs(theta) < width) {
    return theta / width;
  }
  return theta > 0.0 ? 1.0 : (theta < 0.0 ? -1.0 : 0.0);
}

Vec2 awayFrom(const Obstacles::Point& point, const Walker& self) {
  return point.inside ? Vec2(point.position - self.position) : Vec2(self.position - point.position);
}

/// `share` of the factor that is left at the distance.
Vec2 pushOf(const ForceParameters& parameters, const Vec2& away, double distance, double share) {
  return distance < kShortest ? Vec2::Zero()
                              : Vec2(parameters.obstacleFactor * share / distance * away);
}

}  // namespace

base::ParameterTable<ForceParameters> forceTable() {
  using P = ForceParameters;
  const std::string walls = "Helbing & Molnár 1995";
  const std::string people = "Moussaïd et al. 2009";
  const std::string groups = "Moussaïd et al. 2010";
  base::ParameterTable<ForceParameters> table;
  table
      .add(&P::relaxationTime, "relaxation_time", "s", base::kTimeSpan,
           "tau: time in which the velocity comes near the wanted one.", walls)
      .add(&P::obstacleRange, "obstacle_range", "m", base::kLength,
           "sigma: distance over which the force of walls falls to 1/e.", walls)
      .add(&P::lambda, "lambda", "s/m", base::kWeight,
           "Weight of the relative velocity in the direction of an interaction.", people)
      .add(&P::gamma, "gamma", "m", base::kLength,
           "Range of an interaction per length of its vector.", people)
      .add(&P::n, "n", "1/m", base::kWeight, "Angular width of turning aside.", people)
      .add(&P::nPrime, "n_prime", "1/m", base::kWeight, "Angular width of slowing down.", people)
      .add(&P::epsilon, "epsilon", "rad/m", base::kFactor,
           "Side to which people give way who meet head on.", people)
      .add(&P::gazeFactor, "gaze_factor", "", base::kWeight,
           "Weight of turning back for members of the group behind.", groups)
      .add(&P::coherenceFactor, "coherence_factor", "", base::kWeight,
           "Weight of the pull to the middle of the group.", groups)
      .add(&P::repulsionFactor, "repulsion_factor", "", base::kWeight,
           "Weight of keeping apart inside the group.", groups);
  return table;
}

Vec2 goalForce(const ForceParameters& parameters, const Vec2& velocity, const Vec2& direction,
               double desiredSpeed) {
  if (direction.isZero(0.0)) {
    return -velocity / parameters.relaxationTime;
  }
  return parameters.goalFactor * (desiredSpeed * direction - velocity) / parameters.relaxationTime;
}

Vec2 meanGoalForce(const ForceParameters& parameters, const Vec2& velocity, const Vec2& direction,
                   double desiredSpeed, const Vec2& otherTerms, double time) {
  const double rate = parameters.goalFactor / parameters.relaxationTime;
  const double wanted = std::ceil(time * rate / kSubStep - 1e-9);
  const int count = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(kMostSubSteps)));
  Vec2 reached = velocity;
  Vec2 sum = Vec2::Zero();
  for (int i = 0; i < count; ++i) {
    const Vec2 force = goalForce(parameters, reached, direction, desiredSpeed);
    sum += force;
    reached += (force + otherTerms) * (time / count);
  }
  return sum / count;
}

Vec2 socialForce(const ForceParameters& parameters, const Walker& self, const Walker& other) {
  const double distance = (other.position - self.position).norm();
  const Vec2 toOther = directionTo(self, other, distance);
  const Vec2 interaction = parameters.lambda * (self.velocity - other.velocity) + toOther;
  const double length = interaction.norm();
  if (length < kShortest) {
    return Vec2::Zero();
  }
  const Vec2 along = interaction / length;
  const Vec2 left(-along.y(), along.x());
  const double reach = parameters.gamma * length;  // B [m]
  const double angle =
      base::atan2(base::cross(along, toOther), along.dot(toOther));  // theta, from along to other
  const double theta = base::wrapToPi(angle + parameters.epsilon * reach);
  const double forSpeed = parameters.nPrime * reach * theta;
  const double forTurn = parameters.n * reach * theta;
  const double decay = -distance / reach;
  std::array<double, 2> shares = {decay - forSpeed * forSpeed, decay - forTurn * forTurn};
  base::expEach(shares.data(), shares.size());
  const double slowing = -shares[0];
  const double turning = -sideOf(theta, parameters.turnWidth) * shares[1];
  return parameters.socialFactor * (slowing * along + turning * left);
}

double cutOff(double share) {
  return -base::log(share);
}

bool isNegligible(const ForceParameters& parameters, const Walker& self, const Walker& other,
                  double cutOff) {
  const Vec2 apart = other.position - self.position;
  const double distance = apart.norm();
  if (distance < kShortest) {
    return false;
  }
  const Vec2 relative = self.velocity - other.velocity;
  const double length = (parameters.lambda * relative + apart / distance).norm();
  const double sideways = std::min(parameters.n, parameters.nPrime) * parameters.gamma *
                          parameters.lambda * base::cross(relative, apart) / distance;
  return distance + sideways * sideways * parameters.gamma * length >
         cutOff * parameters.gamma * length;
}

double socialRange(const ForceParameters& parameters, double speed, double otherSpeed,
                   double cutOff) {
  return cutOff * parameters.gamma * (parameters.lambda * (speed + otherSpeed) + 1.0);
}

Vec2 obstacleForce(const ForceParameters& parameters, const Walker& self,
                   const Obstacles::Point& point) {
  const Vec2 away = awayFrom(point, self);
  const double distance = away.norm();
  const double gap = distance - self.radius;
  return pushOf(parameters, away, distance, base::exp(-gap / parameters.obstacleRange));
}

void obstacleForces(const ForceParameters& parameters, const Walker& self,
                    const std::vector<Obstacles::Point>& points, std::vector<Vec2>& forces) {
  thread_local std::vector<double> distances, shares;
  distances.clear();
  shares.clear();
  forces.clear();
  for (const Obstacles::Point& point : points) {
    const Vec2 away = awayFrom(point, self);
    const double distance = away.norm();
    const double gap = distance - self.radius;
    forces.push_back(away);
    distances.push_back(distance);
    shares.push_back(-gap / parameters.obstacleRange);
  }
  base::expEach(shares.data(), shares.size());
  for (std::size_t i = 0; i < forces.size(); ++i) {
    forces[i] = pushOf(parameters, forces[i], distances[i], shares[i]);
  }
}

Vec2 obstacleForce(const ForceParameters& parameters, const Walker& self,
                   const std::vector<Obstacles::Point>& points) {
  thread_local std::vector<Vec2> forces;
  obstacleForces(parameters, self, points, forces);
  Vec2 sum = Vec2::Zero();
  for (const Vec2& force : forces) {
    sum += force;
  }
  return sum;
}

GroupForce groupForce(const ForceParameters& parameters, const Walker& self, const Vec2& direction,
                      const std::vector<Walker>& others) {
  GroupForce force;
  if (others.empty()) {
    return force;
  }
  Vec2 sumOfOthers = Vec2::Zero();
  for (const Walker& other : others) {
    sumOfOthers += other.position;
    const Vec2 apart = self.position - other.position;
    if (apart.norm() < self.radius + other.radius) {
      force.repulsion += parameters.repulsionFactor * apart;
    }
  }
  const auto otherCount = static_cast<double>(others.size());
  const Vec2 toOthers = sumOfOthers / otherCount - self.position;
  const double ahead = direction.dot(toOthers);
  if (ahead < 0.0) {  // more than 90 degrees off the walking direction
    force.gaze = parameters.gazeFactor * ahead * direction;
  }
  const Vec2 toCentre = (sumOfOthers + self.position) / (otherCount + 1.0) - self.position;
  const double excess = toCentre.norm() - otherCount / 2.0;
  force.coherence = parameters.coherenceFactor * (base::tanh(excess) + 1.0) / 2.0 * toCentre;
  return force;
}

}  // namespace sim2d

#include "sim2d/nav/SocialForce.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/base/Ranges.h"

namespace sim2d {
namespace {

constexpr double kMinLength = 1e-6;  // shorter vectors have no direction
constexpr double kSubStep = 0.2;     // fraction of the time constant 1 / rate of the goal force
constexpr int kMaxSubSteps = 1000;

/// Direction between two bodies at the same position: antisymmetric in the pair and different for
/// each pair.
Vec2 pairDirection(int selfId, int otherId) {
  const int low = std::min(selfId, otherId);
  const int high = std::max(selfId, otherId);
  const double turn = 2.399963229728653 * (low * 7.0 + high);  // golden angle
  const Vec2 direction = base::directionOf(base::wrapToPi(turn));
  return selfId < otherId ? direction : Vec2(-direction);
}

Vec2 directionTo(const Walker& self, const Walker& other, double distance) {
  if (distance < kMinLength) {
    return pairDirection(self.id, other.id);
  }
  return (other.position - self.position) / distance;
}

/// -1 to 1: side of the interaction on which the other is; a step, or a ramp of half width `width`.
double sideSign(double theta, double width) {
  if (std::fabs(theta) < width) {
    return theta / width;
  }
  return theta > 0.0 ? 1.0 : (theta < 0.0 ? -1.0 : 0.0);
}

Vec2 awayFrom(const Obstacles::Point& point, const Walker& self) {
  return point.inside ? Vec2(point.position - self.position) : Vec2(self.position - point.position);
}

/// Repulsion with the fraction `share` of the obstacle factor.
Vec2 obstacleRepulsion(const ForceParameters& parameters, const Vec2& away, double distance,
                       double share) {
  return distance < kMinLength ? Vec2::Zero()
                               : Vec2(parameters.obstacleFactor * share / distance * away);
}

/// Whether both exponents of the social force are below -cutOff, by a bound without transcendental
/// functions: |theta| >= |sin(angle)| - epsilon * reach.
bool isBeyond(const ForceParameters& parameters, const Walker& self, const Walker& other,
              double cutOff, double epsilon) {
  const Vec2 apart = other.position - self.position;
  const double distance = apart.norm();
  if (distance < kMinLength) {
    return false;
  }
  const Vec2 relative = self.velocity - other.velocity;
  const double length = (parameters.lambda * relative + apart / distance).norm();
  const double reach = parameters.gamma * length;
  const double width = std::min(parameters.n, parameters.nPrime);
  const double turn =
      width * parameters.gamma * parameters.lambda * base::cross(relative, apart) / distance;
  const double sideways = std::max(std::fabs(turn) - width * epsilon * reach * reach, 0.0);
  return distance + sideways * sideways * parameters.gamma * length >
         cutOff * parameters.gamma * length;
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
           "tau: relaxation time of the velocity towards the desired one.", walls)
      .add(&P::obstacleRange, "obstacle_range", "m", base::kLength,
           "sigma: distance over which the force of walls decays to 1/e.", walls)
      .add(&P::lambda, "lambda", "s/m", base::kWeight,
           "Weight of the relative velocity in the direction of an interaction.", people)
      .add(&P::gamma, "gamma", "m", base::kLength,
           "Range of an interaction per length of the interaction vector.", people)
      .add(&P::n, "n", "1/m", base::kWeight, "Angular width of the evasion term.", people)
      .add(&P::nPrime, "n_prime", "1/m", base::kWeight, "Angular width of the deceleration term.",
           people)
      .add(&P::epsilon, "epsilon", "rad/m", base::kFactor,
           "Bias to one side for people who meet head-on.", people)
      .add(&P::gazeFactor, "gaze_factor", "", base::kWeight,
           "Weight of the gaze force: turning back to group members behind.", groups)
      .add(&P::coherenceFactor, "coherence_factor", "", base::kWeight,
           "Weight of the attraction to the centre of the group.", groups)
      .add(&P::repulsionFactor, "repulsion_factor", "", base::kWeight,
           "Weight of the repulsion between group members.", groups);
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
  const int count = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(kMaxSubSteps)));
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
  if (length < kMinLength) {
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
  base::expArray(shares.data(), shares.size());
  const double slowing = -shares[0];
  const double turning = -sideSign(theta, parameters.turnWidth) * shares[1];
  return parameters.socialFactor * (slowing * along + turning * left);
}

double cutOff(double share) {
  return -base::log(share);
}

bool isNegligible(const ForceParameters& parameters, const Walker& self, const Walker& other,
                  double cutOff) {
  return isBeyond(parameters, self, other, cutOff, 0.0);
}

double cutOffOfForce(const ForceParameters& parameters, double force) {
  constexpr double kRounding = 1e-6;
  return base::log(std::sqrt(2.0) * std::fabs(parameters.socialFactor) / force) + kRounding;
}

bool isWeaker(const ForceParameters& parameters, const Walker& self, const Walker& other,
              double cutOff) {
  return isBeyond(parameters, self, other, cutOff, std::fabs(parameters.epsilon));
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
  return obstacleRepulsion(parameters, away, distance, base::exp(-gap / parameters.obstacleRange));
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
  base::expArray(shares.data(), shares.size());
  for (std::size_t i = 0; i < forces.size(); ++i) {
    forces[i] = obstacleRepulsion(parameters, forces[i], distances[i], shares[i]);
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
  if (ahead < 0.0) {  // more than 90 degrees from the walking direction
    force.gaze = parameters.gazeFactor * ahead * direction;
  }
  const Vec2 toCentre = (sumOfOthers + self.position) / (otherCount + 1.0) - self.position;
  const double excess = toCentre.norm() - otherCount / 2.0;
  force.coherence = parameters.coherenceFactor * (base::tanh(excess) + 1.0) / 2.0 * toCentre;
  return force;
}

}  // namespace sim2d

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "sim2d/base/Ranges.h"
#include "sim2d/nav/NonholonomicTracking.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/RobotRoute.h"
#include "sim2d/nav/SocialForce.h"

namespace sim2d {
namespace {

constexpr double kForceRange = 8.0;              // [m]; people farther away do not count
constexpr double kWallHorizon = 0.5;             // [s]
constexpr double kAckermannTrackingError = 0.1;  // [m], tracking error; limits the steering
constexpr double kEmergencyMargin = 0.02;        // [m], margin when the robot has to stop

struct SocialForcePlannerParameters {
  ForceParameters forces;
  double desiredSpeed = 1.0;    // v_0 [m/s]
  double turnTime = 0.5;        // T [s]
  double stopDistance = 0.15;   // [m]
  double slowTime = 1.0;        // [s]
  double lookahead = 0.8;       // [m]
  double sidePreference = 0.1;  // [rad]

  /// The defaults of people except for three values: a shorter range of walls, so that the robot
  /// can pass doors; stronger and longer social forces, because a robot evades later than a person
  /// and people may not give way to it.
  SocialForcePlannerParameters() {
    forces.obstacleRange = 0.1;
    forces.socialFactor = 12.0;
    forces.gamma = 0.45;
  }
};

/// Parameters shared by the forces of people and robots, without groups; same texts as for people.
base::ParameterTable<ForceParameters> robotForceTable() {
  using F = ForceParameters;
  const std::vector<base::ParameterSpec> known = forceTable().specs();
  base::ParameterTable<F> table;
  const auto add = [&](double F::*member, const char* key) {
    for (const base::ParameterSpec& spec : known) {
      if (spec.key == key) {
        table.add(member, spec.key, spec.unit, spec.range, spec.help, spec.source);
      }
    }
  };
  table.add(&F::goalFactor, "goal_factor", "", base::kPositiveWeight,
            "k_g: weight of the attractive force along the route.", "Helbing & Molnár 1995");
  add(&F::relaxationTime, "relaxation_time");
  table.add(&F::obstacleFactor, "obstacle_factor", "m/s²", base::kWeight,
            "k_o: force of a wall in contact with the robot. It turns the robot aside, never back.",
            "Helbing & Molnár 1995");
  add(&F::obstacleRange, "obstacle_range");
  table.add(&F::socialFactor, "social_factor", "m/s²", base::kWeight,
            "k_s: weight of the forces of people and robots.", "Moussaïd et al. 2009");
  add(&F::lambda, "lambda");
  add(&F::gamma, "gamma");
  add(&F::n, "n");
  add(&F::nPrime, "n_prime");
  add(&F::epsilon, "epsilon");
  return table;
}

base::ParameterTable<SocialForcePlannerParameters> socialForcePlannerTable() {
  using P = SocialForcePlannerParameters;
  base::ParameterTable<P> table;
  table.include(&P::forces, robotForceTable())
      .add(&P::desiredSpeed, "desired_speed", "m/s", base::kPositiveSpeed,
           "v_0: desired speed, limited by the drive.", "Helbing & Molnár 1995")
      .add(&P::turnTime, "turn_time", "s", base::kTimeSpan,
           "T: time in which the robot turns into the direction of the desired velocity, unless "
           "its angular acceleration takes longer.",
           "Alonso-Mora et al. 2013")
      .add(&P::stopDistance, "stop_distance", "m", base::kDistance,
           "Gap to a person below which the robot does not approach.")
      .add(&P::slowTime, "slow_time", "s", base::kTimeSpan,
           "The approach speed to a person is at most the gap beyond the stop distance divided by "
           "this time.")
      .add(&P::lookahead, "lookahead", "m", base::kLength,
           "Distance along the route to the attracting point; at least 1.5 turning radii.")
      .add(&P::sidePreference, "side_preference", "rad", base::kAngleWidth,
           "Rotation of the desired velocity to the right if people are in its way.");
  return table;
}

/// The robot as a pedestrian of the social force model. The stationary velocity under the current
/// forces, v_0 e + (f_people + f_walls) tau / k_g, is tracked by the drive (as in Ferrer, Garrell &
/// Sanfeliu 2013, the part across the heading turns the robot). It is limited towards people and
/// walls.
class SocialForcePlanner : public Planner {
 public:
  SocialForcePlanner(const RobotBody& body, const SocialForcePlannerParameters& parameters)
      : body_(body),
        parameters_(parameters),
        reach_(circumscribedRadius(body.footprint)),
        speed_(std::min(parameters.desiredSpeed, body.limits.maxVel)),
        side_(parameters.sidePreference),
        gearSelector_(body, parameters.turnTime) {
    parameters_.lookahead = std::max(parameters.lookahead, gearSelector_.minLookahead());
  }

  bool readsScan() const override { return false; }
  base::Result<BodyTwist> command(const Observation& observation) override {
    const Vec2& position = observation.pose.position;
    route_.update(observation, reach_, parameters_.lookahead);
    if (route_.isEmpty()) {
      return BodyTwist{};
    }
    side_.update(observation, route_.remainingLength(position));
    const Vec2 onRoute =
        routeVelocity(route_, observation, parameters_.lookahead, speed_, body_.limits.maxAcc);
    if (onRoute.isZero(0.0)) {
      return BodyTwist{};
    }
    const Vec2 along = rotated(onRoute, side_.detour());
    const std::vector<TrackedBody> others = visibleBodies(observation, kForceRange);
    const Vec2 wanted = equilibriumVelocity(observation, others, along);
    const Vec2 target = route_.pointAhead(position, parameters_.lookahead);
    const DriveReference aim =
        gearSelector_.choose(observation, target, wanted, kAckermannTrackingError);
    const Vec2 allowed = limited(observation, others, aim);
    const BodyTwist twist = aim.toRobotCommand(track(aim.model, rotated(allowed, -aim.heading)));
    return nearestSafeTwist(body_, observation, twist, kEmergencyMargin);
  }

  std::vector<Vec2> path() const override { return route_.points(); }
  bool takeReplanned() override {
    const bool isStuck = side_.takeChanged();
    return route_.takeReplanned() || isStuck;
  }

 private:
  Vec2 equilibriumVelocity(const Observation& observation, const std::vector<TrackedBody>& others,
                           const Vec2& along) const {
    const ForceParameters& forces = parameters_.forces;
    const BodyTwist& motion = observation.motion;
    const Vec2 velocity = rotated(Vec2(motion.linear, motion.lateral), observation.pose.heading);
    const Walker self(-1, observation.pose.position, velocity, reach_);
    Vec2 sum = Vec2::Zero();
    for (const TrackedBody& other : others) {
      sum += socialForce(forces, self, {other.id, other.position, other.velocity, other.radius});
    }
    std::vector<Obstacles::Point> points;
    observation.obstacles->boundaryPoints(self.position, points);
    const Vec2 way = along.normalized();
    Vec2 walls = obstacleForce(forces, self, points);
    walls -= std::min(0.0, walls.dot(way)) * way;  // the route leads around them
    const double relaxation = forces.relaxationTime / forces.goalFactor;
    return along + relaxation * (sum + walls);
  }

  /// Limits the velocity so that the robot needs at least the slow time to reach people, and never
  /// drives into walls.
  Vec2 limited(const Observation& observation, const std::vector<TrackedBody>& others,
               const DriveReference& aim) const {
    const double fastest = std::min(speed_, aim.model.maxVel);
    std::vector<HalfPlane> planes = wallPlanes(observation, reach_, fastest, kWallHorizon);
    const std::size_t fixed = planes.size();
    planes.reserve(fixed + others.size());
    for (const TrackedBody& other : others) {
      const Vec2 apart = other.position - observation.pose.position;
      const double distance = apart.norm();
      if (distance <= 0.0) {
        continue;  // no direction leads nearer
      }
      const Vec2 towards = apart / distance;
      const double room = distance - reach_ - other.radius - parameters_.stopDistance;
      const double closing = room / parameters_.slowTime + other.velocity.dot(towards);
      planes.push_back({std::max(closing, 0.0) * towards, Vec2(-towards.y(), towards.x())});
    }
    const bool isFree = worstViolation(planes, fixed, aim.wanted) <= 0.0;
    return nearestFeasibleVelocity(
        planes, fixed, isFree ? aim.wanted : rotated(aim.wanted, side_.turn()), fastest);
  }

  RobotBody body_;
  SocialForcePlannerParameters parameters_;
  double reach_;  // [m]
  double speed_;  // [m/s]
  RobotRoute route_;
  PassingSide side_;
  GearSelector gearSelector_;
};

base::Result<std::shared_ptr<Planner>> makeSocialForcePlanner(const PlannerSetup& setup) {
  SocialForcePlannerParameters parameters;
  socialForcePlannerTable().set(parameters, setup.parameters);
  return std::shared_ptr<Planner>(std::make_shared<SocialForcePlanner>(setup.body, parameters));
}

}  // namespace

void addSocialForcePlanner(PlannerRegistry& to);
void addSocialForcePlanner(PlannerRegistry& to) {
  to.add("social_force", socialForcePlannerTable().specs(), makeSocialForcePlanner,
         "Moves like a person of the social force model.");
}

}  // namespace sim2d

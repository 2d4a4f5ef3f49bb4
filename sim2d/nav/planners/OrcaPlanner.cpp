#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "sim2d/base/Ranges.h"
#include "sim2d/nav/NonholonomicTracking.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/RobotRoute.h"

namespace sim2d {
namespace {

constexpr double kSeparationTime = 0.5;  // [s] within which bodies in contact separate
constexpr double kMinErrorRatio =
    0.1;  // fraction of epsilon that remains next to a person or a wall
constexpr double kEqualVelocity = 1e-6;  // [m/s]
constexpr double kStopMargin = 0.02;     // [m], margin when the robot has to stop

struct OrcaPlannerParameters {
  double horizon = 3.0;         // tau [s]
  double wallHorizon = 1.0;     // [s]
  double trackingError = 0.1;   // epsilon [m]
  double turnTime = 0.5;        // T [s]
  double share = 1.0;           // fraction of avoiding people
  double robotShare = 0.5;      // fraction of avoiding robots
  double margin = 0.05;         // [m]
  double range = 8.0;           // [m]
  double lookahead = 0.8;       // [m]
  double sidePreference = 0.1;  // [rad]
};

base::ParameterTable<OrcaPlannerParameters> orcaPlannerTable() {
  using P = OrcaPlannerParameters;
  const std::string reciprocal = "van den Berg, Guy, Lin & Manocha 2011";
  const std::string nonholonomic = "Alonso-Mora et al. 2013";
  const base::Range share{0.0, 1.0, true};
  base::ParameterTable<P> table;
  table
      .add(&P::horizon, "horizon", "s", base::kTimeSpan,
           "tau: time for which the selected velocity is free of collisions with people and "
           "robots.",
           reciprocal)
      .add(&P::wallHorizon, "wall_horizon", "s", base::kTimeSpan,
           "Time for which the selected velocity is free of collisions with walls.", reciprocal)
      .add(&P::trackingError, "tracking_error", "m", base::kLength,
           "epsilon: maximum distance of the robot from the position that results from the "
           "selected velocity; less beside people and walls. Its radius is enlarged by this. Not "
           "for omnidirectional robots.",
           nonholonomic)
      .add(&P::turnTime, "turn_time", "s", base::kTimeSpan,
           "T: time in which the robot turns into the direction of the selected velocity, unless "
           "its angular acceleration takes longer.",
           nonholonomic)
      .add(&P::share, "share", "", share,
           "Share of the avoidance of a person that the robot takes: 0.5: people take the other "
           "half, 1: people do not avoid.",
           reciprocal)
      .add(&P::robotShare, "robot_share", "", share,
           "Share of the avoidance of another robot that the robot takes.", reciprocal)
      .add(&P::margin, "margin", "m", base::kDistance,
           "Distance to people and robots in addition to both radii.")
      .add(&P::range, "range", "m", base::kLength, "People and robots farther away are ignored.")
      .add(&P::lookahead, "lookahead", "m", base::kLength,
           "Distance along the route to the target point; at least 1.5 turning radii.")
      .add(&P::sidePreference, "side_preference", "rad", base::kAngleWidth,
           "Rotation of the desired velocity to the right if people are in its way.");
  return table;
}

/// Trackable velocities, in the world frame, and walls, which have priority; then bodies.
std::vector<HalfPlane> combinedPlanes(const std::vector<HalfPlane>& piece, double heading,
                                      const std::vector<HalfPlane>& walls,
                                      const std::vector<HalfPlane>& bodies) {
  std::vector<HalfPlane> planes;
  planes.reserve(piece.size() + walls.size() + bodies.size());
  for (const HalfPlane& edge : piece) {
    planes.push_back(rotated(edge, heading));
  }
  planes.insert(planes.end(), walls.begin(), walls.end());
  planes.insert(planes.end(), bodies.begin(), bodies.end());
  return planes;
}

/// NH-ORCA: of the holonomic velocities that avoid all bodies and that the robot can track within
/// epsilon, the one nearest to the wanted velocity. The robot stops if only that is safe.
class OrcaPlanner : public Planner {
 public:
  OrcaPlanner(const RobotBody& body, const OrcaPlannerParameters& parameters)
      : body_(body),
        parameters_(parameters),
        reach_(circumscribedRadius(body.footprint)),
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
    const Vec2 along = routeVelocity(route_, observation, parameters_.lookahead,
                                     body_.limits.maxVel, body_.limits.maxAcc);
    const Vec2 wanted = rotated(along, side_.detour());
    const Vec2 target = route_.pointAhead(position, parameters_.lookahead);
    const DriveReference aim =
        gearSelector_.choose(observation, target, wanted, parameters_.trackingError);
    const BodyTwist twist = aim.toRobotCommand(track(aim.model, bestVelocity(observation, aim)));
    return nearestSafeTwist(body_, observation, twist, kStopMargin);
  }

  std::vector<Vec2> path() const override { return route_.points(); }
  bool takeReplanned() override {
    const bool isStuck = side_.takeChanged();
    return route_.takeReplanned() || isStuck;
  }

 private:
  /// In the frame in which the robot drives forward.
  Vec2 bestVelocity(const Observation& observation, const DriveReference& aim) const {
    const std::vector<TrackedBody> others = visibleBodies(observation, parameters_.range);
    const double error = trackingErrorNear(observation, others);
    const std::vector<HalfPlane> walls =
        wallPlanes(observation, reach_ + error, aim.model.maxVel, parameters_.wallHorizon);
    const std::vector<HalfPlane> bodies = bodyPlanes(observation, others, error);
    const bool isFree = worstViolation(bodies, 0, aim.wanted) <= 0.0;
    const Vec2 wanted = isFree ? aim.wanted : rotated(aim.wanted, side_.turn());
    Vec2 best = Vec2::Zero();
    double leastViolation = std::numeric_limits<double>::infinity();
    double leastChange = std::numeric_limits<double>::infinity();
    for (const std::vector<HalfPlane>& piece : trackableVelocities(aim.model, error)) {
      const std::vector<HalfPlane> planes = combinedPlanes(piece, aim.heading, walls, bodies);
      const std::size_t fixed = planes.size() - bodies.size();
      const Vec2 found = nearestFeasibleVelocity(planes, fixed, wanted, aim.model.maxVel);
      const double violation = worstViolation(planes, fixed, found);
      const double change = (found - wanted).norm();
      if (violation < leastViolation - kEqualVelocity ||
          (violation < leastViolation + kEqualVelocity && change < leastChange)) {
        best = found;
        leastViolation = violation;
        leastChange = change;
      }
    }
    return rotated(best, -aim.heading);
  }

  /// Epsilon, or half of the clearance to the nearest body or wall, so that the enlarged robot
  /// touches nothing that the robot does not touch (variable tracking error of the paper).
  double trackingErrorNear(const Observation& observation,
                           const std::vector<TrackedBody>& others) const {
    if (body_.kinematics == Kinematics::Omnidirectional) {
      return 0.0;
    }
    const Vec2& position = observation.pose.position;
    const double most = parameters_.trackingError;
    const double limit = reach_ + 2.0 * most;
    double room = observation.obstacles->clearance(position, limit) - reach_;
    for (const TrackedBody& other : others) {
      room = std::min(room, (other.position - position).norm() - other.radius - reach_);
    }
    return std::clamp(0.5 * room, kMinErrorRatio * most, most);
  }

  std::vector<HalfPlane> bodyPlanes(const Observation& observation,
                                    const std::vector<TrackedBody>& others, double error) const {
    const Vec2& position = observation.pose.position;
    const BodyTwist& motion = observation.motion;
    const Vec2 velocity = rotated(Vec2(motion.linear, motion.lateral), observation.pose.heading);
    std::vector<HalfPlane> planes;
    planes.reserve(others.size());
    for (const TrackedBody& other : others) {
      // Within the margin: do not come nearer; separation is required on contact only.
      const double distance = (other.position - position).norm();
      const double touching = reach_ + other.radius;
      const double apart =
          std::max(touching, std::min(touching + error + parameters_.margin, 0.9999 * distance));
      const Walker self(-1, position, velocity, apart - other.radius);
      const double share =
          other.kind == BodyKind::Robot ? parameters_.robotShare : parameters_.share;
      planes.push_back(bodyHalfPlane(self, {other.id, other.position, other.velocity, other.radius},
                                     parameters_.horizon, kSeparationTime, share));
    }
    return planes;
  }

  RobotBody body_;
  OrcaPlannerParameters parameters_;
  double reach_;  // [m]
  RobotRoute route_;
  PassingSide side_;
  GearSelector gearSelector_;
};

base::Result<std::shared_ptr<Planner>> makeOrcaPlanner(const PlannerSetup& setup) {
  OrcaPlannerParameters parameters;
  orcaPlannerTable().set(parameters, setup.parameters);
  return std::shared_ptr<Planner>(std::make_shared<OrcaPlanner>(setup.body, parameters));
}

}  // namespace

void addOrcaPlanner(PlannerRegistry& to);
void addOrcaPlanner(PlannerRegistry& to) {
  to.add("orca", orcaPlannerTable().specs(), makeOrcaPlanner,
         "Optimal reciprocal collision avoidance (ORCA) for the kinematics of the robot "
         "(NH-ORCA).");
}

}  // namespace sim2d

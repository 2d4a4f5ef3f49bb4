#include <algorithm>

#include "sim2d/base/Math.h"
#include "sim2d/base/Ranges.h"
#include "sim2d/nav/ReciprocalVelocity.h"
#include "sim2d/world/models/PedestrianModel.h"

namespace sim2d {
namespace {

constexpr std::size_t kMaxNeighbors = 12;  // number of nearest neighbours considered
constexpr double kRobotShare = 1.0;        // robots do not follow this rule
constexpr double kPersonShare = 0.5;

struct OrcaParameters {
  double horizon = 2.0;          // tau [s]
  double obstacleHorizon = 1.0;  // [s]
  double range = 8.0;            // [m]
  double brakingTime = 0.5;      // [s], without a goal
  double sidePreference = 0.05;  // [rad]
};

base::ParameterTable<OrcaParameters> orcaTable() {
  using P = OrcaParameters;
  const std::string source = "van den Berg et al. 2011";
  base::ParameterTable<OrcaParameters> table;
  table
      .add(&P::horizon, "horizon", "s", base::kTimeSpan,
           "tau: time for which velocities are free of collisions with people.", source)
      .add(&P::obstacleHorizon, "obstacle_horizon", "s", base::kTimeSpan,
           "Time for which velocities are free of collisions with walls.", source)
      .add(&P::range, "range", "m", base::kLength, "People farther away are ignored.", source)
      .add(&P::brakingTime, "braking_time", "s", base::kTimeSpan,
           "Time in which people without a goal come to a stop.")
      .add(&P::sidePreference, "side_preference", "rad", base::kHeading,
           "Rotation of the desired velocity to the right if the path is not free.");
  return table;
}

/// Optimal reciprocal collision avoidance: of the velocities that avoid all others, the one nearest
/// to the desired velocity. Walls are represented by their boundary points. There are no group
/// forces.
class Orca : public PedestrianModel {
 public:
  explicit Orca(const ResolvedHuman& person) {
    static const base::ParameterTable<OrcaParameters> kTable = orcaTable();
    kTable.set(parameters_, person.modelParameters);
    parameters_.horizon /= person.reactionTime;  // slow reactions shorten the horizon
    parameters_.obstacleHorizon /= person.reactionTime;
    parameters_.brakingTime *= person.reactionTime;
  }

  /// Accelerations that lead to the chosen velocity: `social` is the change by avoidance.
  ForceTerms forces(const Situation& situation) const override {
    const Vec2 wanted = wantedVelocity(situation);
    ForceTerms terms;
    terms.goal = (wanted - situation.self.velocity) / situation.dt;
    terms.social = (chosenVelocity(situation, wanted) - wanted) / situation.dt;
    return terms;
  }

  Vec2 velocity(const Situation& situation, const ForceTerms& forces) const override {
    return velocityAfterForces(situation, forces, situation.dt);
  }

  std::optional<std::size_t> maxNeighbors() const override { return kMaxNeighbors; }
  double range(double /*fastest*/, double /*ownSpeed*/) const override { return parameters_.range; }

 private:
  Vec2 wantedVelocity(const Situation& situation) const {
    if (situation.desired.direction.isZero(0.0)) {
      return situation.self.velocity * std::max(0.0, 1.0 - situation.dt / parameters_.brakingTime);
    }
    return situation.desired.desiredSpeed * situation.desired.direction;
  }

  Vec2 chosenVelocity(const Situation& situation, const Vec2& wanted) const {
    thread_local std::vector<HalfPlane> planes;
    planes.clear();
    addPlanesOfWalls(situation, planes);
    const std::size_t fixed = planes.size();
    addPlanesOfOthers(situation, planes);
    const bool isFree = std::all_of(planes.begin(), planes.end(), [&](const HalfPlane& plane) {
      return plane.violation(wanted) <= 0.0;
    });
    if (isFree) {
      return wanted;
    }
    const double cosine = base::cos(parameters_.sidePreference);
    const double sine = base::sin(parameters_.sidePreference);
    const Vec2 aside(cosine * wanted.x() + sine * wanted.y(),
                     cosine * wanted.y() - sine * wanted.x());
    return nearestFeasibleVelocity(planes, fixed, aside, situation.desired.desiredSpeed);
  }

  void addPlanesOfWalls(const Situation& situation, std::vector<HalfPlane>& planes) const {
    const double near =
        situation.self.radius + situation.desired.desiredSpeed * parameters_.obstacleHorizon;
    for (const Obstacles::Point& point : situation.obstacles) {
      if (point.inside || point.distance <= near) {
        planes.push_back(
            pointHalfPlane(situation.self, point, parameters_.obstacleHorizon, situation.dt));
      }
    }
  }

  /// Of people and robots together the nearest visible ones.
  void addPlanesOfOthers(const Situation& situation, std::vector<HalfPlane>& planes) const {
    const Vec2& place = situation.self.position;
    thread_local std::vector<Candidate> near;
    near.clear();
    for (std::size_t i = 0; i < situation.others.size(); ++i) {
      const Walker& other = situation.others[i];
      const double squared = (other.position - place).squaredNorm();
      const bool isRobot = i >= situation.firstRobot;
      if (squared < parameters_.range * parameters_.range &&
          (!isRobot || (*situation.isVisible)(place, other.position))) {
        near.push_back({squared, other.id, &other, isRobot ? kRobotShare : kPersonShare});
      }
    }
    std::sort(near.begin(), near.end());
    near.resize(std::min(near.size(), kMaxNeighbors));
    for (const Candidate& other : near) {
      planes.push_back(bodyHalfPlane(situation.self, *other.body, parameters_.horizon, situation.dt,
                                     other.share));
    }
  }

  struct Candidate {
    double squaredDistance = 0.0;  // [m²]
    int id = 0;
    const Walker* body = nullptr;
    double share = kPersonShare;
    bool operator<(const Candidate& other) const {
      return squaredDistance < other.squaredDistance ||
             (squaredDistance == other.squaredDistance && id < other.id);
    }
  };

  OrcaParameters parameters_;
};

}  // namespace

void addOrca(ModelRegistry& to);
void addOrca(ModelRegistry& to) {
  to.add(
      "orca", orcaTable().specs(),
      [](const ResolvedHuman& person) { return std::make_unique<Orca>(person); },
      "Optimal reciprocal collision avoidance (van den Berg et al. 2011): the collision-free "
      "velocity closest to the desired one.");
}

}  // namespace sim2d

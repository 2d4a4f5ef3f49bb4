#include <algorithm>
#include <iterator>

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

  /// The nearest visible neighbours, nearest first; of equally near ones the lower id.
  void addPlanesOfOthers(const Situation& situation, std::vector<HalfPlane>& planes) const {
    std::vector<Candidate>& near = candidatesWithin(situation, parameters_.range);
    std::size_t count = 0;
    for (auto end = near.end(); end != near.begin() && count < kMaxNeighbors; --end) {
      std::pop_heap(near.begin(), end, isFarther);
      const std::size_t i = std::prev(end)->index;
      const Walker& other = situation.others[i];
      if ((*situation.isVisible)(situation.self.position, other.position)) {
        const double share = i >= situation.firstRobot ? kRobotShare : kPersonShare;
        planes.push_back(
            bodyHalfPlane(situation.self, other, parameters_.horizon, situation.dt, share));
        ++count;
      }
    }
  }

  struct Candidate {
    double squaredDistance = 0.0;  // [m²]
    int id = 0;
    std::size_t index = 0;  // in Situation::others
  };

  static bool isFarther(const Candidate& a, const Candidate& b) {
    return b.squaredDistance < a.squaredDistance ||
           (b.squaredDistance == a.squaredDistance && b.id < a.id);
  }

  /// A heap with the nearest candidate on top: few of the many candidates are taken from it, so
  /// they need not be sorted. Valid until the next call.
  static std::vector<Candidate>& candidatesWithin(const Situation& situation, double range) {
    thread_local std::vector<Candidate> near;
    near.clear();
    for (std::size_t i = 0; i < situation.others.size(); ++i) {
      const Walker& other = situation.others[i];
      const double squared = (other.position - situation.self.position).squaredNorm();
      if (squared < range * range) {
        near.push_back({squared, other.id, i});
      }
    }
    std::make_heap(near.begin(), near.end(), isFarther);
    return near;
  }

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

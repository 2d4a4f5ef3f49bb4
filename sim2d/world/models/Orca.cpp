#include <algorithm>

#include "sim2d/base/Math.h"
#include "sim2d/base/Ranges.h"
#include "sim2d/nav/ReciprocalVelocity.h"
#include "sim2d/world/models/PedestrianModel.h"

namespace sim2d {
namespace {

constexpr std::size_t kMostNeighbors = 12;  // nearest ones that count
constexpr double kRobotShare = 1.0;         // robots do not give way by this rule
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
           "tau: velocities keep people apart for so long.", source)
      .add(&P::obstacleHorizon, "obstacle_horizon", "s", base::kTimeSpan, "The same for walls.",
           source)
      .add(&P::range, "range", "m", base::kLength, "People farther away do not count.", source)
      .add(&P::brakingTime, "braking_time", "s", base::kTimeSpan,
           "In which people without a goal come to a stand.")
      .add(&P::sidePreference, "side_preference", "rad", base::kHeading,
           "Turn of the wanted velocity to the right where the way is not free.");
  return table;
}

/// Optimal reciprocal collision avoidance: of the velocities that keep everybody apart the one
/// nearest to the wanted. Walls come in as their boundary points. There are no group forces.
class Orca : public PedestrianModel {
 public:
  explicit Orca(const ResolvedHuman& person) {
    static const base::ParameterTable<OrcaParameters> kTable = orcaTable();
    kTable.set(parameters_, person.modelParameters);
    parameters_.horizon /= person.reactionTime;  // who is slow gives way late
    parameters_.obstacleHorizon /= person.reactionTime;
    parameters_.brakingTime *= person.reactionTime;
  }

  /// Accelerations that lead to the chosen velocity: `social` is what avoiding changes.
  ForceTerms forces(const Situation& situation) const override {
    const Vec2 wanted = wantedVelocity(situation);
    ForceTerms terms;
    terms.goal = (wanted - situation.self.velocity) / situation.dt;
    terms.social = (chosenVelocity(situation, wanted) - wanted) / situation.dt;
    return terms;
  }

  Vec2 velocity(const Situation& situation, const ForceTerms& forces) const override {
    return velocityAfter(situation, forces, situation.dt);
  }

  bool looksAtDesires() const override { return true; }
  double range(double /*fastest*/, double /*ownSpeed*/) const override { return parameters_.range; }

 private:
  Vec2 wantedVelocity(const Situation& situation) const {
    if (situation.desired.direction.isZero(0.0)) {
      return situation.self.velocity * std::max(0.0, 1.0 - situation.dt / parameters_.brakingTime);
    }
    return situation.desired.desiredSpeed * situation.desired.direction;
  }

  Vec2 chosenVelocity(const Situation& situation, const Vec2& wanted) const {
    std::vector<HalfPlane> planes = planesOfWalls(situation);
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
    return nearestAllowed(planes, fixed, aside, situation.desired.desiredSpeed);
  }

  std::vector<HalfPlane> planesOfWalls(const Situation& situation) const {
    const double near =
        situation.self.radius + situation.desired.desiredSpeed * parameters_.obstacleHorizon;
    std::vector<HalfPlane> planes;
    for (const Obstacles::Point& point : situation.obstacles) {
      if (point.inside || point.distance <= near) {
        planes.push_back(
            avoidPoint(situation.self, point, parameters_.obstacleHorizon, situation.dt));
      }
    }
    return planes;
  }

  void addPlanesOfOthers(const Situation& situation, std::vector<HalfPlane>& planes) const {
    const Vec2& place = situation.self.position;
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < situation.others.size(); ++i) {
      if ((situation.others[i].position - place).squaredNorm() <
          parameters_.range * parameters_.range) {
        near.push_back(i);
      }
    }
    std::sort(near.begin(), near.end(), [&](std::size_t a, std::size_t b) {
      const Walker& first = situation.others[a];
      const Walker& second = situation.others[b];
      const double nearer = (first.position - place).squaredNorm();
      const double farther = (second.position - place).squaredNorm();
      return nearer < farther || (nearer == farther && first.id < second.id);
    });
    std::size_t count = 0;
    for (const std::size_t i : near) {
      const Walker& other = situation.others[i];
      if (count == kMostNeighbors) {
        break;
      }
      if ((*situation.isVisible)(place, other.position)) {
        const double share = situation.desires[i].isRobot ? kRobotShare : kPersonShare;
        planes.push_back(
            avoidBody(situation.self, other, parameters_.horizon, situation.dt, share));
        ++count;
      }
    }
  }

  OrcaParameters parameters_;
};

}  // namespace

void addOrca(ModelRegistry& to);
void addOrca(ModelRegistry& to) {
  to.add(
      "orca", orcaTable().specs(),
      [](const ResolvedHuman& person) { return std::make_unique<Orca>(person); },
      "Optimal reciprocal collision avoidance (van den Berg et al. 2011): of the velocities that "
      "lead to no collision the one next to the wanted.");
}

}  // namespace sim2d

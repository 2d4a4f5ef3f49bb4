#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "sim2d/base/Registry.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/world/DensityForce.h"

namespace sim2d {

/// Input of a model for one person; positions and velocities are those at the start of the step.
struct Situation {
  Walker self;
  DesiredMotion desired;  // of the person; zero direction: brake
  double dt = 0.05;       // [s]
  /// Time over which forces act in this step [s]. Half of dt when a person starts or begins to
  /// brake: velocities belong to the middle of steps, so that positions do not depend on dt.
  double forceTime = 0.05;
  /// People, and from `firstRobot` on robots, without those treated as obstacles. With
  /// `maxNeighbors` of the model the people are the nearest visible ones within its range, nearest
  /// first, of equally near ones the lower id.
  std::vector<Walker> others;
  std::size_t firstRobot = 0;
  /// Social force of all people, if it was computed for the whole crowd; then `others` contains
  /// robots only [m/s²].
  std::optional<Vec2> crowdForce;
  std::vector<DesiredMotion>
      desiredMotions;  // parallel to `others`, filled if `usesDesiredMotions`
  bool usesDesiredMotions = false;
  std::vector<Walker> group;  // other members of the person's group
  std::vector<Obstacles::Point> obstacles;
  /// True if no obstacle is between two points.
  const std::function<bool(const Vec2&, const Vec2&)>* isVisible = nullptr;
  bool exact = false;  // small terms must not be skipped
  /// Cache between `forces` and `velocity` of one step: indices of visible `others`. Initially
  /// none.
  mutable std::optional<std::vector<std::size_t>> seen;
};

/// Terms of the acceleration [m/s²].
struct ForceTerms {
  Vec2 goal = Vec2::Zero(), social = Vec2::Zero(), obstacle = Vec2::Zero(), group = Vec2::Zero();
  Vec2 sum() const { return goal + social + obstacle + group; }
};

constexpr double kStandstillSpeed = 1e-3;  // [m/s]; slower people who brake stand still

/// Velocity after the forces have acted for `time` [s], clamped to the desired speed; zero for
/// people who brake below `standing` [m/s].
inline Vec2 velocityAfterForces(const Situation& situation, const ForceTerms& forces, double time,
                                double standing = 0.0) {
  const Vec2 velocity = situation.self.velocity + forces.sum() * time;
  const double speed = velocity.norm();
  if (speed > situation.desired.desiredSpeed) {
    return velocity * (situation.desired.desiredSpeed / speed);
  }
  const bool stands = situation.desired.direction.isZero(0.0) && speed < standing;
  return stands ? Vec2(Vec2::Zero()) : velocity;
}

/// A pedestrian model. One instance serves all people with the same kind and force factors, so it
/// must depend on these only; both functions are const and may run in parallel for different
/// people.
class PedestrianModel {
 public:
  virtual ~PedestrianModel() = default;
  virtual ForceTerms forces(const Situation& situation) const = 0;
  /// Desired velocity at the end of the step [m/s].
  virtual Vec2 velocity(const Situation& situation, const ForceTerms& forces) const = 0;
  /// A model whose social force is the sum of `socialForce` over the others returns its law here;
  /// in large crowds the sum is then provided as `crowdForce`. The parameters must live as long as
  /// the model.
  virtual CrowdForceModel crowdForceModel() const { return {}; }
  /// The model uses the desired motion of others.
  virtual bool usesDesiredMotions() const { return false; }
  /// People walk around robots and stop in front of them (`YieldModel`).
  virtual bool yieldsToRobots() const { return true; }
  /// In a crowd people use the full width of a path around a corner.
  virtual bool spreadsAtCorners() const { return false; }
  /// Radius that replaces the scenario's for this person [m]; none: not replaced.
  virtual std::optional<double> bodyRadiusOverride(const ResolvedHuman& /*person*/) const {
    return {};
  }
  /// The number of people that matter: the nearest visible ones; none: all within the range.
  virtual std::optional<std::size_t> maxNeighbors() const { return {}; }
  /// Interaction range [m].
  virtual double range(double fastest, double ownSpeed) const = 0;
};

/// Creates the model for people like this one. Each file in this folder registers its model in
/// `add<File>`.
using ModelFactory = std::function<std::unique_ptr<PedestrianModel>(const ResolvedHuman& person)>;
using ModelRegistry = base::Registry<ModelFactory>;

}  // namespace sim2d

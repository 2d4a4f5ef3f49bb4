#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "sim2d/base/Registry.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/world/DensityForce.h"

namespace sim2d {

/// One person with all that a model may react to; positions and velocities as they were when the
/// step began.
struct Situation {
  Walker self;
  DesiredMotion desired;  // of the person; no direction: brake
  double dt = 0.05;       // [s]
  /// Over which forces act in this step. Half of dt when somebody sets off or begins to brake:
  /// velocities belong to the middle of steps, so places do not depend on dt [s].
  double pushTime = 0.05;
  std::vector<Walker> others;  // people and robots, without those that act as obstacles
  /// The social force of all people, when it was computed for the whole crowd at once: then only
  /// robots are in `others` [m/s²].
  std::optional<Vec2> ofCrowd;
  std::vector<DesiredMotion> desires;  // beside `others`, filled when `looksAtDesires`
  bool looksAtDesires = false;
  std::vector<Walker> group;  // the other members of the person's group
  std::vector<Obstacles::Point> obstacles;
  /// Nothing solid between two points.
  const std::function<bool(const Vec2&, const Vec2&)>* isVisible = nullptr;
  bool exact = false;  // no term is left out for being small
  /// What a model may keep from `forces` to `velocity` of the step, which need the same: whom of
  /// `others` the person sees, by number. None at the begin.
  mutable std::optional<std::vector<std::size_t>> seen;
};

/// Terms of the acceleration [m/s²].
struct ForceTerms {
  Vec2 goal = Vec2::Zero(), social = Vec2::Zero(), obstacle = Vec2::Zero(), group = Vec2::Zero();
  Vec2 sum() const { return goal + social + obstacle + group; }
};

constexpr double kStandingSpeed = 1e-3;  // [m/s]; who brakes below this stands, by most models

/// After the forces have acted for `time` [s]: not above the desired speed; zero for who brakes
/// below `standing` [m/s].
inline Vec2 velocityAfter(const Situation& situation, const ForceTerms& forces, double time,
                          double standing = 0.0) {
  const Vec2 velocity = situation.self.velocity + forces.sum() * time;
  const double speed = velocity.norm();
  if (speed > situation.desired.desiredSpeed) {
    return velocity * (situation.desired.desiredSpeed / speed);
  }
  const bool stands = situation.desired.direction.isZero(0.0) && speed < standing;
  return stands ? Vec2(Vec2::Zero()) : velocity;
}

/// How people move. One instance serves all people with the same kind and the same factors of
/// forces, so it is made of these alone; both functions are const and may run in parallel for
/// different people.
class PedestrianModel {
 public:
  virtual ~PedestrianModel() = default;
  virtual ForceTerms forces(const Situation& situation) const = 0;
  /// Velocity wanted at the end of the step [m/s].
  virtual Vec2 velocity(const Situation& situation, const ForceTerms& forces) const = 0;
  /// A model whose social force is the sum of `socialForce` over the others names its law here; in
  /// large crowds it then gets the sum as `ofCrowd`. The parameters live as long as the model.
  virtual SocialLaw socialLaw() const { return {}; }
  /// The model wants to know where others are heading.
  virtual bool looksAtDesires() const { return false; }
  /// Such people walk round robots and stop before them (`GivingWay`).
  virtual bool givesWayToRobots() const { return true; }
  /// In a crowd such people use the whole width of a way round a corner.
  virtual bool spreadsAtCorners() const { return false; }
  /// Radius that counts for this person instead of the one of the scenario [m]; none: that counts.
  virtual std::optional<double> ownBodyRadius(const ResolvedHuman& /*person*/) const { return {}; }
  /// Others farther away than this never count [m].
  virtual double range(double fastest, double ownSpeed) const = 0;
};

/// Makes the model of people like this one. A file in this folder registers its own in `add<File>`.
using ModelMaker = std::function<std::unique_ptr<PedestrianModel>(const ResolvedHuman& person)>;
using ModelRegistry = base::Registry<ModelMaker>;

}  // namespace sim2d

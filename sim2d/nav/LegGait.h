#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim2d/nav/Observation.h"

/// Pedestrians as seen by a lidar at shin height: two legs that swing while walking.
namespace sim2d {

/// Two discs; world frame.
struct Legs {
  Vec2 left = Vec2::Zero(), right = Vec2::Zero();  // [m]
  double radius = 0.06;                            // [m]
};

/// Step length L = sqrt(W v) [m] at speed v [m/s]. The walk ratio W (step length over step rate)
/// does not depend on speed; 0.0065 m/(steps/min) = 0.39 m s in adults (Sekiya & Nagasaki 1998,
/// Gait & Posture 7). v = 1.34 m/s: L = 0.72 m, 111 steps/min. 0 when standing.
double stepLength(double speed);

/// Legs of a pedestrian at a gait phase in [0, 1), half a shoulder width (0.1 m) to either side.
/// The left leg moves linearly from the foremost position (0) to the rearmost (0.5) and back (1),
/// the right one opposite. The amplitude is half a step, so that the foot on the ground does not
/// slide; less if the legs would leave the disc of the body. Standing: side by side.
Legs legsAt(const SensedBody& person, double stride);

/// Gait phase of each pedestrian, from the distance walked; a stride is two steps. Initial phases
/// are drawn from (seed, person), so all gaits of one seed agree. Not thread-safe.
class LegGait {
 public:
  explicit LegGait(std::uint64_t seed) : seed_(seed) {}

  /// Call once per step. Pedestrians in `bodies` are sorted by id; new ones start with a drawn
  /// phase.
  void update(const std::vector<SensedBody>& bodies);
  /// Phase of the body with that index in the last update, in [0, 1); 0 for robots.
  double gaitPhase(std::size_t number) const { return walkers_[number].stride; }

 private:
  struct Walker {
    int id = -1;  // -1: a robot
    Vec2 position = Vec2::Zero();
    double stride = 0.0;
  };

  std::uint64_t seed_;
  std::vector<Walker> walkers_, before_;  // same order as `bodies`
};

}  // namespace sim2d

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim2d/nav/SensedWorld.h"

/// People as a lidar at shin height sees them: two legs that swing as they walk.
namespace sim2d {

/// Two discs; world frame.
struct Legs {
  Vec2 left = Vec2::Zero(), right = Vec2::Zero();  // [m]
  double radius = 0.06;                            // [m]
};

/// L = sqrt(W v) [m] at speed v [m/s]: step length over step rate, the walk ratio W, does not
/// depend on speed; 0.0065 m/(steps/min) = 0.39 m s in adults (Sekiya & Nagasaki 1998, Gait &
/// Posture 7). v = 1.34 m/s: L = 0.72 m, 111 steps/min. 0 when standing.
double stepLength(double speed);

/// The person's legs at a share of the stride in [0, 1): half a shoulder (0.1 m) to either side;
/// the left one from furthest ahead (0) to furthest back (0.5) and ahead again (1), the right one
/// opposite, evenly. Half a step to the front and back, so that the leg on the ground stays there;
/// less where the disc of the body has less room, for legs never leave it. Standing: side by side.
Legs legsOf(const SensedBody& person, double stride);

/// How far everybody is in his stride: a stride is two steps, by the distance walked. Where each
/// begins is drawn by (seed, person), so all gaits of one seed are alike. Thread: one at a time.
class LegGait {
 public:
  explicit LegGait(std::uint64_t seed) : seed_(seed) {}

  /// Each step. People stand by id in `bodies`; who was not there before begins anew.
  void update(const std::vector<SensedBody>& bodies);
  /// Of the body of that number in the last update, in [0, 1); of robots 0.
  double strideOf(std::size_t number) const { return walkers_[number].stride; }

 private:
  struct Walker {
    int id = -1;  // -1: a robot
    Vec2 position = Vec2::Zero();
    double stride = 0.0;
  };

  std::uint64_t seed_;
  std::vector<Walker> walkers_, before_;  // as in `bodies`
};

}  // namespace sim2d

#pragma once

#include <cstdint>
#include <vector>

#include "sim2d/world/Crowd.h"
#include "sim2d/world/RouteFollower.h"

namespace sim2d {

/// What one person wants of the step.
struct WantedMotion {
  Vec2 velocity = Vec2::Zero();         // [m/s]
  ForceTerms forces;                    // that led to it [m/s²]
  bool looksAhead = false;              // the heading follows the velocity
  std::vector<Obstacles::Point> walls;  // near the body
};

/// From intents to wanted velocities: ways, forces, the model of each person.
class PersonMotion {
 public:
  /// The result is the same for every number of threads.
  explicit PersonMotion(int threadCount) : workers_(threadCount) {}

  /// One entry per person of the model.
  void resize(std::size_t count);
  void forget(int human);  // an old way
  void enter(int human);   // somebody who comes in and stands

  /// Where everybody heads. Emits `replan` and `stuck`.
  void chooseLegs(const FrozenWorld& world, const Intents& intents, Ways& ways, WorldState& state);
  /// `compute` comes soon: threads may wake up.
  void expectWork();
  /// Then: fills `wanted` and turns those who turn on the spot.
  void compute(const FrozenWorld& world, const Intents& intents, const Ways& ways,
               WorldState& state);
  const std::vector<WantedMotion>& wanted() const { return wanted_; }

 private:
  struct alignas(64) Desk {  // what one thread works on; no line of memory is another's too
    Situation situation;
  };

  void move(std::size_t human, const FrozenWorld& world, const Intents& intents,
            Situation& situation);
  static void turn(std::size_t human, const Intent& intent, double dt, WorldState& state);

  WorkerPool workers_;
  Crowd crowd_;
  std::vector<Desk> desks_;  // by thread
  std::vector<RouteFollower> routes_;
  std::vector<Vec2> directions_;
  std::vector<std::uint8_t> changes_;  // sets off or ends to walk in this step
  std::vector<WantedMotion> wanted_;
};

/// New heading of a person: towards `velocity` when it is not too slow to have a direction, at most
/// pi rad/s.
double headingAfter(double heading, const Vec2& velocity, double dt);

}  // namespace sim2d

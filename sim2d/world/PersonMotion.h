#pragma once

#include <memory>
#include <vector>

#include "sim2d/world/Crowd.h"
#include "sim2d/world/GivingWay.h"
#include "sim2d/world/RouteFollower.h"

namespace sim2d {

/// From intents to wanted velocities: ways, forces, the model of each person.
class PersonMotion {
 public:
  /// The result is the same for every number of threads.
  explicit PersonMotion(int threadCount) : workers_(threadCount) {}

  /// One entry per person of the model.
  void resize(std::size_t count);
  void forget(std::size_t human);  // an old way
  void enter(std::size_t human);   // somebody who comes in and stands
  /// The way points still to be walked to; none: straight on, or nowhere.
  std::vector<Vec2> wayOf(std::size_t human) const;

  /// Where everybody heads. Emits `replan` and `stuck`.
  void chooseLegs(const FrozenWorld& world, const Intents& intents, WorldState& state);
  /// `compute` comes soon: threads may wake up.
  void expectWork();
  /// Then: fills `wanted` and the forces of all people, which lead to it, and turns those who turn
  /// on the spot.
  void compute(const FrozenWorld& world, const Intents& intents, WorldState& state,
               ForceColumns& forces);
  const std::vector<Vec2>& wanted() const { return wanted_; }  // velocities [m/s]
  /// From now on these act on people (by person) instead of what stands in the world; kept by the
  /// caller.
  void giveWalls(const std::vector<std::vector<Obstacles::Point>>* points) { given_ = points; }
  /// Instead of what the person wants in this step [m/s].
  void steer(std::size_t human, const Vec2& velocity) { wanted_[human] = velocity; }
  /// False: somebody's velocity or heading is not sound.
  bool isSound() const;
  /// Near the body of a person; null: nothing stands anywhere.
  const std::vector<Obstacles::Point>* wallsNear(std::size_t human) const {
    if (given_ != nullptr) {
      return &(*given_)[human];
    }
    return walls_.empty() ? nullptr : &walls_[human];
  }

 private:
  struct alignas(64) Workspace {  // what one thread works on; no line of memory is another's too
    Situation situation;
    bool isSound = true;
  };

  ForceTerms move(std::size_t human, const FrozenWorld& world, const Intents& intents,
                  Situation& situation);
  void chooseLeg(std::size_t human, const Intent& intent, const FrozenWorld& world,
                 WorldState& state);
  RouteFollower::Leg plannedLeg(std::size_t human, const RouteFollower::Request& request,
                                const FrozenWorld& world);
  /// Round robots in the way of somebody, or waits for them.
  void giveWay(std::size_t human, const RouteFollower::Request& request, const FrozenWorld& world,
               RouteFollower::Leg& leg);
  void findWalls(std::size_t human, const FrozenWorld& world);

  WorkerPool workers_;
  Crowd crowd_;
  GivingWay givingWay_;
  std::vector<Workspace> workspaces_;                   // by thread
  std::vector<std::unique_ptr<RouteFollower>> routes_;  // null: straight ways so far
  StepPlans plans_;
  std::vector<Vec2> wanted_;
  std::vector<std::vector<Obstacles::Point>> walls_;
  const std::vector<std::vector<Obstacles::Point>>* given_ = nullptr;
};

/// Finite, and not so fast that the run has diverged.
bool isSound(const Vec2& velocity);
/// New heading of a person: towards `velocity` when it is not too slow to have a direction, at most
/// pi rad/s.
double headingAfter(double heading, const Vec2& velocity, double dt);

}  // namespace sim2d

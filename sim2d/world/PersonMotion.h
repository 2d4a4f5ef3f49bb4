#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sim2d/world/Crowd.h"
#include "sim2d/world/RouteFollower.h"
#include "sim2d/world/WorldState.h"
#include "sim2d/world/YieldModel.h"

namespace sim2d {

/// Computes desired velocities from intents: paths, forces, and the model of each person.
class PersonMotion {
 public:
  /// The result does not depend on the number of threads.
  explicit PersonMotion(int threadCount) : workers_(threadCount) {}

  /// One entry per person of the model.
  void resize(std::size_t count);
  void forget(std::size_t human);  // discards the current path
  void enter(std::size_t human);   // for a person who enters and stands
  /// Remaining path points; empty: straight, or no target.
  std::vector<Vec2> remainingPath(std::size_t human) const;

  /// Chooses the walking directions of all people. Emits `replan` and `stuck`.
  void chooseDirections(const FrozenWorld& world, const Intents& intents, WorldState& state);
  /// Wakes worker threads ahead of `compute`.
  void wakeWorkers();
  /// Call after `chooseDirections`: fills `wanted` and the forces of all people, and rotates people
  /// who turn in place.
  void compute(const FrozenWorld& world, const Intents& intents, WorldState& state,
               ForceColumns& forces);
  const std::vector<Vec2>& wanted() const { return wanted_; }  // desired velocities [m/s]
  /// From now on these points (by person) act on people instead of the obstacles of the world;
  /// owned by the caller.
  void setExternalWalls(const std::vector<std::vector<Obstacles::Point>>* points) {
    externalWalls_ = points;
  }
  /// Overrides the desired velocity in this step [m/s].
  void overrideVelocity(std::size_t human, const Vec2& velocity) { wanted_[human] = velocity; }
  /// False if the velocity or heading of a person is invalid.
  bool isSound() const;
  /// Wall points near a person; null: there are no walls.
  const std::vector<Obstacles::Point>* wallsNear(std::size_t human) const {
    if (externalWalls_ != nullptr) {
      return &(*externalWalls_)[human];
    }
    return walls_.empty() ? nullptr : &walls_[human];
  }

 private:
  struct alignas(64) Workspace {  // of one thread, on its own cache lines
    Situation situation;
    bool isSound = true;
  };

  ForceTerms move(std::size_t human, const FrozenWorld& world, const Intents& intents,
                  Situation& situation);
  void chooseDirection(std::size_t human, const Intent& intent, const FrozenWorld& world,
                       WorldState& state);
  RouteFollower::Guidance plannedGuidance(std::size_t human, const RouteFollower::Request& request,
                                          const FrozenWorld& world);
  /// Adapts the direction to robots in the way: walks around them or waits.
  void yieldToRobots(std::size_t human, const RouteFollower::Request& request,
                     const FrozenWorld& world, RouteFollower::Guidance& leg);
  void updateWalls(std::size_t human, const FrozenWorld& world);

  WorkerPool workers_;
  Crowd crowd_;
  YieldModel yieldModel_;
  std::vector<Workspace> workspaces_;                   // by thread
  std::vector<std::unique_ptr<RouteFollower>> routes_;  // null: only straight paths so far
  StepPlans plans_;
  std::vector<Vec2> wanted_;
  std::vector<std::vector<Obstacles::Point>> walls_;
  const std::vector<std::vector<Obstacles::Point>>* externalWalls_ = nullptr;
};

/// Finite and below kMaxPlausibleSpeed.
bool isSound(const Vec2& velocity);
/// New heading of a person: turned towards `velocity` by at most pi rad/s, unless it is too slow to
/// have a direction.
double turnedHeading(double heading, const Vec2& velocity, double dt);

/// Reached goals of people: cyclic and one-way lists, waiting times, events. The front goal is
/// reached when a walking step towards it ends inside its radius, or when a behaviour emits the
/// event.
class PersonGoals {
 public:
  void resize(std::size_t count) { people_.resize(count); }
  void enter(std::size_t human) { people_[human] = Progress{}; }

  /// Call after the behaviours have decided: handles goals that they report as reached, lets
  /// waiting people stand, and moves the events of the behaviours to the state.
  void afterDecide(const WorldModel& model, WorldState& state, Intents& intents,
                   const WorldView& view);
  /// Call after the step.
  void afterMotion(const WorldModel& model, WorldState& state, const Intents& intents);

  /// Indices of people whose one-way list has ended since the last call.
  std::vector<std::size_t> takeArrived() { return std::exchange(arrived_, {}); }

 private:
  struct Progress {
    std::unique_ptr<GoalItem> lastReached;  // reached and not left since then; null: none
    double waitingUntil = -1.0;             // [s]
    std::uint32_t lastIndex = 0;            // of the last reached goal, in the scenario's list
    bool hasReached = false;
  };
  void reach(const WorldModel& model, WorldState& state, std::size_t human, const GoalItem& goal);
  void recordReached(const WorldModel& model, const WorldState& state, std::size_t human,
                     int goalId);

  std::vector<Progress> people_;
  std::vector<std::size_t> arrived_;
};

}  // namespace sim2d

#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sim2d/world/WorldState.h"

namespace sim2d {

/// Reached goals of people: cyclic and one-way lists, waiting times, events. The front goal is
/// reached when a walking step towards it ends inside its radius, or when a behaviour emits the
/// event.
class PersonGoals {
 public:
  void resize(std::size_t count) { people_.resize(count); }
  void enter(std::size_t human) { people_[human] = Progress{}; }

  /// Call after the behaviours have decided: handles goals that they report as reached, and lets
  /// waiting people stand.
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

#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sim2d/world/WorldState.h"

namespace sim2d {

/// Goals that are reached: lists that turn or run out, the waits at them, events. Reached is the
/// front of a person's list, by a step of walking to it that ends inside its radius, or when a
/// behaviour says so by the event.
class Goals {
 public:
  void resize(std::size_t count) { people_.resize(count); }
  void enter(std::size_t human) { people_[human] = Progress{}; }

  /// After the behaviours have decided: goals they call reached, and people who wait stand.
  void afterDecide(const WorldModel& model, WorldState& state, Intents& intents,
                   const WorldView& view);
  /// After the step.
  void afterMotion(const WorldModel& model, WorldState& state, const Intents& intents);

  /// People whose one-way list ran out since the last call, by index.
  std::vector<std::size_t> takeArrived() { return std::exchange(arrived_, {}); }

 private:
  struct Progress {
    std::unique_ptr<GoalItem> standsIn;  // reached and not left since; null: none
    double waitsUntil = -1.0;            // [s]
    std::uint32_t lastIndex = 0;         // of the goal last reached, in the scenario's list
    bool hasReached = false;
  };
  void reach(const WorldModel& model, WorldState& state, std::size_t human, const GoalItem& goal);
  void note(const WorldModel& model, const WorldState& state, std::size_t human, int goalId);

  std::vector<Progress> people_;
  std::vector<std::size_t> arrived_;
};

}  // namespace sim2d

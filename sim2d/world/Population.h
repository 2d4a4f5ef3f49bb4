#pragma once

#include <vector>

#include "sim2d/map/NavigationMap.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// Who comes in when: people with a start time, those whose place was taken, arrivals of sources.
/// Arrivals of a source are a Poisson process drawn from (seed, area).
class Population {
 public:
  explicit Population(const WorldModel& model);

  /// People (indices) for whom it is time and whose place is free; they leave the queue. Copies
  /// from sources are appended to model and state first.
  std::vector<std::size_t> dueNow(WorldModel& model, WorldState& state,
                                  const NavigationMap& navigation);
  /// The person comes (again) as soon as the place is free.
  void enqueue(std::size_t human) { waiting_.push_back(human); }

 private:
  struct Source {
    std::size_t area = 0;         // in WorldModel::areas
    const Human* like = nullptr;  // in WorldModel::patterns
    std::shared_ptr<GoalPlan> plan;
    int arrived = 0;    // copies so far
    double next = 0.0;  // time of the next arrival [s]
  };
  void scheduleNext(const WorldModel& model, Source& source) const;
  bool addCopy(Source& source, WorldModel& model, WorldState& state,
               const NavigationMap& navigation) const;

  std::vector<Source> sources_;
  std::vector<std::size_t> waiting_;
};

/// Goals by their ids, without those that nobody knows.
std::vector<GoalItem> goalItems(const WorldModel& model, const std::vector<int>& ids,
                                double radius);

}  // namespace sim2d

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/map/NavigationMap.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// Starts and goals before a run.

constexpr double kMaxPlacementShift = 1.0;  // [m], maximum displacement of a body that does not fit

/// Starts and goals, for the bounds of an open plane.
std::vector<Vec2> placementPoints(const WorldModel& model);
/// Errors: coordinates that are not finite or beyond 1e6 m, undefined goals.
void checkPlacement(const WorldModel& model, base::Diagnostics& problems);
/// Moves starts and goals to the nearest place within `kMaxPlacementShift` where the body fits,
/// with a warning that contains both points; an error if there is none. Goals of people with direct
/// routes are not moved. Then separates overlapping starts.
void fitPlacement(WorldModel& model, const NavigationMap& navigation, base::Diagnostics& problems);
/// Removes unreachable goals from the lists, each with a warning.
void removeUnreachableGoals(WorldModel& model, const NavigationMap& navigation,
                            base::Diagnostics& problems);

/// Adds the problems of one entity.
class EntityProblems {
 public:
  EntityProblems(EntityId entity, std::string who, base::Diagnostics& problems)
      : entity_(entity), who_(std::move(who)), problems_(problems) {}

  void add(base::Diagnostic problem) {
    problem.entity = entity_;
    problems_.push_back(who_.empty() ? problem : base::withContext(who_, std::move(problem)));
  }
  void need(bool holds, const char* code, base::ProblemValues values = {}) {
    if (!holds) {
      add(base::error(code, std::move(values)));
    }
  }

 private:
  EntityId entity_;
  std::string who_;  // prefix of each text, unless empty
  base::Diagnostics& problems_;
};

/// Entry of people: by start time, when an occupied place becomes free, and by sources. The
/// arrivals of a source are a Poisson process drawn from (seed, area).
class Population {
 public:
  explicit Population(const WorldModel& model);

  /// Indices of people whose time has come and whose place is free; they are removed from the
  /// queue. Copies from sources are appended to model and state first.
  std::vector<std::size_t> takeDue(WorldModel& model, WorldState& state,
                                   const NavigationMap& navigation);
  /// The person enters (again) as soon as the place is free.
  void enqueue(std::size_t human) { waiting_.push_back(human); }

 private:
  struct Source {
    std::size_t area = 0;         // in WorldModel::areas
    const Human* like = nullptr;  // in WorldModel::sourceTemplates
    std::shared_ptr<GoalPlan> plan;
    int arrived = 0;    // number of copies so far
    double next = 0.0;  // time of the next arrival [s]
  };
  void scheduleNext(const WorldModel& model, Source& source) const;
  bool spawnCopy(Source& source, WorldModel& model, WorldState& state,
                 const NavigationMap& navigation) const;

  std::vector<Source> sources_;
  std::vector<std::size_t> waiting_;
};

/// Goals by id; unknown ids are skipped.
std::vector<GoalItem> goalItemsOf(const WorldModel& model, const std::vector<int>& ids,
                                  double radius);

/// Moves starts of people as drawn by the scenario's `variation`, after `fitPlacement`. A drawn
/// place is accepted if the straight path to it keeps a body's clearance to walls, and if distances
/// to other people and robots are not below what bodies need or the scenario has. Otherwise it is
/// drawn again, and after some attempts the person stays at the written place. Disabled robots keep
/// people away too, with a fixed minimum distance, so that a run without its robot has the same
/// people. By ascending id.
void varyStarts(const Scenario& scenario, const NavigationMap& navigation, WorldModel& model);

}  // namespace sim2d

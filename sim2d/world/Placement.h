#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Problems.h"
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

}  // namespace sim2d

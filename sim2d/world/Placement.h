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

constexpr double kPlaceReach = 1.0;  // [m] that who does not fit may be moved

/// Starts and goals, for the bounds of an open plane.
std::vector<Vec2> placesOf(const WorldModel& model);
/// Errors: coordinates that are not finite or beyond 1e6 m, goals that nobody defined.
void checkPlaces(const WorldModel& model, base::Diagnostics& problems);
/// Moves starts and goals to the nearest place within `kPlaceReach` where the body fits, with a
/// warning that names both points; there is none: error. Goals of people who walk straight stay
/// where they are. Then parts starts that would stand in each other.
void fitPlaces(WorldModel& model, const NavigationMap& navigation, base::Diagnostics& problems);
/// Takes goals without a way to them off the lists, each with a warning.
void leaveOutUnreachable(WorldModel& model, const NavigationMap& navigation,
                         base::Diagnostics& problems);

/// The problems of one thing.
class ProblemsOf {
 public:
  ProblemsOf(EntityId entity, std::string who, base::Diagnostics& problems)
      : entity_(entity), who_(std::move(who)), problems_(problems) {}

  void add(base::Diagnostic problem) {
    problem.entity = entity_;
    problems_.push_back(who_.empty() ? problem : base::within(who_, std::move(problem)));
  }
  void need(bool holds, const char* code, base::ProblemValues values = {}) {
    if (!holds) {
      add(base::error(code, std::move(values)));
    }
  }

 private:
  EntityId entity_;
  std::string who_;  // stands before each text, unless it is empty
  base::Diagnostics& problems_;
};

}  // namespace sim2d

#pragma once

#include <vector>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"

namespace sim2d::nav2 {

struct ThroughPosesResult {
  PlanError error = PlanError::None;
  Path path;             // leg after leg; both poses of a joint stay. Empty with an error
  int reached = -1;      // index of the last goal that a leg leads to
  bool isWhole = false;  // false without an error: a part, as `allow_partial_planning` allows
};

/// ComputePathThroughPoses: each leg starts where the one before ended, which may be beside its
/// goal. `request.goal` is not looked at. No goals: NoValidPath.
ThroughPosesResult planThroughPoses(GlobalPlanner& planner, PlanRequest request,
                                    const std::vector<Pose2>& goals, bool allowPartial = false);

}  // namespace sim2d::nav2

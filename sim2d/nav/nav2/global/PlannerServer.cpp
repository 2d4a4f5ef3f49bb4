#include "sim2d/nav/nav2/global/PlannerServer.h"

namespace sim2d::nav2 {

ThroughPosesResult planThroughPoses(GlobalPlanner& planner, PlanRequest request,
                                    const std::vector<Pose2>& goals, bool allowPartial) {
  ThroughPosesResult result;
  if (goals.empty()) {
    result.error = PlanError::NoValidPath;
    return result;
  }
  for (const Pose2& goal : goals) {
    if (!result.path.empty()) {
      request.start = result.path.back();
    }
    request.goal = goal;
    const PlanResult leg = planner.plan(request);
    if (leg.error != PlanError::None) {
      const bool isPart = allowPartial && !result.path.empty();
      result.error = isPart ? PlanError::None : leg.error;
      if (!isPart) {
        result.path.clear();
        result.reached = -1;
      }
      return result;
    }
    result.path.insert(result.path.end(), leg.path.begin(), leg.path.end());
    ++result.reached;
  }
  result.isWhole = true;
  return result;
}

}  // namespace sim2d::nav2

#include "sim2d/nav/nav2/global/GlobalPlanner.h"

#include <cmath>

#include "sim2d/base/Math.h"

namespace sim2d::nav2 {
namespace {

struct PlanErrorText {
  PlanError error;
  const char* name;
  const char* message;
};

constexpr PlanErrorText kPlanErrors[] = {
    {PlanError::None, "NONE", ""},
    {PlanError::Unknown, "UNKNOWN", "planning failed"},
    {PlanError::InvalidPlanner, "INVALID_PLANNER", "there is no such planner"},
    {PlanError::TfError, "TF_ERROR", "the frames are not connected"},
    {PlanError::StartOutsideMap, "START_OUTSIDE_MAP", "the start lies outside the map"},
    {PlanError::GoalOutsideMap, "GOAL_OUTSIDE_MAP", "the goal lies outside the map"},
    {PlanError::StartOccupied, "START_OCCUPIED", "the start is occupied"},
    {PlanError::GoalOccupied, "GOAL_OCCUPIED", "the goal is occupied"},
    {PlanError::Timeout, "TIMEOUT", "the search took too long"},
    {PlanError::NoValidPath, "NO_VALID_PATH", "there is no path to the goal"},
};

const PlanErrorText& textOf(PlanError error) {
  for (const PlanErrorText& text : kPlanErrors) {
    if (text.error == error) {
      return text;
    }
  }
  return kPlanErrors[1];
}

}  // namespace

const char* planErrorName(PlanError error) {
  return textOf(error).name;
}

const char* planErrorMessage(PlanError error) {
  return textOf(error).message;
}

void setFinalApproachHeading(Path& path, double startHeading) {
  if (path.empty()) {
    return;
  }
  if (path.size() == 1) {
    path.back().heading = startHeading;
    return;
  }
  constexpr double kSame = 1e-4;  // [m]
  const Vec2 last = path.back().position;
  Vec2 before = path[path.size() - 2].position;
  if ((last - before).cwiseAbs().maxCoeff() < kSame && path.size() > 2) {
    before = path[path.size() - 3].position;
  }
  path.back().heading = base::atan2(last.y() - before.y(), last.x() - before.x());
}

Pose2 singlePose(const Pose2& start, const Pose2& goal, bool useFinalApproachOrientation) {
  return {start.position, useFinalApproachOrientation ? start.heading : goal.heading};
}

}  // namespace sim2d::nav2

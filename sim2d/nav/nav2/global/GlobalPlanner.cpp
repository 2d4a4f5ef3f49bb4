#include "sim2d/nav/nav2/global/GlobalPlanner.h"

namespace sim2d::nav2 {
namespace {

struct PlanErrorText {
  PlanError error;
  const char* name;
  const char* words;
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
    {PlanError::NoValidPath, "NO_VALID_PATH", "there is no way to the goal"},
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

const char* planErrorWords(PlanError error) {
  return textOf(error).words;
}

}  // namespace sim2d::nav2

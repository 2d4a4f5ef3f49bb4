#pragma once

#include <string>

#include "sim2d/nav/Planner.h"

namespace sim2d {

/// Distance outside `goal_radius` within which a goal still counts as reached when the robot's
/// planner reports success [m]: the default `tolerance` of Nav2's planners, by which a path may end
/// beside the goal.
constexpr double kGoalReachedTolerance = 0.5;

/// A goal that the robot's planner has ended.
struct GoalResult {
  NavigationResult result;
  double time = 0.0;         // of the state after it [s]
  double distance = 0.0;     // true distance from the robot's centre to the goal in that state [m]
  int goal = 0;              // goal id; 0: none
  int number = 1;            // 1-based index in the robot's list
  bool isReached = false;    // success within goal_radius + kGoalReachedTolerance
  bool isExternal = false;   // goal set from outside
  bool isOneOfMany = false;  // the robot has several goals
};

/// "0.213 m from the goal", "goal 2: planner NO_VALID_PATH (208), 3.4 m from the goal".
std::string goalResultText(const GoalResult& end);
/// Reason for the failure without the distance, or the distance on success: "planner NO_VALID_PATH
/// (208)".
std::string goalResultReason(const GoalResult& end);

}  // namespace sim2d

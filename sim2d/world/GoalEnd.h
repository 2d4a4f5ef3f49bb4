#pragma once

#include <string>

#include "sim2d/nav/NavigationEnd.h"

namespace sim2d {

/// How far outside `goal_radius` a robot may be when its planner reports success, for the goal to
/// count as reached [m]: the default `tolerance` of Nav2's planners, by which a path may end beside
/// the goal.
constexpr double kReachedBeyondRadius = 0.5;

/// A goal that the robot's planner has ended.
struct GoalEnd {
  NavigationEnd result;
  double time = 0.0;         // of the state after it [s]
  double distance = 0.0;     // true one, from the robot's centre to the goal in that state [m]
  int goal = 0;              // its id; 0: it has none
  int number = 1;            // its place in the robot's list, the first is 1
  bool isReached = false;    // it succeeded within goal_radius + kReachedBeyondRadius
  bool isOrder = false;      // a place to which the robot was sent from outside
  bool isOneOfMany = false;  // the robot has several goals
};

/// "0.213 m from the goal", "goal 2: planner NO_VALID_PATH (208), 3.4 m from the goal".
std::string goalEndText(const GoalEnd& end);
/// Why it failed, without the distance; of success the distance: "planner NO_VALID_PATH (208)".
std::string goalEndReason(const GoalEnd& end);

}  // namespace sim2d

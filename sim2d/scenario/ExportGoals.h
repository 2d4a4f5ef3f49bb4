#pragma once

#include <map>

#include "sim2d/scenario/Scenario.h"

/// Numbers of goals in an export. Private to this folder.
namespace sim2d {

using GoalNumbers = std::map<int, int>;  // old -> new

/// 1 ... N in the order of the old ones.
GoalNumbers numbersWithoutGaps(const Scenario& scenario);

/// Dialect B names the goals of each person and numbers none: who reads it counts them, person
/// after person, behind those of nobody's list, which it has under numbers of their own. A goal in
/// several lists has its first number.
GoalNumbers numbersOfDialectB(const Scenario& scenario);

/// Goals, people and robots get the new numbers, the goals in their order.
void renumberGoals(Scenario& scenario, const GoalNumbers& numbers);

/// In two steps.
GoalNumbers chained(const GoalNumbers& first, const GoalNumbers& second);

}  // namespace sim2d

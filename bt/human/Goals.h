#pragma once

#include "bt/human/HumanContext.h"

/// The list of goals of a person, as nodes change it.
namespace bt {

/// A goal counts as reached this far outside its radius [m].
constexpr double kGoalTolerance = 0.1;

/// The front goal is within its radius + 0.1 m; false without goals.
bool isGoalReached(HumanContext& context, int human);
/// The front goal goes to the end, or away on a one-way list. One that was reached is told by the
/// events `goal` and, for the last of a one-way list, `arrived`. False without goals.
bool advanceGoal(HumanContext& context, int human);
/// As SetGoal: in the first tick of the person's own tree the goals of the scenario make way;
/// later goals are appended unless that point is in the list. Radius = the person's.
void addGoal(HumanContext& context, int human, sim2d::GoalItem goal);

/// Goals and group as they are now.
SavedPerson savePerson(HumanContext& context, int human);
/// The person has not entered the world anew since; otherwise nothing is to be given back.
bool isStillThere(const HumanContext& context, const SavedPerson& saved);
void restoreGoals(HumanContext& context, const SavedPerson& saved);
/// Tells the change by the event `group`.
void setGroup(HumanContext& context, int human, int group);

}  // namespace bt

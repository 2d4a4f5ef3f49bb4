#pragma once

#include <optional>
#include <vector>

#include "bt/human/Ports.h"

/// Goals and groups of people, as nodes change them.
namespace bt {

/// A goal counts as reached this far outside its radius [m].
constexpr double kGoalTolerance = 0.1;

/// The front goal is within its radius + 0.1 m; false without goals.
bool isGoalReached(HumanContext& context, Person human);
/// The front goal goes to the end, or away on a one-way list. One that was reached is told by the
/// events `goal` and, for the last of a one-way list, `arrived`. False without goals.
bool advanceGoal(HumanContext& context, Person human);
/// As SetGoal: in the first tick of the person's own tree the goals of the scenario make way;
/// later goals are appended unless that point is in the list. Radius = the person's.
void addGoal(HumanContext& context, Person human, sim2d::GoalItem goal);

/// Goals and group as they are now.
SavedPerson savePerson(HumanContext& context, int human);
/// The person has not entered the world anew since; otherwise nothing is to be given back.
bool isStillThere(const HumanContext& context, const SavedPerson& saved);
void restoreGoals(HumanContext& context, const SavedPerson& saved);
/// Restores the goals of all in the node's notes, and drops those.
void restoreAllGoals(LeafContext& leaf);
/// Tells the change by the event `group`.
void setGroup(HumanContext& context, Person human, int group);

/// The main person of port 0 and the others, in order, nobody twice. Nothing when somebody does not
/// exist or is not in the world (the node fails) or the list is no list (the tree is faulty).
using Members = std::vector<int>;
template <>
std::optional<Members> argument(LeafContext& leaf, int othersPort);

/// Places on a circle of 0.5 m + 0.2 m for each member after the first, evenly spread from the
/// direction in which the first member looks; the closest pairs of person and place first.
std::vector<Spot> circleSpots(const sim2d::WorldView& view, const Members& members,
                              const base::Vec2& centre);

}  // namespace bt

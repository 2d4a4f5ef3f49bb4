#pragma once

#include <optional>
#include <vector>

#include "bt/human/HumanContext.h"

/// Functions by which nodes change goals and groups of people.
namespace bt {

/// Tolerance added to a goal's radius [m].
constexpr double kGoalTolerance = 0.1;

/// Whether the front goal is within its radius + kGoalTolerance; false without goals.
bool isGoalReached(HumanContext& context, AgentIndex human);
/// Moves the front goal to the end of a cyclic list, or removes it from a one-way list. If the goal
/// was reached, emits the events `goal` and, for the last goal of a one-way list, `arrived`.
/// Returns false without goals.
bool advanceGoal(HumanContext& context, AgentIndex human);
/// Implements SetGoal. In the first tick of the person's own tree the new goals replace those of
/// the scenario; later goals are appended unless the list contains that point. The radius is the
/// person's.
void addGoal(HumanContext& context, AgentIndex human, sim2d::GoalItem goal);

/// The current goals and group.
SavedAgent saveAgent(HumanContext& context, int human);
/// Whether the person has not re-entered the world since; otherwise nothing is restored.
bool isStillThere(const HumanContext& context, const SavedAgent& saved);
void restoreGoals(HumanContext& context, const SavedAgent& saved);
/// Restores the goals of all people saved by the node and drops the saved data.
void restoreAllGoals(LeafContext& leaf);
/// Sets the group and emits the event `group` on a change.
void setGroup(HumanContext& context, AgentIndex human, int group);

/// The main person (port 0) and the others, in order, without duplicates. Empty if a person does
/// not exist or is absent (the node fails) or if the list is malformed (the tree is faulty).
using Members = std::vector<int>;
template <>
std::optional<Members> argument(LeafContext& leaf, int othersPort);

/// Positions on a circle of radius 0.5 m + 0.2 m for each member after the first, evenly spaced,
/// starting in the direction in which the first member looks. The closest pairs of person and
/// position are assigned first.
std::vector<FormationSpot> assignCirclePositions(const sim2d::WorldView& view,
                                                 const Members& members, const base::Vec2& centre);

}  // namespace bt

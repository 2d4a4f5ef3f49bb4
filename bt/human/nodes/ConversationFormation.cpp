#include "bt/human/Goals.h"
#include "bt/human/Motions.h"

namespace bt {

namespace {

constexpr double kSpotRadius = 0.1;        // [m]
constexpr double kFacingTolerance = 0.01;  // [rad]

struct Memory {
  std::int64_t startStep;  // start of the conversation
  bool isTalking;          // all members were in place in the last step
  double duration;         // [s]
};

NodeStatus start(LeafContext& leaf, const Members& members, const sim2d::GoalItem& place,
                 double duration) {
  HumanContext& context = humanOf(leaf);
  GroupNodeState& groupNodeState = context.groupNodeState(leaf);
  groupNodeState.centre = place.position;
  groupNodeState.spots = assignCirclePositions(context.view(), members, place.position);
  Memory& memory = leaf.memory<Memory>();
  memory.duration = duration;
  if (!context.hasQuirk(15)) {
    memory.isTalking = false;
  }
  groupNodeState.saved.clear();
  for (const FormationSpot& spot : groupNodeState.spots) {
    context.setActive(spot.human);
    if (context.hasQuirk(14)) {
      groupNodeState.saved.push_back(saveAgent(context, spot.human));
      context.control(spot.human).goals.push_back({0, spot.position, kSpotRadius});
    }
  }
  return NodeStatus::Running;
}

/// Q-14: the spot is appended to the member's goals, and the front goal is walked to.
std::optional<FormationSpot> spotInList(HumanContext& context, int human) {
  const std::vector<sim2d::GoalItem>& goals = context.control(human).goals;
  return goals.empty() ? std::nullopt
                       : std::optional<FormationSpot>({human, goals.front().position});
}

/// One step of one member; returns whether they are in place and face the centre.
bool moveMember(HumanContext& context, const FormationSpot& spot, const base::Vec2& centre) {
  const base::Vec2 position = context.view().pose(spot.human).position;
  if ((spot.position - position).norm() > kSpotRadius) {
    sim2d::Intent intent = walkTo(context, spot.human, {0, spot.position, kSpotRadius});
    intent.targetIsGoal = context.hasQuirk(14);
    intent.active = true;
    context.move(spot.human, intent, MotionOwner::Group);
    return false;
  }
  const MotionPlan plan = turnTo(context, spot.human, centre, kFacingTolerance);
  context.move(spot.human, plan.intent, MotionOwner::Group);
  return plan.isReached;
}

NodeStatus run(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const GroupNodeState& groupNodeState = context.groupNodeState(leaf);
  bool isReady = true;
  for (const FormationSpot& own : groupNodeState.spots) {
    if (!context.view().isPresent(own.human)) {
      continue;
    }
    const std::optional<FormationSpot> spot =
        context.hasQuirk(14) ? spotInList(context, own.human) : std::optional<FormationSpot>(own);
    isReady = spot && moveMember(context, *spot, groupNodeState.centre) && isReady;
  }
  Memory& memory = leaf.memory<Memory>();
  if (!isReady) {
    memory.isTalking = false;
    return NodeStatus::Running;
  }
  if (!memory.isTalking) {
    memory.isTalking = true;
    memory.startStep = leaf.step();
  }
  if (!leaf.hasElapsed(memory.startStep, memory.duration)) {
    return NodeStatus::Running;
  }
  restoreAllGoals(leaf);
  return NodeStatus::Success;
}

constexpr const char* kNodes = R"(
Action ConversationFormation|Groups|Gathers people in a circle around a goal, facing its centre, and keeps them there for the conversation. This node controls the members instead of their own trees.
main_agent_id int needed suggest {id}|Id of the person who gathers the others.
goal_id int unless center_x center_y suggest 1|Id of the global goal that is the centre.
center_x metres|x of a point, if no goal_id is given.
center_y metres|y of a point, if no goal_id is given.
conversation_duration duration default 10.0|Duration after all members are in place.
non_main_agent_ids time_step
)";

}  // namespace

void addConversationFormation(NodeLibrary& to) {
  to.addStateful<Memory>(*humanManifests(kNodes).find("ConversationFormation"),
                         {withPorts<start, 5, 1, 4>, run, restoreAllGoals});
}

}  // namespace bt

#include "bt/human/Goals.h"
#include "bt/human/Motions.h"

namespace bt {

namespace {

constexpr double kSpotRadius = 0.1;        // [m]
constexpr double kFacingTolerance = 0.01;  // [rad]

struct Memory {
  std::int64_t startStep;  // of the conversation
  bool isTalking;          // everybody was in place in the last step
  double duration;         // [s]
};

NodeStatus start(LeafContext& leaf, const Members& members, const sim2d::GoalItem& place,
                 double duration) {
  HumanContext& context = humanOf(leaf);
  Notes& notes = context.notes(leaf);
  notes.centre = place.position;
  notes.spots = circleSpots(context.view(), members, place.position);
  Memory& memory = leaf.memory<Memory>();
  memory.duration = duration;
  if (!context.isOriginal(15)) {
    memory.isTalking = false;
  }
  notes.saved.clear();
  for (const Spot& spot : notes.spots) {
    context.setActive(spot.human);
    if (context.isOriginal(14)) {
      notes.saved.push_back(savePerson(context, spot.human));
      context.control(spot.human).goals.push_back({0, spot.position, kSpotRadius});
    }
  }
  return NodeStatus::Running;
}

/// Q-14: the spot waits behind the member's other goals; the front one is walked to.
std::optional<Spot> spotInList(HumanContext& context, int human) {
  const std::vector<sim2d::GoalItem>& goals = context.control(human).goals;
  return goals.empty() ? std::nullopt : std::optional<Spot>({human, goals.front().position});
}

/// One step of one member; whether they stand in place and look to the centre.
bool moveMember(HumanContext& context, const Spot& spot, const base::Vec2& centre) {
  const base::Vec2 position = context.view().pose(spot.human).position;
  if ((spot.position - position).norm() > kSpotRadius) {
    sim2d::Intent intent = walkTo(context, spot.human, {0, spot.position, kSpotRadius});
    intent.targetIsGoal = context.isOriginal(14);
    intent.active = true;
    context.move(spot.human, intent, Mover::Group);
    return false;
  }
  const Plan plan = turnTo(context, spot.human, centre, kFacingTolerance);
  context.move(spot.human, plan.intent, Mover::Group);
  return plan.isThere;
}

NodeStatus run(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const Notes& notes = context.notes(leaf);
  bool isReady = true;
  for (const Spot& own : notes.spots) {
    if (!context.view().isPresent(own.human)) {
      continue;
    }
    const std::optional<Spot> spot =
        context.isOriginal(14) ? spotInList(context, own.human) : std::optional<Spot>(own);
    isReady = spot && moveMember(context, *spot, notes.centre) && isReady;
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
Action ConversationFormation|Groups|Brings people together in a circle around a goal, facing its centre, and keeps them there for the conversation. The members obey this node, not their own trees.
main_agent_id int needed suggest {id}|Id of the person who gathers the others.
goal_id int unless center_x center_y suggest 1|Id of the global goal that is the centre.
center_x metres|x of a point, when no goal_id is given.
center_y metres|y of a point, when no goal_id is given.
conversation_duration duration default 10.0|Time together once all are in place.
non_main_agent_ids time_step
)";

}  // namespace

void addConversationFormation(NodeLibrary& to) {
  to.addStateful<Memory>(*humanManifests(kNodes).find("ConversationFormation"),
                         {withPorts<start, 5, 1, 4>, run, restoreAllGoals});
}

}  // namespace bt

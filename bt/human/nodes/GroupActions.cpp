#include "bt/human/Goals.h"
#include "bt/human/Motions.h"

namespace bt {

namespace {

struct Memory {
  std::int64_t startStep;
  int main;
  double duration;  // [s]
};

NodeStatus start(LeafContext& leaf, const Members& members, double duration) {
  HumanContext& context = humanOf(leaf);
  const int main = members.front();
  GroupNodeState& groupNodeState = context.groupNodeState(leaf);
  groupNodeState.saved.clear();
  for (const int member : members) {
    groupNodeState.saved.push_back(saveAgent(context, member));
    setGroup(context, member, context.idOf(main));
    if (member != main) {
      context.control(member).goals = context.control(main).goals;
    }
  }
  context.setActive(main);
  return begin(leaf, Memory{leaf.step(), main, duration});
}

void disband(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const int main = leaf.memory<Memory>().main;
  for (const SavedAgent& saved : context.groupNodeState(leaf).saved) {
    if (!isStillThere(context, saved)) {
      continue;
    }
    setGroup(context, saved.human, context.hasQuirk(17) ? -1 : saved.group);
    if (saved.human != main) {
      restoreGoals(context, saved);
    }
  }
  context.dropGroupNodeState(leaf);
}

NodeStatus run(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const Memory& memory = leaf.memory<Memory>();
  if (!context.view().isPresent(memory.main)) {
    disband(leaf);
    return NodeStatus::Failure;
  }
  sim2d::Intent intent = regularWalk(context, memory.main);
  intent.active = true;
  context.move(memory.main, intent, MotionOwner::Group);
  if (isGoalReached(context, memory.main)) {
    advanceGoal(context, memory.main);
  }
  const NodeStatus status = successAfter(leaf, memory.startStep, memory.duration);
  if (status == NodeStatus::Success) {
    disband(leaf);
  }
  return status;
}

constexpr const char* kNodes = R"(
Action SetGroupId|Groups|Puts the person into a group.
agent_id
group_id int needed suggest 5|Number of the group; -1: no group.
Action SetGroupWalk|Groups|Forms a group with the goals of the main person, whom this node controls; the others follow their own trees. Groups and goals are restored at the end.
main_agent_id int needed suggest {id}|Id of the person who leads.
non_main_agent_ids time_step duration
)";

}  // namespace

void addGroupActions(NodeLibrary& to) {
  const NodeCatalogue nodes = humanManifests(kNodes);
  to.addAction(*nodes.find("SetGroupId"), withPorts<setGroup, 0, 1>);
  to.addStateful<Memory>(*nodes.find("SetGroupWalk"), {withPorts<start, 1, 3>, run, disband});
}

}  // namespace bt

#include "bt/human/Goals.h"
#include "bt/human/HumanContext.h"
#include "bt/human/Motions.h"
#include "bt/human/Ports.h"

namespace bt {

namespace {

NodeStatus setGroupId(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const int group = leaf.require<int>(1);
  if (!human) {
    return NodeStatus::Failure;
  }
  setGroup(context, *human, group);
  return NodeStatus::Success;
}

struct Memory {
  std::int64_t startStep;
  int main;
  double duration;  // [s]
};

NodeStatus start(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<std::vector<int>> members = membersOf(leaf, 0, 1);
  const double duration = leaf.require<double>(3);
  if (!members) {
    return NodeStatus::Failure;
  }
  const int main = members->front();
  leaf.memory<Memory>() = {leaf.step(), main, duration};
  Notes& notes = context.notes(leaf);
  notes.saved.clear();
  for (const int member : *members) {
    notes.saved.push_back(savePerson(context, member));
    setGroup(context, member, context.idOf(main));
    if (member != main) {
      context.control(member).goals = context.control(main).goals;
    }
  }
  context.setActive(main);
  return NodeStatus::Running;
}

void disband(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const int main = leaf.memory<Memory>().main;
  for (const SavedPerson& saved : context.notes(leaf).saved) {
    if (!isStillThere(context, saved)) {
      continue;
    }
    setGroup(context, saved.human, context.isOriginal(17) ? -1 : saved.group);
    if (saved.human != main) {
      restoreGoals(context, saved);
    }
  }
  context.dropNotes(leaf);
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
  context.move(memory.main, intent, Mover::Group);
  if (isGoalReached(context, memory.main)) {
    advanceGoal(context, memory.main);
  }
  const NodeStatus status = byDuration(leaf, memory.startStep, memory.duration);
  if (status == NodeStatus::Success) {
    disband(leaf);
  }
  return status;
}

}  // namespace

void addGroupActions(NodeLibrary& to) {
  to.addAction(humanNode("SetGroupId", "Groups", "Puts the person into a group.",
                         {port::agent(), PortSpec("group_id", PortType::Int, "",
                                                  "Number of the group, -1 = alone.")
                                             .needed()
                                             .suggest("5")}),
               setGroupId);
  to.addStateful<Memory>(
      humanNode("SetGroupWalk", "Groups",
                "Makes people a group with the goals of the main person, who is led by this node; "
                "the others walk by their own trees. Groups and goals come back at the end.",
                {port::person("main_agent_id", "Id of the person who leads."), port::others(),
                 port::timeStep(), port::lasting()}),
      {start, run, disband});
}

}  // namespace bt

#include "bt/human/HumanContext.h"
#include "bt/human/Motions.h"
#include "bt/human/Perception.h"
#include "bt/human/Ports.h"

/// Nodes about the people around; but for FindNearestAgent the original does not have them.
namespace bt {

namespace {

constexpr double kBeyondSafe = kEscapeRadius + 0.2;  // so that the safe distance is passed [m]

NodeStatus isCrowded(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const double distance = leaf.require<double>(1);
  const int count = leaf.require<int>(2);
  if (!human) {
    return NodeStatus::Failure;
  }
  std::vector<int> found;
  context.view().near(*human, distance, found);
  return successIf(static_cast<int>(found.size()) >= count);
}

NodeStatus isGroupFormed(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const double distance = leaf.require<double>(1);
  const int group = human ? context.groupOf(*human) : -1;
  if (group < 0) {
    return NodeStatus::Failure;
  }
  const sim2d::WorldView& view = context.view();
  int members = 0;
  for (int other = 0; other < view.humanCount(); ++other) {
    if (other == *human || !view.isPresent(other) || context.groupOf(other) != group) {
      continue;
    }
    if (personDistance(view, *human, other) > distance) {
      return NodeStatus::Failure;
    }
    ++members;
  }
  return successIf(members > 0);
}

struct Memory {
  std::int64_t startStep;
  int human;
  int target;
  double distance;  // [m]
  double speed;     // [m/s]
  double duration;  // [s]
};

/// Ports: 0 agent, 1 target, 2 distance, 3 duration, 4 speed where there is one.
NodeStatus start(LeafContext& leaf, std::optional<int> target, bool hasSpeed) {
  const std::optional<int> human = humanOf(leaf).person(leaf, 0);
  const double distance = leaf.require<double>(2);
  const double duration = leaf.require<double>(3);
  const double speed = hasSpeed ? leaf.require<double>(4) : 0.0;
  if (!human || !target) {
    return NodeStatus::Failure;
  }
  leaf.memory<Memory>() = {leaf.step(), *human, *target, distance, speed, duration};
  return NodeStatus::Running;
}

NodeStatus startWait(LeafContext& leaf) {
  return start(leaf, humanOf(leaf).knownPerson(leaf, 1), false);  // may be yet to come
}
NodeStatus startFlee(LeafContext& leaf) {
  return start(leaf, humanOf(leaf).person(leaf, 1), true);
}

NodeStatus runWait(LeafContext& leaf) {
  const sim2d::WorldView& view = humanOf(leaf).view();
  const Memory& memory = leaf.memory<Memory>();
  if (!view.isPresent(memory.human)) {
    return NodeStatus::Failure;
  }
  if (view.isPresent(memory.target) &&
      personDistance(view, memory.human, memory.target) <= memory.distance) {
    return NodeStatus::Success;
  }
  return memory.duration > 0.0 ? untilDuration(leaf, memory.startStep, memory.duration)
                               : NodeStatus::Running;
}

NodeStatus runFlee(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const Memory& memory = leaf.memory<Memory>();
  const sim2d::WorldView& view = context.view();
  if (!view.isPresent(memory.human)) {
    return NodeStatus::Failure;
  }
  if (!view.isPresent(memory.target) ||
      personDistance(view, memory.human, memory.target) >= memory.distance) {
    return NodeStatus::Success;
  }
  const sim2d::Intent away = avoid(context, memory.human, personTarget(view, memory.target),
                                   {memory.distance, memory.speed, kBeyondSafe});
  context.move(memory.human, away);
  return byDuration(leaf, memory.startStep, memory.duration);
}

NodeStatus findNearest(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const int nearest = human ? nearestPerson(context.view(), *human) : -1;
  if (nearest < 0) {
    return NodeStatus::Failure;
  }
  leaf.set(1, context.idOf(nearest));
  return NodeStatus::Success;
}

}  // namespace

void addCrowd(NodeLibrary& to) {
  to.addCondition(
      ownNode("IsCrowded", "Perception", "At least so many other people are near.",
              {port::agent(), port::length("distance", "Near means within this.").byDefault("2.0"),
               PortSpec("count", PortType::Int, "", "Number of other people.")
                   .byDefault("3")
                   .range(1, 1000)},
              NodeKind::Condition),
      isCrowded);
  to.addCondition(
      ownNode("IsAgentGroupFormed", "Groups",
              "All other members of the person's group are near; fails without a group.",
              {port::agent(), port::length("distance", "Near means within this.").byDefault("2.0")},
              NodeKind::Condition),
      isGroupFormed);
  to.addStateful<Memory>(
      ownNode("WaitForAgent", "People",
              "Stands until another person is near, also one who is yet to come.",
              {port::agent(), port::person("target_agent_id", "Id of the person to wait for.", "2"),
               port::length("distance", "Near means within this.").byDefault("2.0"),
               port::openDuration("duration", "Fails after this time; 0 = waits on.")
                   .byDefault("0.0")}),
      {startWait, runWait, nullptr});
  to.addStateful<Memory>(
      ownNode(
          "FleeFrom", "People", "Walks away from another person until far enough.",
          {port::agent(), port::person("target_agent_id", "Id of the person to flee from.", "2"),
           port::length("safe_distance", "Far enough.").byDefault("5.0"),
           port::lasting().suggest("0.0"),
           port::speed("speed", "Speed of the flight.").byDefault("1.5")}),
      {startFlee, runFlee, nullptr});
  to.addAction(humanNode("FindNearestAgent", "People",
                         "Writes the id of the nearest other person; fails when there is nobody.",
                         {port::agent(), PortSpec("target_agent_id", PortType::Int, "",
                                                  "Takes the id of the nearest person.")
                                             .directed(PortDirection::Output)
                                             .suggest("{target_agent_id}")}),
               findNearest);
}

}  // namespace bt

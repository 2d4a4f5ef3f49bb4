#include "bt/human/Leaves.h"
#include "bt/human/Perception.h"
#include "bt/human/Ports.h"

namespace bt {

namespace {

struct Memory {
  std::int64_t startStep;
  int human;
  int target;       // -1 = anyone
  double distance;  // [m]
  double angle;     // [rad]
  double duration;  // [s]
};

/// Ports: 0 agent, 1 time step, 2 distance, 3 angle, 4 duration, 5 the other person.
NodeStatus begin(LeafContext& leaf, std::optional<int> target) {
  const std::optional<int> human = humanOf(leaf).person(leaf, 0);
  const double distance = leaf.require<double>(2);
  const double angle = leaf.require<double>(3);
  const double duration = leaf.require<double>(4);
  if (!human || !target) {
    return NodeStatus::Failure;
  }
  leaf.memory<Memory>() = {leaf.step(), *human, *target, distance, angle, duration};
  return NodeStatus::Running;
}

NodeStatus startAnyone(LeafContext& leaf) {
  return begin(leaf, -1);
}
NodeStatus startOne(LeafContext& leaf) {
  return begin(leaf, humanOf(leaf).person(leaf, 5));
}

NodeStatus runAnyone(LeafContext& leaf) {
  const sim2d::WorldView& view = humanOf(leaf).view();
  const Memory& memory = leaf.memory<Memory>();
  std::vector<int> candidates;
  view.near(memory.human, memory.distance, candidates);
  for (const int other : candidates) {
    if (isLookingAt(view, other, memory.human, memory.distance, memory.angle)) {
      leaf.set(5, view.constants(other).id);
      return NodeStatus::Success;
    }
  }
  return untilDuration(leaf, memory.startStep, memory.duration);
}

NodeStatus runOne(LeafContext& leaf) {
  const sim2d::WorldView& view = humanOf(leaf).view();
  const Memory& memory = leaf.memory<Memory>();
  if (view.isPresent(memory.target) &&
      isLookingAt(view, memory.target, memory.human, memory.distance, memory.angle)) {
    return NodeStatus::Success;
  }
  return untilDuration(leaf, memory.startStep, memory.duration);
}

NodeManifest condition(const char* id, const char* description, const PortSpec& other) {
  return humanNode(
      id, "Looking", description,
      {port::agent(), port::timeStep(),
       port::length("distance_threshold", "The other person is at most so far away.")
           .byDefault("5.0"),
       port::angle("angle_threshold", "The other person's heading is as near to the line as this.")
           .byDefault("0.2"),
       port::duration("duration", "Waits so long before it fails.").byDefault("5.0"), other},
      NodeKind::Condition);
}

}  // namespace

void addLookingAtMe(NodeLibrary& to) {
  to.addStateful<Memory>(
      condition("IsAnyoneLookingAtMe",
                "Waits until somebody looks at the person; of several the nearest.",
                Port("observer_id", PortType::Int, "", "Takes the id of who looks.")
                    .output()
                    .suggest("{observer_id}")),
      {startAnyone, runAnyone, nullptr});
  to.addStateful<Memory>(
      condition("IsLookingAtMe", "Waits until a certain person looks at this one.",
                port::person("target_id", "Id of the person who should look.", "2")),
      {startOne, runOne, nullptr});
}

}  // namespace bt

#include "bt/human/Leaves.h"
#include "bt/human/Motions.h"
#include "bt/human/Ports.h"

namespace bt {

namespace {

struct Memory {
  int human;
  int target;        // person, or none
  double x, y;       // the point
  double tolerance;  // [rad]
};

NodeStatus begin(LeafContext& leaf, const Memory& memory) {
  leaf.memory<Memory>() = memory;
  humanOf(leaf).setActive(memory.human);
  return NodeStatus::Running;
}

NodeStatus startAtPoint(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const std::optional<sim2d::GoalItem> place = context.place(leaf, 1);
  const double tolerance = leaf.require<double>(4);
  if (!human || !place) {
    return NodeStatus::Failure;
  }
  return begin(leaf, {*human, -1, place->position.x(), place->position.y(), tolerance});
}

NodeStatus runAtPoint(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const Memory& memory = leaf.memory<Memory>();
  if (!context.view().isPresent(memory.human)) {
    return NodeStatus::Failure;
  }
  const base::Vec2 point(memory.x, memory.y);
  const Plan plan = turnTo(context, memory.human, point, memory.tolerance);
  context.move(memory.human, plan.intent);
  return plan.isThere ? NodeStatus::Success : NodeStatus::Running;
}

NodeStatus startAtPerson(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const std::optional<int> target = context.person(leaf, 1);
  const double tolerance = leaf.require<double>(2);
  if (!human || !target) {
    return NodeStatus::Failure;
  }
  return begin(leaf, {*human, *target, 0.0, 0.0, tolerance});
}

NodeStatus look(LeafContext& leaf, const base::Vec2& point) {
  HumanContext& context = humanOf(leaf);
  const Memory& memory = leaf.memory<Memory>();
  const Plan plan = lookAt(context, memory.human, point, memory.tolerance);
  context.move(memory.human, plan.intent);
  return plan.isThere ? NodeStatus::Success : NodeStatus::Running;
}

NodeStatus runAtPerson(LeafContext& leaf) {
  const sim2d::WorldView& view = humanOf(leaf).view();
  const Memory& memory = leaf.memory<Memory>();
  if (!view.isPresent(memory.target) || !view.isPresent(memory.human)) {
    return NodeStatus::Failure;
  }
  return look(leaf, view.pose(memory.target).position);
}

NodeStatus startAtRobot(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const double tolerance = leaf.require<double>(1);
  if (!human || context.view().nearestRobot(*human) < 0) {
    return NodeStatus::Failure;
  }
  return begin(leaf, {*human, -1, 0.0, 0.0, tolerance});
}

NodeStatus runAtRobot(LeafContext& leaf) {
  const sim2d::WorldView& view = humanOf(leaf).view();
  const int human = leaf.memory<Memory>().human;
  const std::optional<Target> robot = nearestRobotOf(view, human);
  return robot && view.isPresent(human) ? look(leaf, robot->pose.position) : NodeStatus::Failure;
}

Port tolerance() {
  return port::angle("yaw_tolerance", "Ends when the heading is as near as this.")
      .byDefault("0.01");
}

}  // namespace

void addLookAt(NodeLibrary& to) {
  to.addStateful<Memory>(humanNode("LookAtPoint", "Looking", "Turns on the spot to a global goal.",
                                   {port::agent(), port::goal("Id of the global goal."),
                                    port::oldX(), port::oldY(), tolerance()}),
                         {startAtPoint, runAtPoint, nullptr});
  to.addStateful<Memory>(
      humanNode("LookAtAgent", "Looking", "Turns on the spot to another person.",
                {port::person("observer_id", "Id of the person who turns."),
                 port::person("target_id", "Id of the person to look at.", "2"), tolerance()}),
      {startAtPerson, runAtPerson, nullptr});
  to.addStateful<Memory>(humanNode("LookAtRobot", "Looking", "Turns on the spot to the robot.",
                                   {port::agent(), tolerance()}),
                         {startAtRobot, runAtRobot, nullptr});
}

}  // namespace bt

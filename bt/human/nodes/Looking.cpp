#include "bt/human/HumanContext.h"
#include "bt/human/Motions.h"
#include "bt/human/Perception.h"
#include "bt/human/Ports.h"

/// Seeing the robot, turning to somebody, being looked at.
namespace bt {

namespace {

NodeStatus isVisible(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const double distance = leaf.require<double>(1);
  return successIf(human && isRobotVisible(context.view(), *human, distance));
}

struct Look {
  int human;
  int target;        // person, or none
  double x, y;       // the point
  double tolerance;  // [rad]
};

NodeStatus begin(LeafContext& leaf, const Look& memory) {
  leaf.memory<Look>() = memory;
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
  const Look& memory = leaf.memory<Look>();
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
  const Look& memory = leaf.memory<Look>();
  const Plan plan = lookAt(context, memory.human, point, memory.tolerance);
  context.move(memory.human, plan.intent);
  return plan.isThere ? NodeStatus::Success : NodeStatus::Running;
}

NodeStatus runAtPerson(LeafContext& leaf) {
  const sim2d::WorldView& view = humanOf(leaf).view();
  const Look& memory = leaf.memory<Look>();
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
  const int human = leaf.memory<Look>().human;
  const std::optional<Target> robot = nearestRobotOf(view, human);
  return robot && view.isPresent(human) ? look(leaf, robot->pose.position) : NodeStatus::Failure;
}

PortSpec tolerance() {
  return port::angle("yaw_tolerance", "Ends when the heading is as near as this.")
      .byDefault("0.01");
}

struct Watch {
  std::int64_t startStep;
  int human;
  int target;       // -1 = anyone
  double distance;  // [m]
  double angle;     // [rad]
  double duration;  // [s]
};

/// Ports: 0 agent, 1 time step, 2 distance, 3 angle, 4 duration, 5 the other person.
NodeStatus beginWatch(LeafContext& leaf, std::optional<int> target) {
  const std::optional<int> human = humanOf(leaf).person(leaf, 0);
  const double distance = leaf.require<double>(2);
  const double angle = leaf.require<double>(3);
  const double duration = leaf.require<double>(4);
  if (!human || !target) {
    return NodeStatus::Failure;
  }
  leaf.memory<Watch>() = {leaf.step(), *human, *target, distance, angle, duration};
  return NodeStatus::Running;
}

NodeStatus startAnyone(LeafContext& leaf) {
  return beginWatch(leaf, -1);
}
NodeStatus startOne(LeafContext& leaf) {
  return beginWatch(leaf, humanOf(leaf).person(leaf, 5));
}

NodeStatus runAnyone(LeafContext& leaf) {
  const sim2d::WorldView& view = humanOf(leaf).view();
  const Watch& memory = leaf.memory<Watch>();
  std::vector<int> candidates;
  view.near(memory.human, memory.distance, candidates);
  for (const int other : candidates) {
    if (isPersonVisible(view, other, memory.human, memory.distance, memory.angle)) {
      leaf.set(5, view.constants(other).id);
      return NodeStatus::Success;
    }
  }
  return untilDuration(leaf, memory.startStep, memory.duration);
}

NodeStatus runOne(LeafContext& leaf) {
  const sim2d::WorldView& view = humanOf(leaf).view();
  const Watch& memory = leaf.memory<Watch>();
  if (view.isPresent(memory.target) &&
      isPersonVisible(view, memory.target, memory.human, memory.distance, memory.angle)) {
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

void addLooking(NodeLibrary& to) {
  to.addCondition(
      humanNode("IsRobotVisible", "Perception",
                "The robot is near enough, not behind the back (100 degrees to each side) and no "
                "wall hides it.",
                {port::agent(),
                 port::length("distance", "The robot is seen up to here.").needed().suggest("5.0")},
                NodeKind::Condition),
      isVisible);
  to.addStateful<Look>(humanNode("LookAtPoint", "Looking", "Turns on the spot to a global goal.",
                                 {port::agent(), port::goal("Id of the global goal."), port::oldX(),
                                  port::oldY(), tolerance()}),
                       {startAtPoint, runAtPoint, nullptr});
  to.addStateful<Look>(
      humanNode("LookAtAgent", "Looking", "Turns on the spot to another person.",
                {port::person("observer_id", "Id of the person who turns."),
                 port::person("target_id", "Id of the person to look at.", "2"), tolerance()}),
      {startAtPerson, runAtPerson, nullptr});
  to.addStateful<Look>(humanNode("LookAtRobot", "Looking", "Turns on the spot to the robot.",
                                 {port::agent(), tolerance()}),
                       {startAtRobot, runAtRobot, nullptr});
  to.addStateful<Watch>(
      condition("IsAnyoneLookingAtMe",
                "Waits until somebody looks at the person; of several the nearest.",
                PortSpec("observer_id", PortType::Int, "", "Takes the id of who looks.")
                    .directed(PortDirection::Output)
                    .suggest("{observer_id}")),
      {startAnyone, runAnyone, nullptr});
  to.addStateful<Watch>(
      condition("IsLookingAtMe", "Waits until a certain person looks at this one.",
                port::person("target_id", "Id of the person who should look.", "2")),
      {startOne, runOne, nullptr});
}

}  // namespace bt

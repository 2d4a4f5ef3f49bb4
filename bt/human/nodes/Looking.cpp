#include "bt/human/Motions.h"

/// Nodes for seeing the robot, looking at another person and being looked at.
namespace bt {

using base::Vec2;

namespace {

struct Look {
  int human;
  int target;        // person; -1: none
  double x, y;       // point
  double tolerance;  // [rad]
};

NodeStatus beginLook(LeafContext& leaf, const Look& memory) {
  humanOf(leaf).setActive(memory.human);
  return begin(leaf, memory);
}

NodeStatus startAtPoint(LeafContext& leaf, AgentIndex human, const sim2d::GoalItem& place,
                        double tolerance) {
  return beginLook(leaf, {human, -1, place.position.x(), place.position.y(), tolerance});
}

NodeStatus startAtPerson(LeafContext& leaf, AgentIndex human, AgentIndex target, double tolerance) {
  return beginLook(leaf, {human, target, 0.0, 0.0, tolerance});
}

NodeStatus startAtRobot(LeafContext& leaf, AgentIndex human, double tolerance) {
  return humanOf(leaf).view().nearestRobot(human) < 0
             ? NodeStatus::Failure
             : beginLook(leaf, {human, -1, 0.0, 0.0, tolerance});
}

NodeStatus turn(HumanContext& context, int human, const MotionPlan& plan) {
  context.move(human, plan.intent);
  return plan.isReached ? NodeStatus::Success : NodeStatus::Running;
}

NodeStatus lookAtPoint(LeafContext&, HumanContext& context, Look& memory) {
  const Vec2 point(memory.x, memory.y);
  return turn(context, memory.human, turnTo(context, memory.human, point, memory.tolerance));
}

NodeStatus lookAtPerson(LeafContext&, HumanContext& context, Look& memory) {
  if (!context.view().isPresent(memory.target)) {
    return NodeStatus::Failure;
  }
  const Vec2 point = context.view().pose(memory.target).position;
  return turn(context, memory.human, lookAt(context, memory.human, point, memory.tolerance));
}

NodeStatus lookAtRobot(LeafContext&, HumanContext& context, Look& memory) {
  const std::optional<Target> robot = nearestRobotOf(context.view(), memory.human);
  if (!robot) {
    return NodeStatus::Failure;
  }
  const Vec2 point = robot->pose.position;
  return turn(context, memory.human, lookAt(context, memory.human, point, memory.tolerance));
}

struct Watch {
  std::int64_t startStep;
  int human;
  int target;       // -1: anyone
  double distance;  // [m]
  double angle;     // [rad]
  double duration;  // [s]
};

NodeStatus startWatch(LeafContext& leaf, AgentIndex target, AgentIndex human, double distance,
                      double angle, double duration) {
  return begin(leaf, Watch{leaf.step(), human, target, distance, angle, duration});
}

NodeStatus watchAnyone(LeafContext& leaf) {
  const sim2d::WorldView& view = humanOf(leaf).view();
  const Watch& memory = leaf.memory<Watch>();
  std::vector<int> candidates;
  view.near(memory.human, memory.distance, candidates);
  for (const int other : candidates) {
    if (isAgentVisible(view, other, memory.human, memory.distance, memory.angle)) {
      leaf.set(5, view.constants(other).id);
      return NodeStatus::Success;
    }
  }
  return failureAfter(leaf, memory.startStep, memory.duration);
}

NodeStatus watchOne(LeafContext& leaf) {
  const sim2d::WorldView& view = humanOf(leaf).view();
  const Watch& memory = leaf.memory<Watch>();
  if (view.isPresent(memory.target) &&
      isAgentVisible(view, memory.target, memory.human, memory.distance, memory.angle)) {
    return NodeStatus::Success;
  }
  return failureAfter(leaf, memory.startStep, memory.duration);
}

constexpr const char* kNodes = R"(
Condition IsRobotVisible|Perception|The robot is within the distance and within 100 degrees to each side, and no wall hides it.
agent_id
distance length needed suggest 5.0|Maximum distance at which the robot is visible.
Action LookAtPoint|Looking|Turns in place to a global goal.
agent_id goal_id target_x target_y
yaw_tolerance angle default 0.01|Heading error at which the node ends.
Action LookAtAgent|Looking|Turns in place to another person.
observer_id int needed suggest {id}|Id of the person who turns.
target_id int needed suggest 2|Id of the person to look at.
yaw_tolerance
Action LookAtRobot|Looking|Turns in place to the robot.
agent_id yaw_tolerance
Condition IsAnyoneLookingAtMe|Looking|Waits until another person looks at the person; selects the nearest of several.
agent_id time_step
distance_threshold length default 5.0|Maximum distance of the other person.
angle_threshold angle default 0.2|Maximum angle between the other person's heading and the line to the person.
duration duration default 5.0|Maximum wait; then the node fails.
observer_id int output suggest {observer_id}|Id of the person who looks.
Condition IsLookingAtMe|Looking|Waits until a certain person looks at this one.
agent_id time_step distance_threshold angle_threshold duration
target_id int needed suggest 2|Id of the person who should look.
)";

}  // namespace

void addLooking(NodeLibrary& to) {
  to.add(humanManifests(kNodes),
         {{"IsRobotVisible", synchronous(withPorts<isRobotVisible, 0, 1>)},
          {"LookAtPoint",
           stateful<Look>({withPorts<startAtPoint, 0, 1, 4>, ifPresentThen<Look, lookAtPoint>})},
          {"LookAtAgent",
           stateful<Look>({withPorts<startAtPerson, 0, 1, 2>, ifPresentThen<Look, lookAtPerson>})},
          {"LookAtRobot",
           stateful<Look>({withPorts<startAtRobot, 0, 1>, ifPresentThen<Look, lookAtRobot>})},
          {"IsAnyoneLookingAtMe",
           stateful<Watch>({withPorts<startWatch, kAnyAgent, 0, 2, 3, 4>, watchAnyone})},
          {"IsLookingAtMe", stateful<Watch>({withPorts<startWatch, 5, 0, 2, 3, 4>, watchOne})}});
}

}  // namespace bt

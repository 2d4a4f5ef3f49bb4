#include "bt/human/Motions.h"
#include "bt/human/Perception.h"
#include "bt/human/Ports.h"

/// Seeing the robot, turning to somebody, being looked at.
namespace bt {

using base::Vec2;

namespace {

struct Look {
  int human;
  int target;        // person, or none
  double x, y;       // the point
  double tolerance;  // [rad]
};

NodeStatus beginLook(LeafContext& leaf, const Look& memory) {
  humanOf(leaf).setActive(memory.human);
  return begin(leaf, memory);
}

NodeStatus startAtPoint(LeafContext& leaf, Person human, const sim2d::GoalItem& place,
                        double tolerance) {
  return beginLook(leaf, {human, -1, place.position.x(), place.position.y(), tolerance});
}

NodeStatus startAtPerson(LeafContext& leaf, Person human, Person target, double tolerance) {
  return beginLook(leaf, {human, target, 0.0, 0.0, tolerance});
}

NodeStatus startAtRobot(LeafContext& leaf, Person human, double tolerance) {
  return humanOf(leaf).view().nearestRobot(human) < 0
             ? NodeStatus::Failure
             : beginLook(leaf, {human, -1, 0.0, 0.0, tolerance});
}

NodeStatus turn(HumanContext& context, int human, const Plan& plan) {
  context.move(human, plan.intent);
  return plan.isThere ? NodeStatus::Success : NodeStatus::Running;
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
  int target;       // -1 = anyone
  double distance;  // [m]
  double angle;     // [rad]
  double duration;  // [s]
};

NodeStatus startWatch(LeafContext& leaf, Person target, Person human, double distance, double angle,
                      double duration) {
  return begin(leaf, Watch{leaf.step(), human, target, distance, angle, duration});
}

NodeStatus watchAnyone(LeafContext& leaf) {
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

NodeStatus watchOne(LeafContext& leaf) {
  const sim2d::WorldView& view = humanOf(leaf).view();
  const Watch& memory = leaf.memory<Watch>();
  if (view.isPresent(memory.target) &&
      isPersonVisible(view, memory.target, memory.human, memory.distance, memory.angle)) {
    return NodeStatus::Success;
  }
  return untilDuration(leaf, memory.startStep, memory.duration);
}

constexpr const char* kNodes = R"(
Condition IsRobotVisible|Perception|The robot is near enough, not behind the back (100 degrees to each side) and no wall hides it.
agent_id
distance length needed suggest 5.0|The robot is seen up to here.
Action LookAtPoint|Looking|Turns on the spot to a global goal.
agent_id goal_id target_x target_y
yaw_tolerance angle default 0.01|Ends when the heading is as near as this.
Action LookAtAgent|Looking|Turns on the spot to another person.
observer_id int needed suggest {id}|Id of the person who turns.
target_id int needed suggest 2|Id of the person to look at.
yaw_tolerance
Action LookAtRobot|Looking|Turns on the spot to the robot.
agent_id yaw_tolerance
Condition IsAnyoneLookingAtMe|Looking|Waits until somebody looks at the person; of several the nearest.
agent_id time_step
distance_threshold length default 5.0|The other person is at most so far away.
angle_threshold angle default 0.2|The other person's heading is as near to the line as this.
duration duration default 5.0|Waits so long before it fails.
observer_id int output suggest {observer_id}|Takes the id of who looks.
Condition IsLookingAtMe|Looking|Waits until a certain person looks at this one.
agent_id time_step distance_threshold angle_threshold duration
target_id int needed suggest 2|Id of the person who should look.
)";

}  // namespace

void addLooking(NodeLibrary& to) {
  const NodeCatalogue nodes = humanManifests(kNodes);
  to.addCondition(*nodes.find("IsRobotVisible"), withPorts<isRobotVisible, 0, 1>);
  to.addStateful<Look>(*nodes.find("LookAtPoint"),
                       {withPorts<startAtPoint, 0, 1, 4>, whilePresent<Look, lookAtPoint>});
  to.addStateful<Look>(*nodes.find("LookAtAgent"),
                       {withPorts<startAtPerson, 0, 1, 2>, whilePresent<Look, lookAtPerson>});
  to.addStateful<Look>(*nodes.find("LookAtRobot"),
                       {withPorts<startAtRobot, 0, 1>, whilePresent<Look, lookAtRobot>});
  to.addStateful<Watch>(*nodes.find("IsAnyoneLookingAtMe"),
                        {withPorts<startWatch, kAnybody, 0, 2, 3, 4>, watchAnyone});
  to.addStateful<Watch>(*nodes.find("IsLookingAtMe"),
                        {withPorts<startWatch, 5, 0, 2, 3, 4>, watchOne});
}

}  // namespace bt

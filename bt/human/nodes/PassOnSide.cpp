
#include "bt/human/HumanContext.h"
#include "bt/human/Motions.h"
#include "bt/human/Perception.h"
#include "bt/human/Ports.h"

namespace bt {

using base::Vec2;

namespace {

struct Memory {
  int human;
  double side;       // +1 = the person's left, -1 = right
  double distance;   // [m]
  double clearance;  // [m]
};

/// Where the person is going: to the front goal, without one straight on. Unit length.
Vec2 wayOf(HumanContext& context, int human) {
  const base::Pose2 pose = context.view().pose(human);
  const std::vector<sim2d::GoalItem>& goals = context.control(human).goals;
  if (!goals.empty()) {
    const Vec2 toGoal = goals.front().position - pose.position;
    const double length = toGoal.norm();
    if (length > 0.0) {
      return toGoal / length;
    }
  }
  return pose.direction();
}

bool isRobotAhead(HumanContext& context, const Memory& memory) {
  const std::optional<Target> robot = nearestRobotOf(context.view(), memory.human);
  if (!robot) {
    return false;
  }
  const Vec2 toRobot = robot->pose.position - context.view().pose(memory.human).position;
  return toRobot.norm() <= memory.distance && toRobot.dot(wayOf(context, memory.human)) > 0.0;
}

std::optional<double> sideOf(LeafContext& leaf) {
  const std::string_view side = leaf.require<std::string_view>(1);
  if (side == "left" || side == "right") {
    return side == "left" ? 1.0 : -1.0;
  }
  humanOf(leaf).warn(leaf, "tree.runs-on-no-side", {side});
  return std::nullopt;
}

NodeStatus start(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const std::optional<double> side = sideOf(leaf);
  const double distance = leaf.require<double>(2);
  const double clearance = leaf.require<double>(3);
  if (!human || !side) {
    return NodeStatus::Failure;
  }
  leaf.memory<Memory>() = {*human, *side, distance, clearance};
  if (!isRobotAhead(context, leaf.memory<Memory>())) {
    return NodeStatus::Failure;
  }
  context.setActive(*human);
  return NodeStatus::Running;
}

/// Beside the robot and a little past it, so that it falls behind on the way there.
Vec2 pointBeside(HumanContext& context, const Memory& memory, const Vec2& robot) {
  const Vec2 way = wayOf(context, memory.human);
  const Vec2 left = Vec2(-way.y(), way.x());
  return robot + memory.clearance * (memory.side * left + way);
}

NodeStatus run(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const Memory& memory = leaf.memory<Memory>();
  if (!context.view().isPresent(memory.human)) {
    return NodeStatus::Failure;
  }
  if (!isRobotAhead(context, memory)) {
    return NodeStatus::Success;
  }
  const Target robot = *nearestRobotOf(context.view(), memory.human);
  const Vec2 point = pointBeside(context, memory, robot.pose.position);
  sim2d::Intent intent = walkTo(context, memory.human, {0, point, 0.1});
  intent.active = true;
  context.move(memory.human, intent);
  return NodeStatus::Running;
}

}  // namespace

void addPassOnSide(NodeLibrary& to) {
  to.addStateful<Memory>(
      ownNode("PassOnSide", "Reactions",
              "Passes the robot ahead at the person's own left or right; fails when none is ahead.",
              {port::agent(),
               PortSpec("side", PortType::String, "", "left or right, as the person walks.")
                   .byDefault("right"),
               port::length("distance", "Begins within this distance.").byDefault("4.0"),
               port::length("clearance", "Distance beside the robot.").byDefault("1.0")}),
      {start, run, nullptr});
}

}  // namespace bt

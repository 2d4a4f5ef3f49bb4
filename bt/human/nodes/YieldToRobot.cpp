#include "bt/human/Motions.h"
#include "bt/human/Perception.h"
#include "bt/human/Ports.h"

namespace bt {

using base::Vec2;

namespace {

constexpr double kMoving = 0.05;  // [m/s]: a slower robot stands

struct Memory {
  std::int64_t startStep;
  std::int64_t waitStep;  // since then the robot has been standing; 0 = it moves
  int human;
  double distance;  // [m]
  double patience;  // [s]
};

enum class RobotWay { Away, Standing, Coming };

/// What the nearest robot does, seen from a person: farther than `distance` counts as away.
RobotWay wayOfRobot(const sim2d::WorldView& view, int human, double distance) {
  const int robot = view.nearestRobot(human);
  if (robot < 0 || robotDistance(view, human) > distance) {
    return RobotWay::Away;
  }
  const Vec2 velocity = view.robotVelocity(robot);
  if (velocity.norm() < kMoving) {
    return RobotWay::Standing;
  }
  const Vec2 toPerson = view.pose(human).position - view.robotPose(robot).position;
  return velocity.dot(toPerson) > 0.0 ? RobotWay::Coming : RobotWay::Away;
}

NodeStatus start(LeafContext& leaf, Person human, double distance, double patience) {
  HumanContext& context = humanOf(leaf);
  if (wayOfRobot(context.view(), human, distance) != RobotWay::Coming) {
    return NodeStatus::Failure;
  }
  context.setActive(human);
  return begin(leaf, Memory{leaf.step(), 0, human, distance, patience});
}

NodeStatus step(LeafContext& leaf, HumanContext& context, Memory& memory) {
  const sim2d::WorldView& view = context.view();
  const RobotWay way = wayOfRobot(view, memory.human, memory.distance);
  if (way == RobotWay::Away) {
    return NodeStatus::Success;
  }
  if (way == RobotWay::Coming) {
    memory.waitStep = 0;
  } else if (memory.waitStep == 0) {
    memory.waitStep = leaf.step();
  } else if (leaf.hasElapsed(memory.waitStep, memory.patience)) {
    return NodeStatus::Success;  // it waits for the person as well
  }
  const Vec2 robot = view.robotPose(view.nearestRobot(memory.human)).position;
  context.move(memory.human, turnTo(context, memory.human, robot, 0.0).intent);
  return NodeStatus::Running;
}

constexpr const char* kNodes = R"(
Action YieldToRobot own|Reactions|Stands and looks at a robot that comes nearer until it has passed; fails when none comes.
agent_id
distance length default 3.0|A robot within this distance counts.
patience duration default 3.0|Ends when the robot has stood still for this time.
)";

}  // namespace

void addYieldToRobot(NodeLibrary& to) {
  to.addStateful<Memory>(*humanManifests(kNodes).find("YieldToRobot"),
                         {withPorts<start, 0, 1, 2>, whilePresent<Memory, step>});
}

}  // namespace bt

#include "bt/human/HumanContext.h"
#include "bt/human/Motions.h"
#include "bt/human/Perception.h"

namespace bt {

using base::Vec2;

namespace {

constexpr double kMoving = 0.05;  // [m/s] a slower robot counts as standing

struct Memory {
  std::int64_t startStep;
  std::int64_t waitStep;  // first step of the robot standing; 0: it moves
  int human;
  double distance;  // [m]
  double patience;  // [s]
};

enum class RobotMotion { Away, Standing, Coming };

/// Motion of the nearest robot relative to a person; farther than `distance` counts as away.
RobotMotion robotMotionOf(const sim2d::WorldView& view, int human, double distance) {
  const int robot = view.nearestRobot(human);
  if (robot < 0 || robotDistance(view, human) > distance) {
    return RobotMotion::Away;
  }
  const Vec2 velocity = view.robotVelocity(robot);
  if (velocity.norm() < kMoving) {
    return RobotMotion::Standing;
  }
  const Vec2 toPerson = view.pose(human).position - view.robotPose(robot).position;
  return velocity.dot(toPerson) > 0.0 ? RobotMotion::Coming : RobotMotion::Away;
}

NodeStatus start(LeafContext& leaf, AgentIndex human, double distance, double patience) {
  HumanContext& context = humanOf(leaf);
  if (robotMotionOf(context.view(), human, distance) != RobotMotion::Coming) {
    return NodeStatus::Failure;
  }
  context.setActive(human);
  return begin(leaf, Memory{leaf.step(), 0, human, distance, patience});
}

NodeStatus step(LeafContext& leaf, HumanContext& context, Memory& memory) {
  const sim2d::WorldView& view = context.view();
  const RobotMotion way = robotMotionOf(view, memory.human, memory.distance);
  if (way == RobotMotion::Away) {
    return NodeStatus::Success;
  }
  if (way == RobotMotion::Coming) {
    memory.waitStep = 0;
  } else if (memory.waitStep == 0) {
    memory.waitStep = leaf.step();
  } else if (leaf.hasElapsed(memory.waitStep, memory.patience)) {
    return NodeStatus::Success;  // the robot waits for the person as well
  }
  const Vec2 robot = view.robotPose(view.nearestRobot(memory.human)).position;
  context.move(memory.human, turnTo(context, memory.human, robot, 0.0).intent);
  return NodeStatus::Running;
}

constexpr const char* kNodes = R"(
Action YieldToRobot own|Reactions|Stands and looks at an approaching robot until it has passed; fails if no robot approaches.
agent_id
distance length default 3.0|Maximum distance of the robot.
patience duration default 3.0|Time after which the node ends if the robot stands still.
)";

}  // namespace

void addYieldToRobot(NodeLibrary& to) {
  to.addStateful<Memory>(*humanManifests(kNodes).find("YieldToRobot"),
                         {withPorts<start, 0, 1, 2>, ifPresentThen<Memory, step>});
}

}  // namespace bt

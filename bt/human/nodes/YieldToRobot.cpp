#include "bt/human/HumanContext.h"
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

NodeStatus start(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const double distance = leaf.require<double>(1);
  const double patience = leaf.require<double>(2);
  if (!human || wayOfRobot(context.view(), *human, distance) != RobotWay::Coming) {
    return NodeStatus::Failure;
  }
  leaf.memory<Memory>() = {leaf.step(), 0, *human, distance, patience};
  context.setActive(*human);
  return NodeStatus::Running;
}

NodeStatus run(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const sim2d::WorldView& view = context.view();
  Memory& memory = leaf.memory<Memory>();
  if (!view.isPresent(memory.human)) {
    return NodeStatus::Failure;
  }
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

}  // namespace

void addYieldToRobot(NodeLibrary& to) {
  to.addStateful<Memory>(
      ownNode("YieldToRobot", "Reactions",
              "Stands and looks at a robot that comes nearer until it has passed; fails when none "
              "comes.",
              {port::agent(),
               port::length("distance", "A robot within this distance counts.").byDefault("3.0"),
               port::duration("patience", "Ends when the robot has stood still for this time.")
                   .byDefault("3.0")}),
      {start, run, nullptr});
}

}  // namespace bt

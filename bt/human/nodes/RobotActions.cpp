#include "bt/human/Leaves.h"
#include "bt/human/Motions.h"
#include "bt/human/Ports.h"

/// Reactions to the robot that last: ApproachRobot, AvoidRobot, BlockRobot.
namespace bt {

namespace {

struct Memory {
  std::int64_t startStep;
  int human;
  double distance;  // closest, safe or in front [m]
  double speed;     // [m/s]
  double duration;  // [s]
};

/// Ports: 0 agent, 1 time step, 2 distance, 3 duration, 4 speed where there is one.
NodeStatus start(LeafContext& leaf, bool hasSpeed) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const double distance = leaf.require<double>(2);
  const double duration = leaf.require<double>(3);
  const double speed = hasSpeed ? leaf.require<double>(4) : 0.0;
  if (!human || context.view().nearestRobot(*human) < 0) {
    return NodeStatus::Failure;
  }
  leaf.memory<Memory>() = {leaf.step(), *human, distance, speed, duration};
  context.setActive(*human);
  return NodeStatus::Running;
}

NodeStatus startWithSpeed(LeafContext& leaf) {
  return start(leaf, true);
}
NodeStatus startWithoutSpeed(LeafContext& leaf) {
  return start(leaf, false);
}

using Step = sim2d::Intent (*)(HumanContext&, const Memory&, const Target& robot);

template <Step step>
NodeStatus run(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const Memory& memory = leaf.memory<Memory>();
  const std::optional<Target> robot = nearestRobotOf(context.view(), memory.human);
  if (!robot || !context.view().isPresent(memory.human)) {
    return NodeStatus::Failure;
  }
  context.move(memory.human, step(context, memory, *robot));
  return byDuration(leaf, memory.startStep, memory.duration);
}

sim2d::Intent approachStep(HumanContext& context, const Memory& memory, const Target& robot) {
  return approach(context, memory.human, robot, {memory.distance, memory.speed});
}

sim2d::Intent avoidStep(HumanContext& context, const Memory& memory, const Target& robot) {
  return avoid(context, memory.human, robot, {memory.distance, memory.speed});
}

sim2d::Intent blockStep(HumanContext& context, const Memory& memory, const Target& robot) {
  const sim2d::WorldView& view = context.view();
  const double speed = view.robotVelocity(view.nearestRobot(memory.human)).norm();
  return blockRobot(context, memory.human, robot, speed, memory.distance);
}

}  // namespace

void addRobotActions(NodeLibrary& to) {
  to.addStateful<Memory>(
      humanNode("ApproachRobot", "Reactions",
                "Walks to the robot, slower the nearer, and looks at it from the closest distance.",
                {port::agent(), port::timeStep(),
                 port::length("closest_dist", "Comes this near.").required().suggest("1.5"),
                 port::lasting(),
                 port::speed("max_vel", "Speed far from the robot.").required().suggest("1.8")}),
      {startWithSpeed, run<approachStep>, nullptr});
  to.addStateful<Memory>(
      humanNode("AvoidRobot", "Reactions",
                "Flees from the robot to the safe distance and watches it from there.",
                {port::agent(), port::timeStep(),
                 port::length("safe_distance", "Flees to this distance.").required().suggest("5.0"),
                 port::lasting(),
                 port::speed("runaway_vel", "Speed of the flight.").required().suggest("1.5")}),
      {startWithSpeed, run<avoidStep>, nullptr});
  to.addStateful<Memory>(
      humanNode("BlockRobot", "Reactions",
                "Walks to the place in front of the robot and faces it there.",
                {port::agent(), port::timeStep(),
                 port::length("front_dist", "Place in front of the robot; below 0.5 it is 1.5 m.")
                     .required()
                     .suggest("1.0"),
                 port::lasting()}),
      {startWithoutSpeed, run<blockStep>, nullptr});
}

}  // namespace bt

#include "bt/human/HumanContext.h"
#include "bt/human/Motions.h"
#include "bt/human/Perception.h"
#include "bt/human/Ports.h"

/// Reactions to the robot, one step per tick (the tree around them decides how long they last) or
/// lasting; and questions about it.
namespace bt {

namespace {

/// The person of port 0 and the robot that counts for them.
struct Pair {
  int human = -1;
  Target robot;
};

std::optional<Pair> pairOf(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const std::optional<Target> robot = human ? nearestRobotOf(context.view(), *human) : std::nullopt;
  return robot ? std::optional<Pair>({*human, *robot}) : std::nullopt;
}

sim2d::Intent block(const HumanContext& context, int human, const Target& robot, double front) {
  const sim2d::WorldView& view = context.view();
  const double speed = view.robotVelocity(view.nearestRobot(human)).norm();
  return blockRobot(context, human, robot, speed, front);
}

NodeStatus surprised(LeafContext& leaf) {
  const std::optional<Pair> pair = pairOf(leaf);
  if (!pair) {
    return NodeStatus::Failure;
  }
  HumanContext& context = humanOf(leaf);
  context.move(pair->human, lookAt(context, pair->human, pair->robot.pose.position, 0.0).intent);
  return NodeStatus::Success;
}

NodeStatus curious(LeafContext& leaf) {
  const std::optional<Pair> pair = pairOf(leaf);
  const Approach how{leaf.require<double>(5), leaf.require<double>(4)};
  if (!pair) {
    return NodeStatus::Failure;
  }
  HumanContext& context = humanOf(leaf);
  context.move(pair->human, approach(context, pair->human, pair->robot, how));
  return NodeStatus::Success;
}

NodeStatus scared(LeafContext& leaf) {
  const std::optional<Pair> pair = pairOf(leaf);
  const double speed = leaf.require<double>(4);
  const double safe = leaf.require<double>(5);
  const std::optional<double> factor = leaf.get<double>(6);
  if (!pair) {
    return NodeStatus::Failure;
  }
  HumanContext& context = humanOf(leaf);
  const bool isPushed = factor && leaf.state(5) != PortState::Given;
  context.move(pair->human, isPushed ? flinch(context, pair->human, pair->robot, speed, *factor)
                                     : avoid(context, pair->human, pair->robot, {safe, speed}));
  return NodeStatus::Success;
}

NodeStatus threatening(LeafContext& leaf) {
  const std::optional<Pair> pair = pairOf(leaf);
  const double front = leaf.require<double>(4);
  if (!pair) {
    return NodeStatus::Failure;
  }
  HumanContext& context = humanOf(leaf);
  context.move(pair->human, block(context, pair->human, pair->robot, front));
  return NodeStatus::Success;
}

NodeManifest reaction(const char* id, const char* description,
                      std::initializer_list<PortSpec> more) {
  NodeManifest manifest = humanNode(
      id, "Reactions", description,
      {port::agent(), port::timeStep(), port::unused("beh_duration", PortType::Double, "s"),
       port::unused("only_once", PortType::Bool)});
  manifest.ports.insert(manifest.ports.end(), more.begin(), more.end());
  return manifest;
}

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
  return block(context, memory.human, robot, memory.distance);
}

NodeStatus isClose(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const double threshold = leaf.require<double>(1);
  return successIf(human && robotDistance(context.view(), *human) < threshold);
}

NodeStatus isFacing(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  return successIf(human && isRobotFacing(context.view(), *human));
}

void addSteps(NodeLibrary& to) {
  to.addAction(reaction("SurprisedNav", "Stands and turns to the robot.", {}), surprised);
  to.addAction(
      reaction("CuriousNav", "One step towards the robot, slower the nearer; looks at it at rest.",
               {port::speed("agent_vel", "Speed far from the robot.").needed().suggest("1.0"),
                port::length("stop_distance", "Stops this far from the robot.")
                    .needed()
                    .suggest("0.5")}),
      curious);
  to.addAction(
      reaction(
          "ScaredNav",
          "One step away from the robot. With scary_force_factor and without safe_distance: "
          "one step to the goals while the robot pushes.",
          {port::speed("runaway_vel", "Speed of the flight.").needed().suggest("1.5"),
           port::length("safe_distance", "Flees to this distance.").byDefault("5.0").suggest(""),
           PortSpec("scary_force_factor", PortType::Double, "m/s²",
                    "Strength of the push by the robot.")
               .range(0.0, 1000.0)}),
      scared);
  to.addAction(
      reaction("ThreateningNav", "One step to the place in front of the robot; faces it there.",
               {port::length("goal_dist", "Place in front of the robot; below 0.5 it is 1.5 m.")
                    .needed()
                    .suggest("1.0")}),
      threatening);
}

}  // namespace

void addRobotNodes(NodeLibrary& to) {
  addSteps(to);
  to.addStateful<Memory>(
      humanNode("ApproachRobot", "Reactions",
                "Walks to the robot, slower the nearer, and looks at it from the closest distance.",
                {port::agent(), port::timeStep(),
                 port::length("closest_dist", "Comes this near.").needed().suggest("1.5"),
                 port::lasting(),
                 port::speed("max_vel", "Speed far from the robot.").needed().suggest("1.8")}),
      {startWithSpeed, run<approachStep>, nullptr});
  to.addStateful<Memory>(
      humanNode("AvoidRobot", "Reactions",
                "Flees from the robot to the safe distance and watches it from there.",
                {port::agent(), port::timeStep(),
                 port::length("safe_distance", "Flees to this distance.").needed().suggest("5.0"),
                 port::lasting(),
                 port::speed("runaway_vel", "Speed of the flight.").needed().suggest("1.5")}),
      {startWithSpeed, run<avoidStep>, nullptr});
  to.addStateful<Memory>(
      humanNode("BlockRobot", "Reactions",
                "Walks to the place in front of the robot and faces it there.",
                {port::agent(), port::timeStep(),
                 port::length("front_dist", "Place in front of the robot; below 0.5 it is 1.5 m.")
                     .needed()
                     .suggest("1.0"),
                 port::lasting()}),
      {startWithoutSpeed, run<blockStep>, nullptr});
  to.addCondition(
      humanNode(
          "IsRobotClose", "Perception", "The robot is nearer than the threshold.",
          {port::agent(), port::length("threshold", "Nearer than this is close.").byDefault("1.0")},
          NodeKind::Condition),
      isClose);
  to.addCondition(humanNode("IsRobotFacingAgent", "Perception",
                            "The robot's front points at the person, within 0.3 rad.",
                            {port::agent()}, NodeKind::Condition),
                  isFacing);
}

}  // namespace bt

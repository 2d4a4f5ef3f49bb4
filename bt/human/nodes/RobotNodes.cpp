#include "bt/human/Motions.h"
#include "bt/human/Perception.h"
#include "bt/human/Ports.h"

/// Reactions to the robot, one step per tick (the tree around them decides how long they last) or
/// lasting; and questions about it.
namespace bt {

namespace {

/// A person and the robot that counts for them.
struct Pair {
  int human;
  Target robot;
};

}  // namespace

template <>
std::optional<Pair> argument(LeafContext& leaf, int port) {
  const HumanContext& context = humanOf(leaf);
  const std::optional<int> human = humanOf(leaf).person(leaf, port);
  const std::optional<Target> robot = human ? nearestRobotOf(context.view(), *human) : std::nullopt;
  return robot ? std::optional<Pair>({*human, *robot}) : std::nullopt;
}

namespace {

sim2d::Intent block(const HumanContext& context, const Pair& pair, double front) {
  const sim2d::WorldView& view = context.view();
  const double speed = view.robotVelocity(view.nearestRobot(pair.human)).norm();
  return blockRobot(context, pair.human, pair.robot, speed, front);
}

void surprised(HumanContext& context, const Pair& pair) {
  context.move(pair.human, lookAt(context, pair.human, pair.robot.pose.position, 0.0).intent);
}

void curious(HumanContext& context, const Pair& pair, double closest, double speed) {
  context.move(pair.human, approach(context, pair.human, pair.robot, {closest, speed}));
}

void scared(LeafContext& leaf, const Pair& pair, double speed, double safe) {
  HumanContext& context = humanOf(leaf);
  const std::optional<double> factor = leaf.get<double>(6);
  const bool isPushed = factor && leaf.state(5) != PortState::Given;
  context.move(pair.human, isPushed ? flinch(context, pair.human, pair.robot, speed, *factor)
                                    : avoid(context, pair.human, pair.robot, {safe, speed}));
}

void threatening(HumanContext& context, const Pair& pair, double front) {
  context.move(pair.human, block(context, pair, front));
}

struct Memory {
  std::int64_t startStep;
  int human;
  double distance;  // closest, safe or in front [m]
  double duration;  // [s]
  double speed;     // [m/s]
};

NodeStatus start(LeafContext& leaf, const Pair& pair, double distance, double duration,
                 double speed) {
  humanOf(leaf).setActive(pair.human);
  return begin(leaf, Memory{leaf.step(), pair.human, distance, duration, speed});
}

NodeStatus startBlock(LeafContext& leaf, const Pair& pair, double distance, double duration) {
  return start(leaf, pair, distance, duration, 0.0);
}

using Motion = sim2d::Intent (*)(HumanContext&, const Memory&, const Target& robot);

template <Motion motion>
NodeStatus step(LeafContext& leaf, HumanContext& context, Memory& memory) {
  const std::optional<Target> robot = nearestRobotOf(context.view(), memory.human);
  if (!robot) {
    return NodeStatus::Failure;
  }
  context.move(memory.human, motion(context, memory, *robot));
  return byDuration(leaf, memory.startStep, memory.duration);
}

sim2d::Intent approaching(HumanContext& context, const Memory& memory, const Target& robot) {
  return approach(context, memory.human, robot, {memory.distance, memory.speed});
}

sim2d::Intent avoiding(HumanContext& context, const Memory& memory, const Target& robot) {
  return avoid(context, memory.human, robot, {memory.distance, memory.speed});
}

sim2d::Intent blocking(HumanContext& context, const Memory& memory, const Target& robot) {
  return block(context, {memory.human, robot}, memory.distance);
}

bool isClose(HumanContext& context, Person human, double threshold) {
  return robotDistance(context.view(), human) < threshold;
}

constexpr const char* kNodes = R"(
Action SurprisedNav|Reactions|Stands and turns to the robot.
agent_id time_step
beh_duration seconds|Accepted for existing files; has no effect.
only_once bool|Accepted for existing files; has no effect.
Action CuriousNav|Reactions|One step towards the robot, slower the nearer; looks at it at rest.
agent_id time_step beh_duration only_once
agent_vel speed needed suggest 1.0|Speed far from the robot.
stop_distance length needed suggest 0.5|Stops this far from the robot.
Action ScaredNav|Reactions|One step away from the robot. With scary_force_factor and without safe_distance: one step to the goals while the robot pushes.
agent_id time_step beh_duration only_once
runaway_vel speed needed suggest 1.5|Speed of the flight.
safe_distance length default 5.0 suggest|Flees to this distance.
scary_force_factor number unit m/s² range 0 1000|Strength of the push by the robot.
Action ThreateningNav|Reactions|One step to the place in front of the robot; faces it there.
agent_id time_step beh_duration only_once
goal_dist length needed suggest 1.0|Place in front of the robot; below 0.5 it is 1.5 m.
Action ApproachRobot|Reactions|Walks to the robot, slower the nearer, and looks at it from the closest distance.
agent_id time_step
closest_dist length needed suggest 1.5|Comes this near.
duration
max_vel speed needed suggest 1.8|Speed far from the robot.
Action AvoidRobot|Reactions|Flees from the robot to the safe distance and watches it from there.
agent_id time_step
safe_distance length needed suggest 5.0|Flees to this distance.
duration
runaway_vel speed needed suggest 1.5|Speed of the flight.
Action BlockRobot|Reactions|Walks to the place in front of the robot and faces it there.
agent_id time_step
front_dist length needed suggest 1.0|Place in front of the robot; below 0.5 it is 1.5 m.
duration
Condition IsRobotClose|Perception|The robot is nearer than the threshold.
agent_id
threshold length default 1.0|Nearer than this is close.
Condition IsRobotFacingAgent|Perception|The robot's front points at the person, within 0.3 rad.
agent_id
)";

}  // namespace

void addRobotNodes(NodeLibrary& to) {
  const NodeCatalogue nodes = humanManifests(kNodes);
  to.addAction(*nodes.find("SurprisedNav"), withPorts<surprised, 0>);
  to.addAction(*nodes.find("CuriousNav"), withPorts<curious, 0, 5, 4>);
  to.addAction(*nodes.find("ScaredNav"), withPorts<scared, 0, 4, 5>);
  to.addAction(*nodes.find("ThreateningNav"), withPorts<threatening, 0, 4>);
  to.addStateful<Memory>(*nodes.find("ApproachRobot"),
                         {withPorts<start, 0, 2, 3, 4>, whilePresent<Memory, step<approaching>>});
  to.addStateful<Memory>(*nodes.find("AvoidRobot"),
                         {withPorts<start, 0, 2, 3, 4>, whilePresent<Memory, step<avoiding>>});
  to.addStateful<Memory>(*nodes.find("BlockRobot"),
                         {withPorts<startBlock, 0, 2, 3>, whilePresent<Memory, step<blocking>>});
  to.addCondition(*nodes.find("IsRobotClose"), withPorts<isClose, 0, 1>);
  to.addCondition(*nodes.find("IsRobotFacingAgent"), withPorts<isRobotFacing, 0>);
}

}  // namespace bt

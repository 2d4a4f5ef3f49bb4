#include "bt/human/Motions.h"

/// Reactions to the robot, as single steps (the surrounding tree decides about the duration) or
/// stateful; and conditions about the robot.
namespace bt {

namespace {

/// A person and the robot relevant for them.
struct AgentAndRobot {
  int human;
  Target robot;
};

}  // namespace

template <>
std::optional<AgentAndRobot> argument(LeafContext& leaf, int port) {
  const HumanContext& context = humanOf(leaf);
  const std::optional<int> human = humanOf(leaf).person(leaf, port);
  const std::optional<Target> robot = human ? nearestRobotOf(context.view(), *human) : std::nullopt;
  return robot ? std::optional<AgentAndRobot>({*human, *robot}) : std::nullopt;
}

namespace {

sim2d::Intent block(const HumanContext& context, const AgentAndRobot& pair, double front) {
  const sim2d::WorldView& view = context.view();
  const double speed = view.robotVelocity(view.nearestRobot(pair.human)).norm();
  return blockRobot(context, pair.human, pair.robot, speed, front);
}

void surprised(HumanContext& context, const AgentAndRobot& pair) {
  context.move(pair.human, lookAt(context, pair.human, pair.robot.pose.position, 0.0).intent);
}

void curious(HumanContext& context, const AgentAndRobot& pair, double closest, double speed) {
  context.move(pair.human, approach(context, pair.human, pair.robot, {closest, speed}));
}

void scared(LeafContext& leaf, const AgentAndRobot& pair, double speed, double safe) {
  HumanContext& context = humanOf(leaf);
  const std::optional<double> factor = leaf.get<double>(6);
  const bool isPushed = factor && leaf.state(5) != PortState::Given;
  context.move(pair.human,
               isPushed ? walkWithRobotRepulsion(context, pair.human, pair.robot, speed, *factor)
                        : avoid(context, pair.human, pair.robot, {safe, speed}));
}

void threatening(HumanContext& context, const AgentAndRobot& pair, double front) {
  context.move(pair.human, block(context, pair, front));
}

struct Memory {
  std::int64_t startStep;
  int human;
  double distance;  // closest, safe or front distance [m]
  double duration;  // [s]
  double speed;     // [m/s]
};

NodeStatus start(LeafContext& leaf, const AgentAndRobot& pair, double distance, double duration,
                 double speed) {
  humanOf(leaf).setActive(pair.human);
  return begin(leaf, Memory{leaf.step(), pair.human, distance, duration, speed});
}

NodeStatus startBlock(LeafContext& leaf, const AgentAndRobot& pair, double distance,
                      double duration) {
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
  return successAfter(leaf, memory.startStep, memory.duration);
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

bool isClose(HumanContext& context, AgentIndex human, double threshold) {
  return robotDistance(context.view(), human) < threshold;
}

constexpr const char* kNodes = R"(
Action SurprisedNav|Reactions|Stands and turns to the robot.
agent_id time_step
beh_duration seconds|Accepted for existing files; has no effect.
only_once bool|Accepted for existing files; has no effect.
Action CuriousNav|Reactions|One time step towards the robot, slower with decreasing distance; looks at it at rest.
agent_id time_step beh_duration only_once
agent_vel speed needed suggest 1.0|Speed far from the robot.
stop_distance length needed suggest 0.5|Distance to the robot at which the person stops.
Action ScaredNav goals|Reactions|One time step away from the robot. With scary_force_factor and without safe_distance: one time step to the goals while the robot repels the person.
agent_id time_step beh_duration only_once
runaway_vel speed needed suggest 1.5|Speed while fleeing.
safe_distance length default 5.0 suggest|Distance to which the person flees.
scary_force_factor number unit m/s² range 0 1000|Strength of the repulsive force of the robot.
Action ThreateningNav|Reactions|One time step to the position in front of the robot; faces it there.
agent_id time_step beh_duration only_once
goal_dist length needed suggest 1.0|Distance in front of the robot; values below 0.5 m are replaced by 1.5 m.
Action ApproachRobot|Reactions|Walks to the robot, slower with decreasing distance, and looks at it from the closest distance.
agent_id time_step
closest_dist length needed suggest 1.5|Distance at which the person stops.
duration
max_vel speed needed suggest 1.8|Speed far from the robot.
Action AvoidRobot|Reactions|Flees from the robot to the safe distance and looks at it from there.
agent_id time_step
safe_distance length needed suggest 5.0|Distance to which the person flees.
duration
runaway_vel speed needed suggest 1.5|Speed while fleeing.
Action BlockRobot|Reactions|Walks to the position in front of the robot and faces it there.
agent_id time_step
front_dist length needed suggest 1.0|Distance in front of the robot; values below 0.5 m are replaced by 1.5 m.
duration
Condition IsRobotClose|Perception|The robot is nearer than the threshold.
agent_id
threshold length default 1.0|Distance below which the robot is close.
Condition IsRobotFacingAgent|Perception|The robot's heading points at the person within 0.3 rad.
agent_id
)";

}  // namespace

void addRobotReactions(NodeLibrary& to) {
  to.add(
      humanManifests(kNodes),
      {{"SurprisedNav", synchronous(withPorts<surprised, 0>)},
       {"CuriousNav", synchronous(withPorts<curious, 0, 5, 4>)},
       {"ScaredNav", synchronous(withPorts<scared, 0, 4, 5>)},
       {"ThreateningNav", synchronous(withPorts<threatening, 0, 4>)},
       {"ApproachRobot",
        stateful<Memory>({withPorts<start, 0, 2, 3, 4>, ifPresentThen<Memory, step<approaching>>})},
       {"AvoidRobot",
        stateful<Memory>({withPorts<start, 0, 2, 3, 4>, ifPresentThen<Memory, step<avoiding>>})},
       {"BlockRobot",
        stateful<Memory>({withPorts<startBlock, 0, 2, 3>, ifPresentThen<Memory, step<blocking>>})},
       {"IsRobotClose", synchronous(withPorts<isClose, 0, 1>)},
       {"IsRobotFacingAgent", synchronous(withPorts<isRobotFacing, 0>)}});
}

}  // namespace bt

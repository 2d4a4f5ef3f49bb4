#include "bt/human/Leaves.h"
#include "bt/human/Motions.h"
#include "bt/human/Ports.h"

/// The reactions that are one step per tick; the tree around them decides how long they last.
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
  const sim2d::WorldView& view = context.view();
  const double speed = view.robotVelocity(view.nearestRobot(pair->human)).norm();
  context.move(pair->human, blockRobot(context, pair->human, pair->robot, speed, front));
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

}  // namespace

void addReactionSteps(NodeLibrary& to) {
  to.addAction(reaction("SurprisedNav", "Stands and turns to the robot.", {}), surprised);
  to.addAction(
      reaction("CuriousNav", "One step towards the robot, slower the nearer; looks at it at rest.",
               {port::speed("agent_vel", "Speed far from the robot.").required().suggest("1.0"),
                port::length("stop_distance", "Stops this far from the robot.")
                    .required()
                    .suggest("0.5")}),
      curious);
  to.addAction(
      reaction(
          "ScaredNav",
          "One step away from the robot. With scary_force_factor and without safe_distance: "
          "one step to the goals while the robot pushes.",
          {port::speed("runaway_vel", "Speed of the flight.").required().suggest("1.5"),
           port::length("safe_distance", "Flees to this distance.").byDefault("5.0").suggest(""),
           Port("scary_force_factor", PortType::Double, "m/s²",
                "Strength of the push by the robot.")
               .range(0.0, 1000.0)}),
      scared);
  to.addAction(
      reaction("ThreateningNav", "One step to the place in front of the robot; faces it there.",
               {port::length("goal_dist", "Place in front of the robot; below 0.5 it is 1.5 m.")
                    .required()
                    .suggest("1.0")}),
      threatening);
}

}  // namespace bt

#include "bt/human/HumanContext.h"
#include "bt/human/Motions.h"

namespace bt {

using base::Vec2;

namespace {

struct Side {
  double sign;
};

}  // namespace

template <>
std::optional<Side> argument(LeafContext& leaf, int port) {
  const std::string_view side = leaf.require<std::string_view>(port);
  if (side == "left" || side == "right") {
    return Side{side == "left" ? 1.0 : -1.0};
  }
  humanOf(leaf).warn(leaf, "tree.runs-on-no-side", {side});
  return std::nullopt;
}

namespace {

struct Memory {
  int human;
  double side;       // +1: the person's left, -1: right
  double distance;   // [m]
  double clearance;  // [m]
};

/// Walking direction as a unit vector: to the front goal, or straight ahead without goals.
Vec2 walkingDirection(HumanContext& context, int human) {
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
  return toRobot.norm() <= memory.distance &&
         toRobot.dot(walkingDirection(context, memory.human)) > 0.0;
}

NodeStatus start(LeafContext& leaf, AgentIndex human, Side side, double distance,
                 double clearance) {
  HumanContext& context = humanOf(leaf);
  const Memory memory = {human, side.sign, distance, clearance};
  if (!isRobotAhead(context, memory)) {
    return NodeStatus::Failure;
  }
  context.setActive(human);
  return begin(leaf, memory);
}

/// A point beside the robot and slightly past it, so that the robot falls behind on the way.
Vec2 pointBeside(HumanContext& context, const Memory& memory, const Vec2& robot) {
  const Vec2 way = walkingDirection(context, memory.human);
  const Vec2 left = Vec2(-way.y(), way.x());
  return robot + memory.clearance * (memory.side * left + way);
}

NodeStatus step(LeafContext&, HumanContext& context, Memory& memory) {
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

constexpr const char* kNodes = R"(
Action PassOnSide own|Reactions|Passes the robot ahead on the person's left or right; fails if there is none ahead.
agent_id
side text default right|left or right, seen by the person.
distance length default 4.0|Distance to the robot at which the node starts.
clearance length default 1.0|Lateral distance to the robot.
)";

}  // namespace

void addPassOnSide(NodeLibrary& to) {
  to.addStateful<Memory>(*humanManifests(kNodes).find("PassOnSide"),
                         {withPorts<start, 0, 1, 2, 3>, ifPresentThen<Memory, step>});
}

}  // namespace bt

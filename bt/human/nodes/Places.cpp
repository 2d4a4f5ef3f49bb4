#include <algorithm>
#include <limits>

#include "bt/human/Motions.h"
#include "sim2d/base/Rng.h"

/// Nodes that walk past the robot, to areas and to objects; they do not exist in HuNavSim.
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

struct Pass {
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

bool isRobotAhead(HumanContext& context, const Pass& memory) {
  const std::optional<Target> robot = nearestRobotOf(context.view(), memory.human);
  if (!robot) {
    return false;
  }
  const Vec2 toRobot = robot->pose.position - context.view().pose(memory.human).position;
  return toRobot.norm() <= memory.distance &&
         toRobot.dot(walkingDirection(context, memory.human)) > 0.0;
}

NodeStatus startPass(LeafContext& leaf, AgentIndex human, Side side, double distance,
                     double clearance) {
  HumanContext& context = humanOf(leaf);
  const Pass memory = {human, side.sign, distance, clearance};
  if (!isRobotAhead(context, memory)) {
    return NodeStatus::Failure;
  }
  context.setActive(human);
  return begin(leaf, memory);
}

/// A point beside the robot and slightly past it, so that the robot falls behind on the way.
Vec2 pointBeside(HumanContext& context, const Pass& memory, const Vec2& robot) {
  const Vec2 way = walkingDirection(context, memory.human);
  const Vec2 left = Vec2(-way.y(), way.x());
  return robot + memory.clearance * (memory.side * left + way);
}

NodeStatus pass(LeafContext&, HumanContext& context, Pass& memory) {
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

constexpr double kReached = 0.3;  // [m]
constexpr int kTries = 32;        // random points per step

/// Sorted x coordinates where the horizontal line at `y` crosses the outline.
std::vector<double> crossingsAt(const std::vector<Vec2>& polygon, double y) {
  std::vector<double> crossings;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[j];
    if ((a.y() > y) != (b.y() > y)) {
      crossings.push_back((b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()) + a.x());
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

/// Even-odd rule: an odd number of crossings to the right.
bool isInside(const std::vector<Vec2>& polygon, const Vec2& point) {
  const std::vector<double> crossings = crossingsAt(polygon, point.y());
  const auto isRight = [&point](double x) { return point.x() < x; };
  return std::count_if(crossings.begin(), crossings.end(), isRight) % 2 == 1;
}

/// The mean of the corners; if it is outside, the middle of the widest part at its height.
Vec2 interiorPoint(const std::vector<Vec2>& polygon) {
  Vec2 mean = Vec2::Zero();
  for (const Vec2& corner : polygon) {
    mean += corner;
  }
  mean /= static_cast<double>(polygon.size());
  if (isInside(polygon, mean)) {
    return mean;
  }
  const std::vector<double> crossings = crossingsAt(polygon, mean.y());
  double widest = 0.0;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    if (crossings[i + 1] - crossings[i] > widest) {
      widest = crossings[i + 1] - crossings[i];
      mean.x() = 0.5 * (crossings[i] + crossings[i + 1]);
    }
  }
  return mean;
}

struct Memory {
  std::int64_t startStep;
  int human;
  int goalId;
  double x, y;  // target
  bool hasTarget;
  bool isThere;
  double duration;  // [s]
};

/// A random point of the area that the person can reach.
std::optional<Vec2> drawPoint(LeafContext& leaf, int human, const sim2d::Area& area) {
  const sim2d::WorldView& view = humanOf(leaf).view();
  Vec2 low = area.points.front();
  Vec2 high = area.points.front();
  for (const Vec2& corner : area.points) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const base::AgentRng random(view.seed(), view.constants(human).id,
                              static_cast<std::uint64_t>(view.step()));
  const auto first = static_cast<std::uint32_t>(leaf.node()) * (2 * kTries);
  for (std::uint32_t i = 0; i < kTries; ++i) {
    const double x =
        random.uniform(low.x(), high.x(), base::DrawPurpose::GoalChoice, first + 2 * i);
    const double y =
        random.uniform(low.y(), high.y(), base::DrawPurpose::GoalChoice, first + 2 * i + 1);
    if (isInside(area.points, Vec2(x, y)) && view.isReachable(human, Vec2(x, y))) {
      return Vec2(x, y);
    }
  }
  return std::nullopt;
}

/// The area named by a port; nullptr, with one warning, if there is none.
const sim2d::Area* areaOf(LeafContext& leaf, int port) {
  HumanContext& context = humanOf(leaf);
  const std::string name(leaf.require<std::string_view>(port));
  const sim2d::Area* area = context.view().area(name);
  if (!area || area->points.size() < 3) {
    context.warn(leaf, "tree.runs-without-area", {name});
    return nullptr;
  }
  return area;
}

bool isAt(const HumanContext& context, const Memory& memory) {
  return (context.view().pose(memory.human).position - Vec2(memory.x, memory.y)).norm() <= kReached;
}

void walkToTarget(HumanContext& context, const Memory& memory) {
  context.move(memory.human,
               walkTo(context, memory.human, {memory.goalId, Vec2(memory.x, memory.y), 0.1}));
}

NodeStatus startWander(LeafContext& leaf) {
  const std::optional<int> human = humanOf(leaf).person(leaf, 0);
  const sim2d::Area* area = areaOf(leaf, 1);
  const double duration = leaf.require<double>(2);
  if (!human || !area) {
    return NodeStatus::Failure;
  }
  return begin(leaf, Memory{leaf.step(), *human, 0, 0.0, 0.0, false, false, duration});
}

NodeStatus runWander(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  Memory& memory = leaf.memory<Memory>();
  const sim2d::Area* area = areaOf(leaf, 1);
  if (!area || !context.view().isPresent(memory.human)) {
    return NodeStatus::Failure;
  }
  if (!memory.hasTarget || isAt(context, memory)) {
    const std::optional<Vec2> point = drawPoint(leaf, memory.human, *area);
    memory.hasTarget = point.has_value();
    if (point) {
      memory.x = point->x();
      memory.y = point->y();
    }
  }
  if (memory.hasTarget) {
    walkToTarget(context, memory);
  }
  return successAfter(leaf, memory.startStep, memory.duration);
}

NodeStatus startExit(LeafContext& leaf, AgentIndex human) {
  const sim2d::WorldView& view = humanOf(leaf).view();
  double shortest = std::numeric_limits<double>::infinity();
  Vec2 nearest = Vec2::Zero();
  for (const sim2d::Area& area : view.scenario().areas) {
    if (area.kind != sim2d::AreaKind::Exit || !area.listed || area.points.size() < 3) {
      continue;
    }
    const Vec2 middle = interiorPoint(area.points);
    const std::optional<double> length = view.pathLength(human, middle);
    if (length && *length < shortest) {
      shortest = *length;
      nearest = middle;
    }
  }
  return shortest < std::numeric_limits<double>::infinity()
             ? begin(leaf,
                     Memory{leaf.step(), human, 0, nearest.x(), nearest.y(), true, false, 0.0})
             : NodeStatus::Failure;
}

NodeStatus goToExit(LeafContext&, HumanContext& context, Memory& memory) {
  if (isAt(context, memory)) {
    return NodeStatus::Success;
  }
  walkToTarget(context, memory);
  return NodeStatus::Running;
}

NodeStatus startUse(LeafContext& leaf, AgentIndex human, const sim2d::GoalItem& place,
                    double duration) {
  return begin(leaf, Memory{leaf.step(), human, place.id, place.position.x(), place.position.y(),
                            true, false, duration});
}

NodeStatus use(LeafContext& leaf, HumanContext& context, Memory& memory) {
  if (!memory.isThere && isAt(context, memory)) {
    memory.isThere = true;
    memory.startStep = leaf.step();
  }
  if (!memory.isThere) {
    walkToTarget(context, memory);
    return NodeStatus::Running;
  }
  context.setActive(memory.human);
  return leaf.hasElapsed(memory.startStep, memory.duration) ? NodeStatus::Success
                                                            : NodeStatus::Running;
}

constexpr const char* kNodes = R"(
Action PassOnSide own goals|Reactions|Passes the robot ahead on the person's left or right; fails if there is none ahead.
agent_id
side text default right|left or right, seen by the person.
distance length default 4.0|Distance to the robot at which the node starts.
clearance length default 1.0|Lateral distance to the robot.
Action WanderInArea own|Walking|Walks between random points of an area.
agent_id
area text needed suggest area1|Name of the area.
duration duration atMost 36000 default 0.0|Ends after this time; 0: unlimited.
Action GoToNearestExit own|Walking|Walks into the area of kind exit with the shortest path; fails without one.
agent_id
Action UseObject own|Walking|Walks to a global goal and stays there for some time.
agent_id
goal_id int unless target_x target_y suggest 1|Id of the global goal at the object.
target_x target_y
duration duration default 5.0|Time at the object.
)";

}  // namespace

void addPlaces(NodeLibrary& to) {
  to.add(humanManifests(kNodes),
         {{"PassOnSide",
           stateful<Pass>({withPorts<startPass, 0, 1, 2, 3>, ifPresentThen<Pass, pass>})},
          {"WanderInArea", stateful<Memory>({startWander, runWander})},
          {"GoToNearestExit",
           stateful<Memory>({withPorts<startExit, 0>, ifPresentThen<Memory, goToExit>})},
          {"UseObject",
           stateful<Memory>({withPorts<startUse, 0, 1, 4>, ifPresentThen<Memory, use>})}});
}

}  // namespace bt

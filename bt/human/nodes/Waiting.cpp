#include <tuple>

#include "bt/human/Motions.h"

/// Nodes that wait in a queue or for the robot; they do not exist in HuNavSim.
namespace bt {

using base::Vec2;

namespace {

constexpr double kReachedHead = 0.3;  // [m]
constexpr double kReachedSpot = 0.2;  // [m]

struct Memory {
  std::int64_t startStep;
  std::int64_t servedStep;  // 0: not yet at the head
  double spacing;           // [m]
  double duration;          // [s]
  double patience;          // [s]
};

/// Order in the queue; of people who join in the same step the smaller id is first.
bool isBefore(const HumanContext& context, const QueuePlace& a, const QueuePlace& b) {
  return std::make_tuple(a.number, context.idOf(a.human)) <
         std::make_tuple(b.number, context.idOf(b.human));
}

/// The person directly in front; for a person who has not joined, the last in the queue. nullptr:
/// none.
const QueuePlace* predecessor(const HumanContext& context, const QueuePlace& own) {
  const QueuePlace* last = nullptr;
  for (int i = 0; i < context.view().humanCount(); ++i) {
    const QueuePlace* const other = context.agentStateOf(i).queue.get();
    if (!other || other->human == own.human || other->number == 0 || other->head != own.head ||
        !context.view().isPresent(other->human)) {
      continue;
    }
    const bool isAhead = own.number == 0 || isBefore(context, *other, own);
    if (isAhead && (!last || isBefore(context, *last, *other))) {
      last = other;
    }
  }
  return last;
}

/// The queue extends from its head through the person in front.
Vec2 spotBehind(const HumanContext& context, const QueuePlace& own, const QueuePlace& before,
                double spacing) {
  const Vec2 there = context.view().pose(before.human).position;
  Vec2 direction = there - own.head;
  if (direction.norm() <= kReachedHead) {
    direction = context.view().pose(own.human).position - there;
  }
  const double length = direction.norm();
  return length > 0.0 ? Vec2(there + spacing / length * direction) : there;
}

NodeStatus start(LeafContext& leaf, AgentIndex human, const sim2d::GoalItem& place, double spacing,
                 double duration, double patience) {
  humanOf(leaf).agentState().queue =
      std::make_unique<QueuePlace>(QueuePlace{human, place.position, 0, leaf.node()});
  return begin(leaf, Memory{leaf.step(), 0, spacing, duration, patience});
}

/// The place held by this node, not by another WaitInQueue of the same tree.
QueuePlace* ownPlace(LeafContext& leaf) {
  QueuePlace* const place = humanOf(leaf).agentState().queue.get();
  return place != nullptr && place->node == leaf.node() ? place : nullptr;
}

void halt(LeafContext& leaf) {
  if (ownPlace(leaf)) {
    humanOf(leaf).agentState().queue.reset();
  }
}

NodeStatus leave(LeafContext& leaf, NodeStatus status) {
  halt(leaf);
  return status;
}

/// Walks to the spot, or stands there and looks at `ahead`.
void moveUp(HumanContext& context, int human, const Vec2& spot, const Vec2& ahead) {
  if ((spot - context.view().pose(human).position).norm() > kReachedSpot) {
    context.move(human, walkTo(context, human, {0, spot, 0.1}));
  } else {
    context.move(human, turnTo(context, human, ahead, 0.0).intent);
  }
}

bool isServed(const LeafContext& leaf, Memory& memory) {
  if (memory.servedStep == 0) {
    memory.servedStep = leaf.step();
  }
  return leaf.hasElapsed(memory.servedStep, memory.duration);
}

NodeStatus run(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  Memory& memory = leaf.memory<Memory>();
  QueuePlace* const own = ownPlace(leaf);
  if (!own || !context.view().isPresent(own->human)) {
    return leave(leaf, NodeStatus::Failure);
  }
  const int human = own->human;
  const Vec2 here = context.view().pose(human).position;
  const QueuePlace* before = predecessor(context, *own);
  const Vec2 spot = before ? spotBehind(context, *own, *before, memory.spacing) : own->head;
  if (own->number == 0 && (spot - here).norm() <= memory.spacing) {
    own->number = leaf.step();
  }
  const bool isAtHead = !before && (own->head - here).norm() <= kReachedHead;
  if (isAtHead && isServed(leaf, memory)) {
    return leave(leaf, NodeStatus::Success);
  }
  const bool isImpatient = memory.servedStep == 0 && memory.patience > 0.0 &&
                           leaf.hasElapsed(memory.startStep, memory.patience);
  if (isImpatient) {
    return leave(leaf, NodeStatus::Failure);
  }
  if (isAtHead) {
    context.setActive(human);
  } else {
    moveUp(context, human, spot, before ? context.view().pose(before->human).position : own->head);
  }
  return NodeStatus::Running;
}

constexpr double kMoving = 0.05;  // [m/s] a slower robot counts as standing

struct Yield {
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

NodeStatus startYield(LeafContext& leaf, AgentIndex human, double distance, double patience) {
  HumanContext& context = humanOf(leaf);
  if (robotMotionOf(context.view(), human, distance) != RobotMotion::Coming) {
    return NodeStatus::Failure;
  }
  context.setActive(human);
  return begin(leaf, Yield{leaf.step(), 0, human, distance, patience});
}

NodeStatus yield(LeafContext& leaf, HumanContext& context, Yield& memory) {
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
Action WaitInQueue own|Walking|Joins the queue at a global goal, moves up in it and is served at its head.
agent_id
goal_id int unless target_x target_y suggest 1|Id of the global goal at the head of the queue.
target_x target_y
spacing length default 0.8|Distance to the person in front.
duration duration default 5.0|Time at the head of the queue.
patience duration atMost 36000 default 0.0|Maximum wait until service; then the node fails; 0: unlimited.
Action YieldToRobot own|Reactions|Stands and looks at an approaching robot until it has passed; fails if no robot approaches.
agent_id
distance length default 3.0|Maximum distance of the robot.
patience duration default 3.0|Time after which the node ends if the robot stands still.
)";

}  // namespace

void addWaiting(NodeLibrary& to) {
  to.add(humanManifests(kNodes),
         {{"WaitInQueue", stateful<Memory>({withPorts<start, 0, 1, 4, 5, 6>, run, halt})},
          {"YieldToRobot",
           stateful<Yield>({withPorts<startYield, 0, 1, 2>, ifPresentThen<Yield, yield>})}});
}

}  // namespace bt

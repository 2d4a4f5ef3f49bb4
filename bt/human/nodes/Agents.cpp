#include "bt/human/Motions.h"

/// Nodes about other people: one of them, the members of a conversation, the crowd.
namespace bt {

namespace {

constexpr double kOwnSpeed = -1.0;                   // [m/s] FollowAgent without max_vel
constexpr double kBeyondSafe = kEscapeRadius + 0.2;  // exceeds the safe distance [m]

/// A person who may not be in the world yet.
struct AgentOrAbsent {
  int index;
};

}  // namespace

template <>
std::optional<AgentOrAbsent> argument(LeafContext& leaf, int port) {
  const std::optional<int> index = humanOf(leaf).agentEvenIfAbsent(leaf, port);
  return index ? std::optional<AgentOrAbsent>({*index}) : std::nullopt;
}

namespace {

struct Memory {
  std::int64_t startStep;
  int human;
  int target;
  double duration;  // [s]
  double distance;  // closest, front or safe distance [m]
  double speed;     // [m/s]
};

/// Ports: 0 agent, 1 target, 2 time step, 3 duration, 4 distance, 5 speed if the node has one.
template <bool hasSpeed>
NodeStatus start(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const std::optional<int> target = context.person(leaf, 1);
  const double duration = leaf.require<double>(3);
  const double distance = leaf.require<double>(4);
  const double speed = hasSpeed ? leaf.getOr<double>(5, kOwnSpeed) : 0.0;
  if (!human || !target) {
    return NodeStatus::Failure;
  }
  context.setActive(*human);
  return begin(leaf, Memory{leaf.step(), *human, *target, duration, distance, speed});
}

using Motion = sim2d::Intent (*)(HumanContext&, const Memory&, const Target& target);

template <Motion motion>
NodeStatus step(LeafContext& leaf, HumanContext& context, Memory& memory) {
  if (!context.view().isPresent(memory.target)) {
    return NodeStatus::Failure;
  }
  context.move(memory.human, motion(context, memory, agentTarget(context.view(), memory.target)));
  return successAfter(leaf, memory.startStep, memory.duration);
}

sim2d::Intent approaching(HumanContext& context, const Memory& memory, const Target& target) {
  const double distance = agentDistance(context.view(), memory.human, memory.target);
  if (context.hasQuirk(13) && distance <= memory.distance) {
    context.control(memory.human).frozen = true;
  }
  return approach(context, memory.human, target, {memory.distance, memory.speed});
}

sim2d::Intent following(HumanContext& context, const Memory& memory, const Target& target) {
  return follow(context, memory.human, target, {memory.distance, memory.speed});
}

sim2d::Intent blocking(HumanContext& context, const Memory& memory, const Target& target) {
  return blockAgent(context, memory.human, target, memory.distance);
}

bool isClose(HumanContext& context, AgentIndex observer, AgentIndex target, double threshold) {
  return agentDistance(context.view(), observer, target) < threshold;
}

NodeStatus startWait(LeafContext& leaf, AgentOrAbsent target, AgentIndex human, double distance,
                     double duration) {
  return begin(leaf, Memory{leaf.step(), human, target.index, duration, distance, 0.0});
}

NodeStatus wait(LeafContext& leaf, HumanContext& context, Memory& memory) {
  const sim2d::WorldView& view = context.view();
  if (view.isPresent(memory.target) &&
      agentDistance(view, memory.human, memory.target) <= memory.distance) {
    return NodeStatus::Success;
  }
  return memory.duration > 0.0 ? failureAfter(leaf, memory.startStep, memory.duration)
                               : NodeStatus::Running;
}

NodeStatus startFlee(LeafContext& leaf, AgentIndex target, AgentIndex human, double distance,
                     double duration, double speed) {
  return begin(leaf, Memory{leaf.step(), human, target, duration, distance, speed});
}

NodeStatus flee(LeafContext& leaf, HumanContext& context, Memory& memory) {
  const sim2d::WorldView& view = context.view();
  if (!view.isPresent(memory.target) ||
      agentDistance(view, memory.human, memory.target) >= memory.distance) {
    return NodeStatus::Success;
  }
  const sim2d::Intent away = avoid(context, memory.human, agentTarget(view, memory.target),
                                   {memory.distance, memory.speed, kBeyondSafe});
  context.move(memory.human, away);
  return successAfter(leaf, memory.startStep, memory.duration);
}

NodeStatus findNearest(LeafContext& leaf, AgentIndex human) {
  const HumanContext& context = humanOf(leaf);
  const int nearest = nearestAgent(context.view(), human);
  if (nearest < 0) {
    return NodeStatus::Failure;
  }
  leaf.set(1, context.idOf(nearest));
  return NodeStatus::Success;
}

bool isCrowded(HumanContext& context, AgentIndex human, double distance, int count) {
  std::vector<int> found;
  context.view().near(human, distance, found);
  return static_cast<int>(found.size()) >= count;
}

bool isGroupFormed(HumanContext& context, AgentIndex human, double distance) {
  const int group = context.groupOf(human);
  const sim2d::WorldView& view = context.view();
  int members = 0;
  for (int other = 0; group >= 0 && other < view.humanCount(); ++other) {
    if (other == human || !view.isPresent(other) || context.groupOf(other) != group) {
      continue;
    }
    if (agentDistance(view, human, other) > distance) {
      return false;
    }
    ++members;
  }
  return members > 0;
}

constexpr double kSpotRadius = 0.1;        // [m]
constexpr double kFacingTolerance = 0.01;  // [rad]

struct Conversation {
  std::int64_t startStep;
  bool isTalking;   // all members were in place in the last step
  double duration;  // [s]
};

NodeStatus gather(LeafContext& leaf, const Members& members, const sim2d::GoalItem& place,
                  double duration) {
  HumanContext& context = humanOf(leaf);
  GroupNodeState& groupNodeState = context.groupNodeState(leaf);
  groupNodeState.centre = place.position;
  groupNodeState.spots = assignCirclePositions(context.view(), members, place.position);
  Conversation& memory = leaf.memory<Conversation>();
  memory.duration = duration;
  if (!context.hasQuirk(15)) {
    memory.isTalking = false;
  }
  groupNodeState.saved.clear();
  for (const FormationSpot& spot : groupNodeState.spots) {
    context.setActive(spot.human);
    if (context.hasQuirk(14)) {
      groupNodeState.saved.push_back(saveAgent(context, spot.human));
      context.control(spot.human).goals.push_back({0, spot.position, kSpotRadius});
    }
  }
  return NodeStatus::Running;
}

/// Q-14: the spot is appended to the member's goals, and the front goal is walked to.
std::optional<FormationSpot> spotInList(HumanContext& context, int human) {
  const std::vector<sim2d::GoalItem>& goals = context.control(human).goals;
  return goals.empty() ? std::nullopt
                       : std::optional<FormationSpot>({human, goals.front().position});
}

/// One step of one member; returns whether they are in place and face the centre.
bool moveMember(HumanContext& context, const FormationSpot& spot, const base::Vec2& centre) {
  const base::Vec2 position = context.view().pose(spot.human).position;
  if ((spot.position - position).norm() > kSpotRadius) {
    sim2d::Intent intent = walkTo(context, spot.human, {0, spot.position, kSpotRadius});
    intent.targetIsGoal = context.hasQuirk(14);
    intent.active = true;
    context.move(spot.human, intent, MotionOwner::Group);
    return false;
  }
  const MotionPlan plan = turnTo(context, spot.human, centre, kFacingTolerance);
  context.move(spot.human, plan.intent, MotionOwner::Group);
  return plan.isReached;
}

NodeStatus talk(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const GroupNodeState& groupNodeState = context.groupNodeState(leaf);
  bool isReady = true;
  for (const FormationSpot& own : groupNodeState.spots) {
    if (!context.view().isPresent(own.human)) {
      continue;
    }
    const std::optional<FormationSpot> spot =
        context.hasQuirk(14) ? spotInList(context, own.human) : std::optional<FormationSpot>(own);
    isReady = spot && moveMember(context, *spot, groupNodeState.centre) && isReady;
  }
  Conversation& memory = leaf.memory<Conversation>();
  if (!isReady) {
    memory.isTalking = false;
    return NodeStatus::Running;
  }
  if (!memory.isTalking) {
    memory.isTalking = true;
    memory.startStep = leaf.step();
  }
  if (!leaf.hasElapsed(memory.startStep, memory.duration)) {
    return NodeStatus::Running;
  }
  restoreAllGoals(leaf);
  return NodeStatus::Success;
}

constexpr const char* kNodes = R"(
Action ApproachAgent|People|Walks to another person, slower with decreasing distance, and looks at them from the closest distance.
agent_id target_agent_id time_step duration
closest_dist length default 1.5|Distance at which the person stops.
max_vel speed default 1.5|Speed far from the other person.
Action FollowAgent|People|Follows another person at the person's own speed, at most max_vel if given, and slower within the closest distance.
agent_id target_agent_id time_step duration
closest_dist length default 1.5|Distance within which the person slows down.
max_vel speed atMost 10 suggest 1.5|Maximum speed while following; absent or negative: the person's own.
Action BlockAgent|People|Walks to a position in front of another person and faces them.
agent_id target_agent_id time_step duration
front_dist length needed suggest 1.0|Distance in front of the other person.
Condition IsAgentVisible|Perception|Another person is within the distance and the field of view, and no wall hides them.
observer_id int needed suggest {id}|Id of the person who looks.
agent_id int needed suggest 2|Id of the other person.
distance length default 5.0|Maximum distance of visible people.
field_of_view angle range 0 6.283185307179586 default 1.7407963267948966|Half of the field of view: the angle to each side, pi: all around.
Condition IsAgentClose|Perception|Another person is nearer than the threshold.
observer_id int needed suggest {id}|Id of the first person.
target_agent_id
threshold length default 1.0|Distance below which a person is close.
Action ConversationFormation|Groups|Gathers people in a circle around a goal, facing its centre, and keeps them there for the conversation. This node controls the members instead of their own trees.
main_agent_id int needed suggest {id}|Id of the person who gathers the others.
goal_id int unless center_x center_y suggest 1|Id of the global goal that is the centre.
center_x metres|x of a point, if no goal_id is given.
center_y metres|y of a point, if no goal_id is given.
conversation_duration duration default 10.0|Duration after all members are in place.
non_main_agent_ids time_step
Condition IsCrowded own|Perception|At least this number of other people are near.
agent_id int needed suggest {id}|Id of the person.
distance length default 2.0|Distance within which people are near.
count int range 1 1000 default 3|Number of other people.
Condition IsAgentGroupFormed own|Groups|All other members of the person's group are near; fails without a group.
agent_id distance
Action WaitForAgent own|People|Stands until another person is near, including a person who has not entered yet.
agent_id
target_agent_id int needed suggest 2|Id of the person to wait for.
distance
duration duration atMost 36000 default 0.0|Fails after this time; 0: unlimited.
Action FleeFrom own|People|Walks away from another person to the safe distance.
agent_id
target_agent_id int needed suggest 2|Id of the person to flee from.
safe_distance length default 5.0|Distance at which the node ends.
duration duration atMost 36000 default 0.0|Ends after this time; 0: unlimited.
speed speed default 1.5|Speed while fleeing.
Action FindNearestAgent|People|Writes the id of the nearest other person; fails if there is none.
agent_id
target_agent_id int output suggest {target_agent_id}|Id of the nearest person.
)";

}  // namespace

void addAgents(NodeLibrary& to) {
  to.add(
      humanManifests(kNodes),
      {{"ApproachAgent", stateful<Memory>({start<true>, ifPresentThen<Memory, step<approaching>>})},
       {"FollowAgent", stateful<Memory>({start<true>, ifPresentThen<Memory, step<following>>})},
       {"BlockAgent", stateful<Memory>({start<false>, ifPresentThen<Memory, step<blocking>>})},
       {"IsAgentVisible", synchronous(withPorts<isAgentVisible, 0, 1, 2, 3>)},
       {"IsAgentClose", synchronous(withPorts<isClose, 0, 1, 2>)},
       {"ConversationFormation",
        stateful<Conversation>({withPorts<gather, 5, 1, 4>, talk, restoreAllGoals})},
       {"IsCrowded", synchronous(withPorts<isCrowded, 0, 1, 2>)},
       {"IsAgentGroupFormed", synchronous(withPorts<isGroupFormed, 0, 1>)},
       {"WaitForAgent",
        stateful<Memory>({withPorts<startWait, 1, 0, 2, 3>, ifPresentThen<Memory, wait>})},
       {"FleeFrom",
        stateful<Memory>({withPorts<startFlee, 1, 0, 2, 3, 4>, ifPresentThen<Memory, flee>})},
       {"FindNearestAgent", synchronous(withPorts<findNearest, 0>)}});
}

}  // namespace bt

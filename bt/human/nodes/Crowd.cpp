#include "bt/human/HumanContext.h"
#include "bt/human/Motions.h"
#include "bt/human/Perception.h"

/// Nodes about surrounding people. Except for FindNearestAgent they do not exist in HuNavSim.
namespace bt {

namespace {

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

struct Memory {
  std::int64_t startStep;
  int human;
  int target;
  double distance;  // [m]
  double duration;  // [s]
  double speed;     // [m/s]
};

NodeStatus startWait(LeafContext& leaf, AgentOrAbsent target, AgentIndex human, double distance,
                     double duration) {
  return begin(leaf, Memory{leaf.step(), human, target.index, distance, duration, 0.0});
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
  return begin(leaf, Memory{leaf.step(), human, target, distance, duration, speed});
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

constexpr const char* kNodes = R"(
Condition IsCrowded own|Perception|At least this number of other people are near.
agent_id
distance length default 2.0|Distance within which people are near.
count int range 1 1000 default 3|Number of other people.
Condition IsAgentGroupFormed own|Groups|All other members of the person's group are near; fails without a group.
agent_id distance
Action WaitForAgent own|People|Stands until another person is near, also one who has not entered yet.
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

void addCrowd(NodeLibrary& to) {
  const NodeCatalogue nodes = humanManifests(kNodes);
  to.addCondition(*nodes.find("IsCrowded"), withPorts<isCrowded, 0, 1, 2>);
  to.addCondition(*nodes.find("IsAgentGroupFormed"), withPorts<isGroupFormed, 0, 1>);
  to.addStateful<Memory>(*nodes.find("WaitForAgent"),
                         {withPorts<startWait, 1, 0, 2, 3>, ifPresentThen<Memory, wait>});
  to.addStateful<Memory>(*nodes.find("FleeFrom"),
                         {withPorts<startFlee, 1, 0, 2, 3, 4>, ifPresentThen<Memory, flee>});
  to.addAction(*nodes.find("FindNearestAgent"), withPorts<findNearest, 0>);
}

}  // namespace bt

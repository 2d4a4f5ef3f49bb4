#include "bt/human/HumanContext.h"
#include "bt/human/Motions.h"
#include "bt/human/Perception.h"

/// Nodes about another person: the stateful actions ApproachAgent, FollowAgent and BlockAgent; the
/// conditions IsAgentVisible and IsAgentClose.
namespace bt {

namespace {

constexpr double kOwnSpeed = -1.0;  // [m/s] FollowAgent without max_vel

struct Memory {
  std::int64_t startStep;
  int human;
  int target;
  double duration;  // [s]
  double distance;  // closest or front distance [m]
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
)";

}  // namespace

void addAgents(NodeLibrary& to) {
  const NodeCatalogue nodes = humanManifests(kNodes);
  to.addStateful<Memory>(*nodes.find("ApproachAgent"),
                         {start<true>, ifPresentThen<Memory, step<approaching>>});
  to.addStateful<Memory>(*nodes.find("FollowAgent"),
                         {start<true>, ifPresentThen<Memory, step<following>>});
  to.addStateful<Memory>(*nodes.find("BlockAgent"),
                         {start<false>, ifPresentThen<Memory, step<blocking>>});
  to.addCondition(*nodes.find("IsAgentVisible"), withPorts<isAgentVisible, 0, 1, 2, 3>);
  to.addCondition(*nodes.find("IsAgentClose"), withPorts<isClose, 0, 1, 2>);
}

}  // namespace bt

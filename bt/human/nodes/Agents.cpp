#include "bt/human/Motions.h"
#include "bt/human/Perception.h"
#include "bt/human/Ports.h"

/// Nodes about another person: ApproachAgent, FollowAgent and BlockAgent, which last;
/// IsAgentVisible and IsAgentClose.
namespace bt {

namespace {

constexpr double kOwnSpeed = -1.0;  // [m/s]; of FollowAgent without max_vel

struct Memory {
  std::int64_t startStep;
  int human;
  int target;
  double duration;  // [s]
  double distance;  // closest or in front [m]
  double speed;     // [m/s]
};

/// Ports: 0 agent, 1 target, 2 time step, 3 duration, 4 distance, 5 speed where there is one.
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
  context.move(memory.human, motion(context, memory, personTarget(context.view(), memory.target)));
  return byDuration(leaf, memory.startStep, memory.duration);
}

sim2d::Intent approaching(HumanContext& context, const Memory& memory, const Target& target) {
  const double distance = personDistance(context.view(), memory.human, memory.target);
  if (context.isOriginal(13) && distance <= memory.distance) {
    context.control(memory.human).frozen = true;
  }
  return approach(context, memory.human, target, {memory.distance, memory.speed});
}

sim2d::Intent following(HumanContext& context, const Memory& memory, const Target& target) {
  return follow(context, memory.human, target, {memory.distance, memory.speed});
}

sim2d::Intent blocking(HumanContext& context, const Memory& memory, const Target& target) {
  return blockPerson(context, memory.human, target, memory.distance);
}

bool isClose(HumanContext& context, Person observer, Person target, double threshold) {
  return personDistance(context.view(), observer, target) < threshold;
}

constexpr const char* kNodes = R"(
Action ApproachAgent|People|Walks to another person, slower the nearer, and looks at them from the closest distance.
agent_id target_agent_id time_step duration
closest_dist length default 1.5|Comes this near.
max_vel speed default 1.5|Speed far from the other.
Action FollowAgent|People|Walks behind another person: with the own speed, at most max_vel if given, and slower within the closest distance.
agent_id target_agent_id time_step duration
closest_dist length default 1.5|Falls back within this.
max_vel speed atMost 10 suggest 1.5|Highest speed while following; absent or negative: the own.
Action BlockAgent|People|Walks to the place in front of another person and faces them.
agent_id target_agent_id time_step duration
front_dist length needed suggest 1.0|Place in front of the other person.
Condition IsAgentVisible|Perception|Another person is near enough, within the field of view, and no wall hides them.
observer_id int needed suggest {id}|Id of the person who looks.
agent_id int needed suggest 2|Id of the person looked for.
distance length default 5.0|People are seen up to here.
field_of_view angle range 0 6.283185307179586 default 1.7407963267948966|Half of the field of view: the angle to each side, pi = all around.
Condition IsAgentClose|Perception|Another person is nearer than the threshold.
observer_id int needed suggest {id}|Id of the first person.
target_agent_id
threshold length default 1.0|Nearer than this is close.
)";

}  // namespace

void addAgents(NodeLibrary& to) {
  const NodeCatalogue nodes = humanManifests(kNodes);
  to.addStateful<Memory>(*nodes.find("ApproachAgent"),
                         {start<true>, whilePresent<Memory, step<approaching>>});
  to.addStateful<Memory>(*nodes.find("FollowAgent"),
                         {start<true>, whilePresent<Memory, step<following>>});
  to.addStateful<Memory>(*nodes.find("BlockAgent"),
                         {start<false>, whilePresent<Memory, step<blocking>>});
  to.addCondition(*nodes.find("IsAgentVisible"), withPorts<isPersonVisible, 0, 1, 2, 3>);
  to.addCondition(*nodes.find("IsAgentClose"), withPorts<isClose, 0, 1, 2>);
}

}  // namespace bt

#include "bt/human/HumanContext.h"
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
  double distance;  // closest or in front [m]
  double speed;     // [m/s]
  double duration;  // [s]
};

/// Ports: 0 agent, 1 target, 2 time step, 3 duration, 4 distance, 5 speed where there is one.
NodeStatus start(LeafContext& leaf, bool hasSpeed) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> human = context.person(leaf, 0);
  const std::optional<int> target = context.person(leaf, 1);
  const double duration = leaf.require<double>(3);
  const double distance = leaf.require<double>(4);
  const double speed = hasSpeed ? leaf.getOr<double>(5, kOwnSpeed) : 0.0;
  if (!human || !target) {
    return NodeStatus::Failure;
  }
  leaf.memory<Memory>() = {leaf.step(), *human, *target, distance, speed, duration};
  context.setActive(*human);
  return NodeStatus::Running;
}

NodeStatus startWithSpeed(LeafContext& leaf) {
  return start(leaf, true);
}
NodeStatus startWithoutSpeed(LeafContext& leaf) {
  return start(leaf, false);
}

using Step = sim2d::Intent (*)(HumanContext&, const Memory&, const Target& target);

template <Step step>
NodeStatus run(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const Memory& memory = leaf.memory<Memory>();
  if (!context.view().isPresent(memory.human) || !context.view().isPresent(memory.target)) {
    return NodeStatus::Failure;
  }
  context.move(memory.human, step(context, memory, personTarget(context.view(), memory.target)));
  return byDuration(leaf, memory.startStep, memory.duration);
}

sim2d::Intent approachStep(HumanContext& context, const Memory& memory, const Target& target) {
  const double distance = personDistance(context.view(), memory.human, memory.target);
  if (context.isOriginal(13) && distance <= memory.distance) {
    context.control(memory.human).frozen = true;
  }
  return approach(context, memory.human, target, {memory.distance, memory.speed});
}

sim2d::Intent followStep(HumanContext& context, const Memory& memory, const Target& target) {
  return follow(context, memory.human, target, {memory.distance, memory.speed});
}

sim2d::Intent blockStep(HumanContext& context, const Memory& memory, const Target& target) {
  return blockPerson(context, memory.human, target, memory.distance);
}

NodeManifest actionTowards(const char* id, const char* description,
                           std::initializer_list<PortSpec> more) {
  NodeManifest manifest =
      humanNode(id, "People", description,
                {port::agent(), port::person("target_agent_id", "Id of the other person.", "2"),
                 port::timeStep(), port::lasting()});
  manifest.ports.insert(manifest.ports.end(), more.begin(), more.end());
  return manifest;
}

NodeStatus isVisible(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> observer = context.person(leaf, 0);
  const std::optional<int> target = context.person(leaf, 1);
  const double distance = leaf.require<double>(2);
  const double halfView = leaf.require<double>(3);
  return successIf(observer && target &&
                   isPersonVisible(context.view(), *observer, *target, distance, halfView));
}

NodeStatus isClose(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> observer = context.person(leaf, 0);
  const std::optional<int> target = context.person(leaf, 1);
  const double threshold = leaf.require<double>(2);
  return successIf(observer && target &&
                   personDistance(context.view(), *observer, *target) < threshold);
}

}  // namespace

void addAgents(NodeLibrary& to) {
  to.addStateful<Memory>(
      actionTowards("ApproachAgent",
                    "Walks to another person, slower the nearer, and looks at them from the "
                    "closest distance.",
                    {port::length("closest_dist", "Comes this near.").byDefault("1.5"),
                     port::speed("max_vel", "Speed far from the other.").byDefault("1.5")}),
      {startWithSpeed, run<approachStep>, nullptr});
  to.addStateful<Memory>(
      actionTowards(
          "FollowAgent",
          "Walks behind another person: with the own speed, at most max_vel if given, "
          "and slower within the closest distance.",
          {port::length("closest_dist", "Falls back within this.").byDefault("1.5"),
           port::speed("max_vel", "Highest speed while following; absent or negative: the own.")
               .atMost(10.0)
               .suggest("1.5")}),
      {startWithSpeed, run<followStep>, nullptr});
  to.addStateful<Memory>(
      actionTowards("BlockAgent", "Walks to the place in front of another person and faces them.",
                    {port::length("front_dist", "Place in front of the other person.")
                         .needed()
                         .suggest("1.0")}),
      {startWithoutSpeed, run<blockStep>, nullptr});
  to.addCondition(
      humanNode("IsAgentVisible", "Perception",
                "Another person is near enough, within the field of view, and no wall hides them.",
                {port::person("observer_id", "Id of the person who looks."),
                 port::person("agent_id", "Id of the person looked for.", "2"),
                 port::length("distance", "People are seen up to here.").byDefault("5.0"),
                 port::angle("field_of_view",
                             "Half of the field of view: the angle to each side, pi = all around.")
                     .byDefault("1.7407963267948966")
                     .range(0.0, 2.0 * base::kPi)},
                NodeKind::Condition),
      isVisible);
  to.addCondition(
      humanNode("IsAgentClose", "Perception", "Another person is nearer than the threshold.",
                {port::person("observer_id", "Id of the first person."),
                 port::person("target_agent_id", "Id of the other person.", "2"),
                 port::length("threshold", "Nearer than this is close.").byDefault("1.0")},
                NodeKind::Condition),
      isClose);
}

}  // namespace bt

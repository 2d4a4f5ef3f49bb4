#include "bt/human/HumanContext.h"
#include "sim2d/base/Rng.h"

/// Random nodes: the control ProbabilityChoice (not in HuNavSim) and a condition.
namespace bt {

namespace {

constexpr std::uint32_t kNodeBits = 18;  // bits of kMaxProgramNodes

/// Uniform in [0, 1); identical for the same person, step and `number`.
double drawn(LeafContext& leaf, std::uint32_t number) {
  const HumanContext& context = humanOf(leaf);
  const sim2d::WorldView& view = context.view();
  const base::AgentRng random(view.seed(), context.idOf(context.self()),
                              static_cast<std::uint64_t>(view.step()));
  return random.uniform01(base::DrawPurpose::NodeChance, number);
}

struct Memory {
  std::int64_t drawStep;  // step of the last draw
  std::uint32_t draws;    // draws in that step before the last one
  std::int32_t chosen;    // child + 1; 0: none
};

/// Without the port all weights are equal. Empty: the weights are invalid, the tree is faulty.
std::vector<double> weightsOf(ParentContext& leaf) {
  const auto count = static_cast<std::size_t>(leaf.childCount());
  const std::optional<std::string> text = leaf.text(0);
  if (!text) {
    return std::vector<double>(count, 1.0);
  }
  std::optional<std::vector<double>> weights = parseWeights(*text);
  if (!weights || weights->size() != count) {
    leaf.fault("input 'weights' is '" + *text +
               "' (one number per child, separated by ';', none below 0, one above 0)");
    return {};
  }
  return *std::move(weights);
}

/// A new value in every step and for every start within a step.
double draw(ParentContext& leaf) {
  Memory& memory = leaf.memory<Memory>();
  memory.draws = memory.drawStep == leaf.step() ? memory.draws + 1 : 0;
  memory.drawStep = leaf.step();
  return drawn(leaf, static_cast<std::uint32_t>(leaf.node()) + (memory.draws << kNodeBits));
}

int choose(const std::vector<double>& weights, double random) {
  double sum = 0.0;
  for (const double weight : weights) {
    sum += weight;
  }
  double left = random * sum;
  int chosen = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > 0.0) {
      chosen = static_cast<int>(i);  // the last one covers rounding errors
      if (left < weights[i]) {
        break;
      }
      left -= weights[i];
    }
  }
  return chosen;
}

NodeStatus tick(ParentContext& leaf) {
  Memory& memory = leaf.memory<Memory>();
  if (memory.chosen == 0) {
    const std::vector<double> weights = weightsOf(leaf);
    if (weights.empty()) {
      return NodeStatus::Failure;
    }
    memory.chosen = choose(weights, draw(leaf)) + 1;
  }
  const NodeStatus status = leaf.tickChild(memory.chosen - 1);
  if (status != NodeStatus::Running) {
    memory.chosen = 0;
  }
  return status;
}

void halt(ParentContext& leaf) {
  leaf.memory<Memory>().chosen = 0;
}

NodeStatus drawChance(LeafContext& leaf) {
  const double draw = drawn(leaf, static_cast<std::uint32_t>(leaf.node()));
  return successIf(draw < leaf.require<double>(0));
}

constexpr const char* kNodes = R"(
Control ProbabilityChoice own|Timing|Selects a random child when it is started and runs it to completion.
weights queue suggest 3;1|Relative probability of each child; absent: all equal.
Condition RandomChanceCondition|Timing|Succeeds with the given probability, drawn again in every tick, so that the probability over n ticks is 1 - (1 - p)^n.
probability number range 0 1 default 0.3|Probability per tick.
agent_id int|Accepted for existing files; has no effect.
)";

}  // namespace

void addRandomChoices(NodeLibrary& to) {
  to.add(humanManifests(kNodes), {{"ProbabilityChoice", control<Memory>({tick, halt})},
                                  {"RandomChanceCondition", synchronous(drawChance)}});
}

}  // namespace bt

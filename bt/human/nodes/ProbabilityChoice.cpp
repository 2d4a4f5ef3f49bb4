#include <cmath>
#include <string_view>

#include "bt/human/Leaves.h"
#include "bt/human/Ports.h"
#include "sim2d/base/Rng.h"
#include "sim2d/base/Text.h"

namespace bt {

namespace {

constexpr std::uint32_t kNodeBits = 18;  // of kMaxProgramNodes

struct Memory {
  std::int64_t drawStep;  // of the last draw
  std::uint32_t draws;    // in that step, the last one not counted
  std::int32_t chosen;    // child + 1; 0 = none
};

/// The next weight of "3;1;1"; nothing when it is none.
std::optional<double> takeWeight(std::string_view& rest) {
  const std::size_t end = rest.find(';');
  const std::optional<double> weight = base::parseDouble(base::trimmed(rest.substr(0, end)));
  rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  return weight && std::isfinite(*weight) && *weight >= 0.0 ? weight : std::nullopt;
}

/// Without the port all children weigh the same. Empty = they are wrong, the tree is faulty.
std::vector<double> weightsOf(ControlContext& leaf) {
  const auto count = static_cast<std::size_t>(leaf.childCount());
  const std::optional<std::string> text = leaf.text(0);
  if (!text) {
    return std::vector<double>(count, 1.0);
  }
  std::vector<double> weights;
  double sum = 0.0;
  for (std::string_view rest = *text; !rest.empty() && weights.size() <= count;) {
    const std::optional<double> weight = takeWeight(rest);
    if (!weight) {
      leaf.fault("input 'weights' is '" + *text + "' (numbers of 0 or more with ';' between)");
      return {};
    }
    weights.push_back(*weight);
    sum += *weight;
  }
  if (weights.size() != count || !(sum > 0.0) || !std::isfinite(sum)) {
    leaf.fault("input 'weights' is '" + *text + "' (one per child, at least one above 0)");
    return {};
  }
  return weights;
}

/// New in every step, and for every start within one.
double draw(ControlContext& leaf) {
  Memory& memory = leaf.memory<Memory>();
  memory.draws = memory.drawStep == leaf.step() ? memory.draws + 1 : 0;
  memory.drawStep = leaf.step();
  const HumanContext& context = humanOf(leaf);
  const base::AgentRng random(context.view().seed(), context.idOf(context.self()),
                              static_cast<std::uint64_t>(context.view().step()));
  return random.uniform01(base::Draw::NodeChance,
                          static_cast<std::uint32_t>(leaf.node()) + (memory.draws << kNodeBits));
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
      chosen = static_cast<int>(i);  // the last one stands in for what rounding leaves
      if (left < weights[i]) {
        break;
      }
      left -= weights[i];
    }
  }
  return chosen;
}

NodeStatus tick(ControlContext& leaf) {
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

void halt(ControlContext& leaf) {
  leaf.memory<Memory>().chosen = 0;
}

}  // namespace

void addProbabilityChoice(NodeLibrary& to) {
  to.addControl<Memory>(
      ownNode("ProbabilityChoice", "Timing",
              "Draws one of its children when it is reached and runs that one to its end.",
              {Port("weights", PortType::Queue, "",
                    "One number per child, how often it is drawn; left out: all alike.")
                   .suggest("3;1")},
              NodeKind::Control),
      {tick, halt});
}

}  // namespace bt

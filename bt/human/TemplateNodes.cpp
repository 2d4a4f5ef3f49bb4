#include "bt/human/TemplateNodes.h"

#include <array>
#include <charconv>
#include <utility>

namespace bt {

NodeSpec leafNode(std::string id, Attributes ports) {
  NodeSpec node;
  node.id = std::move(id);
  node.ports = std::move(ports);
  return node;
}

NodeSpec branchNode(std::string id, std::string name, std::vector<NodeSpec> children) {
  NodeSpec node;
  node.id = std::move(id);
  node.name = std::move(name);
  node.children = std::move(children);
  return node;
}

NodeSpec around(std::string decorator, NodeSpec child) {
  return branchNode(std::move(decorator), {}, {std::move(child)});
}

std::string shortNumber(double value) {
  std::array<char, 32> text{};
  const std::to_chars_result end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
  return {text.data(), end.ptr};
}

NodeSpec setGoalsBlock(const std::vector<int>& goals) {
  NodeSpec block = branchNode("Sequence", "SetGoals", {});
  for (const int goal : goals) {
    block.children.push_back(around(
        "RunOnce", leafNode("SetGoal", {{"agent_id", "{id}"}, {"goal_id", std::to_string(goal)}})));
  }
  if (!block.children.empty()) {  // fails in the first tick, so that the person walks on at once
    block.children.back() = around("Inverter", std::move(block.children.back()));
  }
  return block;
}

}  // namespace bt

#include "bt/human/TemplateNodes.h"

#include <array>
#include <cassert>
#include <charconv>
#include <utility>

#include "sim2d/base/Text.h"

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

NodeSpec nodeFrom(const std::string& text) {
  const std::size_t link = text.find('>');
  if (link != std::string::npos) {
    return around(text.substr(0, link), nodeFrom(text.substr(link + 1)));
  }
  const std::vector<std::string> words = base::split(text, ' ');
  NodeSpec node = leafNode(words.front(), {});
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::size_t sign = words[i].find('=');
    assert(sign != std::string::npos);
    node.ports.push_back({words[i].substr(0, sign), words[i].substr(sign + 1)});
  }
  return node;
}

NodeSpec around(const std::string& decorator, NodeSpec child) {
  NodeSpec node = nodeFrom(decorator);
  node.children.push_back(std::move(child));
  return node;
}

NodeSpec onceAndFail(NodeSpec child) {
  return around("RunOnce then_skip=false", around("ForceFailure", std::move(child)));
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
    block.children.push_back(
        nodeFrom("RunOnce>SetGoal agent_id={id} goal_id=" + std::to_string(goal)));
  }
  if (!block.children.empty()) {  // fails in the first tick, so that the person walks on at once
    block.children.back() = around("Inverter", std::move(block.children.back()));
  }
  return block;
}

}  // namespace bt

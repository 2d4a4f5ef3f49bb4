#include "bt/human/BehaviorBlocks.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "bt/human/TreeGenerator.h"
#include "sim2d/base/Text.h"

namespace bt {

namespace {

using Values = std::map<std::string, std::string>;

constexpr const char* kBlockSuffix = "Block";
constexpr const char* kRandomEnd = "RandomBlock";

/// Person ids without blanks: "2, 3" -> {"2", "3"}.
std::vector<std::string> parseAgentIds(const std::string& text) {
  std::vector<std::string> ids;
  for (std::string id : base::split(text, ',')) {
    id.erase(std::remove(id.begin(), id.end(), ' '), id.end());
    if (!id.empty()) {
      ids.push_back(std::move(id));
    }
  }
  return ids;
}

void fill(NodeSpec& node, const Block& block) {
  for (Attribute& port : node.ports) {
    if (!port.text.empty() && port.text[0] == '$') {
      port.text = block.value(port.text.substr(1));
    }
  }
  for (NodeSpec& child : node.children) {
    fill(child, block);
  }
}

bool matches(const NodeSpec& pattern, const NodeSpec& found, Values& values) {
  if (pattern.id != found.id || pattern.children.size() != found.children.size() ||
      !found.conditions.empty()) {
    return false;
  }
  std::size_t known = 0;
  for (const Attribute& port : pattern.ports) {
    const std::string* text = findAttribute(found.ports, port.name);
    known += text != nullptr ? 1 : 0;
    if (port.text[0] == '$') {
      const std::string key = port.text.substr(1);
      const bool same = text != nullptr && (values.count(key) == 0 || values[key] == *text);
      if (!same || referencedKey(*text, port.name)) {
        return false;
      }
      values[key] = *text;
    } else if (text == nullptr || *text != port.text) {
      return false;
    }
  }
  if (known != found.ports.size()) {
    return false;
  }
  for (std::size_t i = 0; i < pattern.children.size(); ++i) {
    if (!matches(pattern.children[i], found.children[i], values)) {
      return false;
    }
  }
  return true;
}

bool isCondition(const NodeSpec& node) {
  return node.id.compare(0, 2, "Is") == 0 || node.id == "FindNearestAgent";
}

/// Wraps the actions in RunOnce{ForceFailure{Sequence}}: they run once and do not block later
/// branches.
std::vector<NodeSpec> wrapActionsInRunOnce(std::vector<NodeSpec> children) {
  const auto first = std::find_if_not(children.begin(), children.end(), isCondition);
  std::vector<NodeSpec> actions(std::make_move_iterator(first),
                                std::make_move_iterator(children.end()));
  children.erase(first, children.end());
  children.push_back(runOnceAndFail(branchNode("Sequence", "Actions", std::move(actions))));
  return children;
}

/// The children without the nodes that make them run once; empty if there are none.
std::optional<std::vector<NodeSpec>> unwrapRunOnce(const std::vector<NodeSpec>& children) {
  const auto isOnce = [](const NodeSpec& node) {
    return node.id == "RunOnce" && node.children.size() == 1;
  };
  if (!children.empty() && std::all_of(children.begin(), children.end(), isOnce)) {
    const NodeSpec& only = children.front().children.front();
    if (children.size() > 1 || only.id != "ForceFailure") {  // form written by the wizard
      std::vector<NodeSpec> bare;
      bare.reserve(children.size());
      for (const NodeSpec& child : children) {
        bare.push_back(child.children.front());
      }
      return bare;
    }
  }
  if (children.empty() || !isOnce(children.back())) {
    return std::nullopt;
  }
  const NodeSpec& failure = children.back().children.front();
  if (failure.id != "ForceFailure" || failure.children.size() != 1) {
    return std::nullopt;
  }
  std::vector<NodeSpec> bare(children.begin(), children.end() - 1);
  const std::vector<NodeSpec>& actions = failure.children.front().children;
  bare.insert(bare.end(), actions.begin(), actions.end());
  return bare;
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Parameter values of the children in the first mode that matches.
std::optional<Values> readChildren(const BlockType& kind, const std::vector<NodeSpec>& children) {
  if (children.empty()) {
    return std::nullopt;
  }
  const std::string* others = findAttribute(children.back().ports, "non_main_agent_ids");
  const std::vector<std::string> people =
      parseAgentIds(others != nullptr ? *others : std::string());
  for (const auto& [mode, lines] : kind.nodes) {
    const std::vector<NodeSpec> expected = kind.children(mode, people);
    Values values;
    bool fits = expected.size() == children.size();
    for (std::size_t i = 0; fits && i < expected.size(); ++i) {
      fits = matches(expected[i], children[i], values);
    }
    if (fits) {
      if (!mode.empty()) {
        values["mode"] = mode;
      }
      return values;
    }
  }
  return std::nullopt;
}

bool isSetGoalsSequence(const NodeSpec& node) {
  return node.id == "Sequence" && node.name == "SetGoals";
}

template <class Condition>
void removeIf(std::vector<NodeSpec>& nodes, Condition condition) {
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), condition), nodes.end());
}

}  // namespace

const std::string& Block::value(const std::string& key) const {
  static const std::string kNothing;
  const auto found = values.find(key);
  if (found != values.end()) {
    return found->second;
  }
  const BlockType* kind = blockType(id);
  const BlockParameter* parameter = kind == nullptr ? nullptr : kind->parameter(key);
  return parameter == nullptr ? kNothing : parameter->initial;
}

bool operator==(const Block& a, const Block& b) {
  const BlockType* kind = blockType(a.id);
  if (a.id != b.id || a.repeat != b.repeat || kind == nullptr ||
      (a.repeat == BlockRepeat::Random && a.probability != b.probability)) {
    return false;
  }
  return std::all_of(
      kind->parameters.begin(), kind->parameters.end(), [&](const BlockParameter& parameter) {
        const bool used = parameter.mode.empty() || parameter.mode == a.value("mode");
        return !used || a.value(parameter.key) == b.value(parameter.key);
      });
}

NodeSpec blockToNode(const Block& block) {
  const BlockType* kind = blockType(block.id);
  if (kind == nullptr) {
    return {};
  }
  NodeSpec node = branchNode("Sequence", block.id + kBlockSuffix, {});
  node.children = kind->children(block.value("mode"), parseAgentIds(block.value("people")));
  fill(node, block);
  if (block.repeat == BlockRepeat::Once) {
    node.children = wrapActionsInRunOnce(std::move(node.children));
  } else if (block.repeat == BlockRepeat::Random) {
    NodeSpec chance =
        leafNode("RandomChanceCondition", {{"probability", shortNumber(block.probability)}});
    node = branchNode("Sequence", block.id + kRandomEnd, {std::move(chance), std::move(node)});
  }
  return node;
}

std::optional<Block> readBlock(const NodeSpec& node) {
  Block block;
  const NodeSpec* inner = &node;
  if (node.id == "Sequence" && endsWith(node.name, kRandomEnd) && node.children.size() == 2 &&
      node.children.front().id == "RandomChanceCondition") {
    const std::string* chance = findAttribute(node.children.front().ports, "probability");
    block.repeat = BlockRepeat::Random;
    block.probability = base::parseDouble(chance != nullptr ? *chance : "").value_or(0.3);
    inner = &node.children.back();
  }
  if (inner->id != "Sequence" || !endsWith(inner->name, kBlockSuffix)) {
    return std::nullopt;
  }
  block.id = inner->name.substr(0, inner->name.size() - std::string(kBlockSuffix).size());
  const BlockType* kind = blockType(block.id);
  if (kind == nullptr) {
    return std::nullopt;
  }
  std::optional<Values> values = readChildren(*kind, inner->children);
  if (!values && block.repeat == BlockRepeat::Always) {
    if (const auto bare = unwrapRunOnce(inner->children)) {
      values = readChildren(*kind, *bare);
      block.repeat = BlockRepeat::Once;
    }
  }
  if (!values) {
    return std::nullopt;
  }
  block.values = *std::move(values);
  return block;
}

std::vector<Block> blocksOf(const TreeSpec& tree) {
  std::vector<Block> blocks;
  for (const NodeSpec& child : tree.root.children) {
    if (std::optional<Block> block = readBlock(child)) {
      blocks.push_back(*std::move(block));
    }
  }
  return blocks;
}

bool setBlocks(TreeSpec& tree, const std::vector<Block>& blocks) {
  if (tree.root.id != "Fallback") {
    return false;
  }
  std::vector<NodeSpec>& children = tree.root.children;
  removeIf(children, [](const NodeSpec& child) { return readBlock(child).has_value(); });
  auto place = std::find_if(children.begin(), children.end(), isSetGoalsSequence);
  place = place == children.end() ? children.begin() : place + 1;
  for (const Block& block : blocks) {
    place = children.insert(place, blockToNode(block)) + 1;
  }
  return true;
}

bool setTreeGoals(TreeSpec& tree, const std::vector<int>& goals) {
  if (tree.root.id != "Fallback") {
    return false;
  }
  removeIf(tree.root.children, isSetGoalsSequence);
  if (!goals.empty()) {
    tree.root.children.insert(tree.root.children.begin(), setGoalsSequence(goals));
  }
  return true;
}

}  // namespace bt

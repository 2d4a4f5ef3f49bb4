#include "bt/human/TreeExport.h"

#include <algorithm>

#include "bt/human/Ports.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"

namespace bt {

namespace {

bool isGoalPort(const std::string& name) {
  return name == "goal_id";
}

/// One number, or several between commas; anything else (a key in braces) stays.
std::string replaced(const std::string& text, const std::map<int, int>& numbers) {
  std::string result;
  for (const std::string& part : base::split(text, ',')) {
    const std::string bare = base::trimmed(part);
    const std::optional<long long> number = base::parseInt(bare);
    const auto found = number ? numbers.find(static_cast<int>(*number)) : numbers.end();
    result += (result.empty() ? "" : ",") +
              (found == numbers.end() ? part : std::to_string(found->second));
  }
  return result;
}

int renumber(NodeSpec& node, const Renumbering& numbers) {
  int changed = 0;
  for (Attribute& port : node.ports) {
    if (!isGoalPort(port.name) && !isPersonPort(port.name)) {
      continue;
    }
    std::string text = replaced(port.text, isGoalPort(port.name) ? numbers.goals : numbers.people);
    if (text != port.text) {
      port.text = std::move(text);
      ++changed;
    }
  }
  for (NodeSpec& child : node.children) {
    changed += renumber(child, numbers);
  }
  return changed;
}

void collectOwn(const NodeSpec& node, const NodeCatalogue& catalogue,
                std::vector<std::string>& found) {
  const NodeManifest* manifest = catalogue.find(node.id);
  if (manifest != nullptr && manifest->origin == NodeOrigin::Ours &&
      std::find(found.begin(), found.end(), node.id) == found.end()) {
    found.push_back(node.id);
  }
  for (const NodeSpec& child : node.children) {
    collectOwn(child, catalogue, found);
  }
}

bool movesNothing(const std::map<int, int>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [](const auto& pair) { return pair.first == pair.second; });
}

}  // namespace

bool Renumbering::isNothing() const {
  return movesNothing(goals) && movesNothing(people);
}

std::string renumbered(const TreeFile& file, const std::string& text, const Renumbering& numbers,
                       const NodeCatalogue& catalogue, int& changed) {
  changed = 0;
  if (numbers.isNothing()) {
    return text;
  }
  TreeFile copy = file;
  for (TreeSpec& tree : copy.trees) {
    changed += renumber(tree.root, numbers);
  }
  return changed == 0 ? text : writeTree(copy, catalogue);
}

std::vector<std::string> ownNodes(const TreeFile& file, const NodeCatalogue& catalogue) {
  std::vector<std::string> found;
  for (const TreeSpec& tree : file.trees) {
    collectOwn(tree.root, catalogue, found);
  }
  return found;
}

}  // namespace bt

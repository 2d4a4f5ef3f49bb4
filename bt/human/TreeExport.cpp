#include "bt/human/TreeExport.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "bt/human/HumanContext.h"
#include "bt/tree/NodeCatalogue.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"

namespace bt {

namespace {

bool isGoalPort(const std::string& name) {
  return name == "goal_id";
}

/// A number without meaning must not become a valid one: it is moved out of the used range.
int newNumber(int old, const std::map<int, int>& numbers) {
  constexpr int kLargest = 1000000;  // of a goal
  const auto found = numbers.find(old);
  const bool isFree = numbers.empty() || old < 0 || old > kLargest;
  return found != numbers.end() ? found->second : isFree ? old : old + kLargest;
}

/// One number, or several separated by commas; anything else (a key in braces) is unchanged.
std::string replaced(const std::string& text, const std::map<int, int>& numbers) {
  std::string result;
  for (const std::string& part : base::split(text, ',')) {
    const std::optional<int> old = intFromText(base::trimmed(part));
    const int now = old ? newNumber(*old, numbers) : 0;
    result += (result.empty() ? "" : ",") + (old && now != *old ? std::to_string(now) : part);
  }
  return result;
}

/// Kind of the numbers that a port takes.
enum class Kind { None, Goal, Person };
Kind kindOf(const std::string& port) {
  return isGoalPort(port) ? Kind::Goal : isAgentPort(port) ? Kind::Person : Kind::None;
}

/// Finds the blackboard entries of each tree that reach a port with numbers, also through SubTrees.
class IdEntryKinds {
 public:
  explicit IdEntryKinds(const TreeFile& file) {
    for (bool isNew = true; isNew;) {
      isNew = false;
      for (const TreeSpec& tree : file.trees) {
        isNew = collect(tree.root, tree.id) || isNew;
      }
    }
  }
  /// Kind of a constant in this port of a node of the tree.
  Kind kind(const NodeSpec& node, const std::string& port, const std::string& tree) const {
    if (node.id == "SetBlackboard") {
      const std::string* const key = findAttribute(node.ports, "output_key");
      return port == "value" && key ? ofKey(tree, *key) : Kind::None;
    }
    return node.isSubTree() ? ofKey(node.subTree, port) : kindOf(port);
  }

 private:
  Kind ofKey(const std::string& tree, const std::string& key) const {
    const auto found = kinds_.find({tree, key});
    return found == kinds_.end() ? Kind::None : found->second;
  }
  bool add(const std::string& tree, const std::string& key, Kind kind) {
    return kind != Kind::None && kinds_.emplace(std::pair(tree, key), kind).second;
  }
  bool collect(const NodeSpec& node, const std::string& tree) {
    bool isNew = false;
    for (const Attribute& port : node.ports) {
      if (const std::optional<std::string> key = referencedKey(port.text, port.name)) {
        isNew = add(tree, *key, kind(node, port.name, tree)) || isNew;
      }
    }
    if (node.isSubTree() && node.autoRemap) {
      for (const auto& [place, kind] : std::map(kinds_)) {
        const bool isPassed =
            place.first == node.subTree && !findAttribute(node.ports, place.second);
        isNew = (isPassed && add(tree, place.second, kind)) || isNew;
      }
    }
    for (const NodeSpec& child : node.children) {
      isNew = collect(child, tree) || isNew;
    }
    return isNew;
  }

  std::map<std::pair<std::string, std::string>, Kind> kinds_;  // by tree and key
};

int renumber(NodeSpec& node, const std::string& tree, const IdEntryKinds& keys,
             const Renumbering& numbers) {
  int changed = 0;
  for (Attribute& port : node.ports) {
    const Kind kind = keys.kind(node, port.name, tree);
    if (kind == Kind::None) {
      continue;
    }
    std::string text = replaced(port.text, kind == Kind::Goal ? numbers.goals : numbers.people);
    if (text != port.text) {
      port.text = std::move(text);
      ++changed;
    }
  }
  for (NodeSpec& child : node.children) {
    changed += renumber(child, tree, keys, numbers);
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

bool isIdentityMapping(const std::map<int, int>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [](const auto& pair) { return pair.first == pair.second; });
}

}  // namespace

bool Renumbering::isIdentity() const {
  return isIdentityMapping(goals) && isIdentityMapping(people);
}

std::string renumbered(const TreeFile& file, const std::string& text, const Renumbering& numbers,
                       const NodeCatalogue& catalogue, int& changed) {
  changed = 0;
  if (numbers.isIdentity()) {
    return text;
  }
  TreeFile copy = file;
  const IdEntryKinds keys(file);
  Renumbering others;  // without identity mappings
  others.goals = isIdentityMapping(numbers.goals) ? others.goals : numbers.goals;
  others.people = isIdentityMapping(numbers.people) ? others.people : numbers.people;
  for (TreeSpec& tree : copy.trees) {
    changed += renumber(tree.root, tree.id, keys, others);
  }
  return changed == 0 ? text : writeTree(copy, catalogue);
}

std::vector<std::string> desktopOnlyNodes(const TreeFile& file, const NodeCatalogue& catalogue) {
  std::vector<std::string> found;
  for (const TreeSpec& tree : file.trees) {
    collectOwn(tree.root, catalogue, found);
  }
  return found;
}

}  // namespace bt

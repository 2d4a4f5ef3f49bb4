#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "bt/tree/TreeSpec.h"
#include "sim2d/base/Text.h"

/// Checks of a file with all that it includes.
namespace bt {
namespace {

TreeIds idsOf(const TreeTable& table) {
  TreeIds ids;
  for (const auto& [id, entry] : table.entries) {
    ids.insert(id);
  }
  return ids;
}

/// Looks for SubTrees that contain themselves.
class RecursionFinder {
 public:
  explicit RecursionFinder(const TreeTable& table) : table_(table) {}

  void visit(const TreeTable::Entry& entry);
  TreeIssues takeIssues() { return std::move(issues_); }

 private:
  void visit(const NodeSpec& node, const TreeTable::Entry& entry, NodePath& path);

  const TreeTable& table_;
  std::set<std::string> open_;
  std::set<std::string> done_;
  TreeIssues issues_;
  int depth_ = 0;
};

void RecursionFinder::visit(const TreeTable::Entry& entry) {
  constexpr int kMaxSubTreeDepth = 200;
  if (done_.count(entry.tree.id) > 0) {
    return;
  }
  if (depth_ >= kMaxSubTreeDepth) {
    issues_.push_back(
        {base::error("tree.subtrees-too-deep", {kMaxSubTreeDepth}, entry.file, entry.tree.line),
         entry.tree.id,
         {}});
    return;
  }
  ++depth_;
  open_.insert(entry.tree.id);
  NodePath path;
  visit(entry.tree.root, entry, path);
  open_.erase(entry.tree.id);
  done_.insert(entry.tree.id);
  --depth_;
}

void RecursionFinder::visit(const NodeSpec& node, const TreeTable::Entry& entry, NodePath& path) {
  if (node.isSubTree()) {
    const TreeTable::Entry* const called = table_.find(node.subTree);
    if (called && open_.count(node.subTree) > 0) {
      issues_.push_back({base::error("tree.contains-itself", {node.subTree, entry.tree.id},
                                     entry.file, node.line),
                         entry.tree.id, path});
    } else if (called) {
      visit(*called);
    }
  }
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    path.push_back(static_cast<int>(i));
    visit(node.children[i], entry, path);
    path.pop_back();
  }
}

void append(TreeIssues& to, TreeIssues more) {
  to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// Keys that are read, and keys that the trees give a value themselves.
void collectKeys(const NodeSpec& node, std::set<std::string>& read,
                 std::set<std::string>& written) {
  for (const Attribute& port : node.ports) {
    const std::optional<std::string> key = referencedKey(port.text, port.name);
    if (node.id == "SetBlackboard" && port.name == "output_key") {
      written.insert(key.value_or(port.text));
    } else if (key) {
      read.insert(*key);
    }
    if (node.isSubTree()) {
      written.insert(port.name);
    }
  }
  for (const NodeSpec& child : node.children) {
    collectKeys(child, read, written);
  }
}

/// "'A', 'B'"
std::string treesOf(const TreeTable& table) {
  constexpr std::size_t kShown = 5;
  std::vector<std::string> names;
  for (const auto& [id, entry] : table.entries) {
    names.push_back("'" + id + "'");
  }
  const bool isLong = names.size() > kShown;
  names.resize(std::min(names.size(), kShown));
  return base::join(names, ", ") + (isLong ? " …" : "");
}

base::Diagnostics fileProblems(const TreeTable& table) {
  base::Diagnostics problems;
  if (table.mainTree.empty()) {
    problems.push_back(base::error("tree.main-not-said", {}, table.file));
  } else if (!table.find(table.mainTree)) {
    problems.push_back(
        base::error("tree.main-unknown", {table.mainTree, treesOf(table)}, table.file));
  }
  for (const TreeTable::TemplateText& text : table.templates) {
    problems.push_back(base::error("tree.is-template", {}, text.file, text.line));
  }
  const std::vector<std::string> placeholders = placeholdersIn(table);
  if (!placeholders.empty()) {
    const std::string list = "{" + base::join(placeholders, "}, {") + "}";
    problems.push_back(base::warning("tree.placeholders", {list}, table.file));
  }
  return problems;
}

}  // namespace

TreeIssues checkTrees(const TreeTable& table, const NodeCatalogue& catalogue) {
  TreeIssues issues;
  const TreeIds ids = idsOf(table);
  RecursionFinder recursion(table);
  for (const auto& [id, entry] : table.entries) {
    append(issues, checkTree(entry.tree, catalogue, ids, entry.file));
    recursion.visit(entry);
  }
  append(issues, recursion.takeIssues());
  return issues;
}

TreeIssues checkTable(const TreeTable& table, const NodeCatalogue& catalogue) {
  TreeIssues issues;
  for (base::Diagnostic& problem : fileProblems(table)) {
    issues.push_back({std::move(problem), {}, {}});
  }
  append(issues, checkTrees(table, catalogue));
  return issues;
}

std::vector<std::string> placeholdersIn(const TreeTable& table) {
  std::set<std::string> read;
  std::set<std::string> written;
  for (const auto& [id, entry] : table.entries) {
    collectKeys(entry.tree.root, read, written);
  }
  std::vector<std::string> found;
  for (const char* const name : {"dist", "duration", "once", "maxvel", "forcefactor", "stopdist",
                                 "frontdist", "safe_distance"}) {
    if (read.count(name) > 0 && written.count(name) == 0) {
      found.emplace_back(name);
    }
  }
  return found;
}

}  // namespace bt

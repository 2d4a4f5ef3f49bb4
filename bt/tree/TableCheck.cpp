#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
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

void collectCalls(const NodeSpec& node, std::set<std::string>& called) {
  if (node.isSubTree()) {
    called.insert(node.subTree);
  }
  for (const NodeSpec& child : node.children) {
    collectCalls(child, called);
  }
}

/// "'A' (line 3), 'B' (line 8)"
std::string namesWithLines(const std::vector<const TreeTable::Entry*>& trees) {
  constexpr std::size_t kShown = 5;
  std::vector<std::string> names;
  names.reserve(trees.size());
  for (const TreeTable::Entry* const entry : trees) {
    names.push_back("'" + entry->tree.id + "' (line " + std::to_string(entry->tree.line) + ")");
  }
  const bool isLong = names.size() > kShown;
  names.resize(std::min(names.size(), kShown));
  return base::join(names, ", ") + (isLong ? " …" : "");
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
  if (std::optional<base::Diagnostic> problem = problemOfMainTree(table, table.mainTree)) {
    problems.push_back(*std::move(problem));
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
    append(issues, checkTree(entry.tree, catalogue, ids, entry.file, table.declaredNodes));
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

std::vector<const TreeTable::Entry*> uncalledTrees(const TreeTable& table) {
  std::set<std::string> called;
  std::vector<const TreeTable::Entry*> all;
  for (const auto& [id, entry] : table.entries) {
    collectCalls(entry.tree.root, called);
    all.push_back(&entry);
  }
  const auto isOwn = [&table](const TreeTable::Entry* entry) { return entry->file == table.file; };
  if (std::any_of(all.begin(), all.end(), isOwn)) {
    all.erase(std::stable_partition(all.begin(), all.end(), isOwn), all.end());
  }
  const auto isCalled = [&called](const TreeTable::Entry* entry) {
    return called.count(entry->tree.id) > 0;
  };
  all.erase(std::remove_if(all.begin(), all.end(), isCalled), all.end());
  std::sort(all.begin(), all.end(), [](const auto* a, const auto* b) {
    return std::tie(a->file, a->tree.line) < std::tie(b->file, b->tree.line);
  });
  return all;
}

std::optional<base::Diagnostic> problemOfMainTree(const TreeTable& table,
                                                  const std::string& mainTree) {
  if (table.entries.empty() && table.hasModel) {
    return base::error("tree.only-models", {}, table.file);
  }
  if (!mainTree.empty()) {
    return table.find(mainTree) ? std::nullopt
                                : std::optional(base::error(
                                      "tree.main-unknown", {mainTree, treesOf(table)}, table.file));
  }
  const std::vector<const TreeTable::Entry*> candidates = uncalledTrees(table);
  if (candidates.empty()) {
    return base::error("tree.main-not-said", {""}, table.file);
  }
  const TreeTable::Entry& first = *candidates.front();
  return base::error("tree.main-not-said", {namesWithLines(candidates)}, first.file,
                     first.tree.line);
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

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "bt/tree/TreeSpec.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"

namespace bt {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxIncludes = 1000;  // total; repeated includes count again

/// Resolves the includes depth first, so that later definitions override earlier ones.
class IncludeResolver {
 public:
  IncludeResolver(TreeTable& table, const PackageFolder& packages)
      : table_(table), packages_(packages) {}

  void add(const TreeFile& file, int depth);
  base::Diagnostics& problems() { return problems_; }

 private:
  void follow(const TreeFile& from, const Include& include, int depth);
  std::optional<std::string> pathOf(const TreeFile& from, const Include& include);
  const TreeFile* read(const std::string& path, const TreeFile& from, const Include& include);
  void error(const TreeFile& from, const Include& include, std::string_view code,
             base::ProblemValues values = {}) {
    problems_.push_back(base::error(code, std::move(values), from.path, include.line));
  }

  TreeTable& table_;
  const PackageFolder& packages_;
  base::Diagnostics problems_;
  std::map<std::string, TreeFile> files_;  // by path, each read once
  std::vector<std::string> open_;          // paths of the files that are currently being included
  int count_ = 0;
};

std::string normalPath(const std::string& path) {
  std::error_code none;
  const fs::path full = fs::weakly_canonical(path, none);
  return none ? path : full.string();
}

void IncludeResolver::add(const TreeFile& file, int depth) {
  open_.push_back(file.path.empty() ? file.path : normalPath(file.path));
  for (const Include& include : file.includes) {
    follow(file, include, depth + 1);
  }
  open_.pop_back();
  for (const TreeSpec& tree : file.trees) {
    table_.entries[tree.id] = {tree, file.path};
  }
  const std::vector<XmlElement> models =
      file.model ? file.model->children : std::vector<XmlElement>();
  table_.hasModel = table_.hasModel || file.model;
  for (const XmlElement& entry : models) {
    const std::string* const id = findAttribute(entry.attributes, "ID");
    if (entry.tag == "SubTree") {
      table_.subTreeModels.push_back(entry);
    } else if (id) {
      table_.declaredNodes.insert(*id);
    }
  }
  if (file.templateLine > 0) {
    table_.templates.push_back({file.path, file.templateLine});
  }
}

void IncludeResolver::follow(const TreeFile& from, const Include& include, int depth) {
  if (++count_ > kMaxIncludes) {
    if (count_ == kMaxIncludes + 1) {
      error(from, include, "tree.too-many-includes", {kMaxIncludes});
    }
    return;
  }
  const std::optional<std::string> path = pathOf(from, include);
  if (!path) {
    return;
  }
  if (depth > kMaxIncludeDepth) {
    error(from, include, "tree.includes-too-deep", {kMaxIncludeDepth});
    return;
  }
  if (std::find(open_.begin(), open_.end(), normalPath(*path)) != open_.end()) {
    error(from, include, "tree.includes-itself", {include.path});
    return;
  }
  if (const TreeFile* const file = read(*path, from, include)) {
    add(*file, depth);
  }
}

std::optional<std::string> IncludeResolver::pathOf(const TreeFile& from, const Include& include) {
  const fs::path path = include.path;
  if (include.path.empty()) {
    error(from, include, "tree.include-without-path");
    return std::nullopt;
  }
  if (path.is_absolute()) {
    return path.string();
  }
  if (!include.rosPackage.empty()) {
    const std::string folder = packages_ ? packages_(include.rosPackage) : std::string();
    if (folder.empty()) {
      error(from, include, "tree.unknown-package", {include.rosPackage});
      return std::nullopt;
    }
    return (fs::path(folder) / path).string();
  }
  return (fs::path(from.path).parent_path() / path).string();
}

const TreeFile* IncludeResolver::read(const std::string& path, const TreeFile& from,
                                      const Include& include) {
  const std::string key = normalPath(path);
  const auto known = files_.find(key);
  if (known != files_.end()) {
    return &known->second;
  }
  base::Result<TreeFile> file = readTree(path);
  base::append(problems_, file.diagnostics());
  if (!file) {
    error(from, include, "tree.include-unusable", {include.path});
    return nullptr;
  }
  return &files_.emplace(key, *std::move(file)).first->second;
}

}  // namespace

base::Result<TreeTable> resolveIncludes(const TreeFile& file, const PackageFolder& packages) {
  TreeTable table;
  table.file = file.path;
  IncludeResolver includer(table, packages);
  includer.add(file, 0);
  if (base::hasErrors(includer.problems())) {
    return includer.problems();
  }
  table.mainTree = file.mainTree;
  if (table.mainTree.empty() && file.trees.size() == 1) {
    table.mainTree = file.trees.front().id;
  } else if (table.mainTree.empty() && table.entries.size() == 1) {
    table.mainTree = table.entries.begin()->first;
  } else if (table.mainTree.empty()) {
    const std::vector<const TreeTable::Entry*> candidates = topLevelTrees(table);
    if (candidates.size() == 1) {
      const TreeTable::Entry& only = *candidates.front();
      table.mainTree = only.tree.id;
      includer.problems().push_back(
          base::warning("tree.main-chosen", {only.tree.id}, only.file, only.tree.line));
    }
  }
  return {std::move(table), includer.problems()};
}

base::Result<TreeTable> loadTrees(const std::string& path, const PackageFolder& packages) {
  const base::Result<TreeFile> file = readTree(path);
  if (!file) {
    return file.diagnostics();
  }
  return prependDiagnostics(file.diagnostics(), resolveIncludes(*file, packages));
}

/// Checks of a tree file with its includes resolved.
namespace {

TreeIds idsOf(const TreeTable& table) {
  TreeIds ids;
  for (const auto& [id, entry] : table.entries) {
    ids.insert(id);
  }
  return ids;
}

/// Finds SubTrees that contain themselves.
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

/// Collects the keys that are read and the keys that the trees write themselves.
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

std::string firstOf(std::vector<std::string> names) {
  constexpr std::size_t kShown = 5;
  const bool isLong = names.size() > kShown;
  names.resize(std::min(names.size(), kShown));
  return base::join(names, ", ") + (isLong ? " …" : "");
}

/// "'A' (line 3), 'B' (line 8)"
std::string namesWithLines(const std::vector<const TreeTable::Entry*>& trees) {
  std::vector<std::string> names;
  names.reserve(trees.size());
  for (const TreeTable::Entry* const entry : trees) {
    names.push_back("'" + entry->tree.id + "' (line " + std::to_string(entry->tree.line) + ")");
  }
  return firstOf(std::move(names));
}

/// "'A', 'B'"
std::string treesOf(const TreeTable& table) {
  std::vector<std::string> names;
  for (const auto& [id, entry] : table.entries) {
    names.push_back("'" + id + "'");
  }
  return firstOf(std::move(names));
}

base::Diagnostics fileProblems(const TreeTable& table) {
  base::Diagnostics problems;
  if (std::optional<base::Diagnostic> problem = mainTreeProblem(table, table.mainTree)) {
    problems.push_back(*std::move(problem));
  }
  for (const TreeTable::TemplatePlaceholder& text : table.templates) {
    problems.push_back(base::error("tree.is-template", {}, text.file, text.line));
  }
  const std::vector<std::string> placeholders = legacyPlaceholders(table);
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

TreeIssues checkForImport(const TreeTable& table, const NodeCatalogue& catalogue) {
  TreeIssues issues;
  for (base::Diagnostic& problem : fileProblems(table)) {
    issues.push_back({std::move(problem), {}, {}});
  }
  append(issues, checkTrees(table, catalogue));
  return issues;
}

std::vector<const TreeTable::Entry*> topLevelTrees(const TreeTable& table) {
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

std::optional<base::Diagnostic> mainTreeProblem(const TreeTable& table,
                                                const std::string& mainTree) {
  if (table.entries.empty() && table.hasModel) {
    return base::error("tree.only-models", {}, table.file);
  }
  if (!mainTree.empty()) {
    return table.find(mainTree) ? std::nullopt
                                : std::optional(base::error(
                                      "tree.main-unknown", {mainTree, treesOf(table)}, table.file));
  }
  const std::vector<const TreeTable::Entry*> candidates = topLevelTrees(table);
  if (candidates.empty()) {
    return base::error("tree.main-not-said", {""}, table.file);
  }
  const TreeTable::Entry& first = *candidates.front();
  return base::error("tree.main-not-said", {namesWithLines(candidates)}, first.file,
                     first.tree.line);
}

std::vector<std::string> legacyPlaceholders(const TreeTable& table) {
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

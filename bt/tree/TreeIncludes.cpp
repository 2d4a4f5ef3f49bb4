#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "bt/tree/TreeXml.h"

namespace bt {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxIncludes = 1000;  // in all, repeated ones counted again

/// Follows the includes depth first, so that later definitions replace earlier ones.
class Includer {
 public:
  Includer(TreeTable& table, const PackageFolder& packages) : table_(table), packages_(packages) {}

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
  std::map<std::string, TreeFile> files_;  // by path, read once
  std::vector<std::string> open_;          // the files that are being included
  int count_ = 0;
};

std::string normalPath(const std::string& path) {
  std::error_code none;
  const fs::path full = fs::weakly_canonical(path, none);
  return none ? path : full.string();
}

void Includer::add(const TreeFile& file, int depth) {
  open_.push_back(file.path.empty() ? file.path : normalPath(file.path));
  for (const Include& include : file.includes) {
    follow(file, include, depth + 1);
  }
  open_.pop_back();
  for (const TreeSpec& tree : file.trees) {
    table_.entries[tree.id] = {tree, file.path};
  }
  const std::vector<XmlBlock> models = file.model ? file.model->children : std::vector<XmlBlock>();
  table_.hasModel = table_.hasModel || file.model;
  for (const XmlBlock& entry : models) {
    const std::string* const id = findText(entry.attributes, "ID");
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

void Includer::follow(const TreeFile& from, const Include& include, int depth) {
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

std::optional<std::string> Includer::pathOf(const TreeFile& from, const Include& include) {
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

const TreeFile* Includer::read(const std::string& path, const TreeFile& from,
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
  Includer includer(table, packages);
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
    const std::vector<const TreeTable::Entry*> candidates = uncalledTrees(table);
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
  return after(file.diagnostics(), resolveIncludes(*file, packages));
}

}  // namespace bt

#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt/tree/NodeCatalogue.h"
#include "sim2d/base/Result.h"

/// Behaviour trees as values that can be edited, compared and written. No thread of their own;
/// distinct values may be used from distinct threads.
namespace bt {

struct Attribute {
  std::string name;
  std::string text;
  friend bool operator==(const Attribute& a, const Attribute& b) {
    return a.name == b.name && a.text == b.text;
  }
};
using Attributes = std::vector<Attribute>;  // in the order of the file
const std::string* findText(const Attributes& attributes, std::string_view name);
void setText(Attributes& attributes, std::string_view name, std::string text);
void removeText(Attributes& attributes, std::string_view name);

/// Attributes of any node that are scripts.
constexpr std::array<const char*, 8> kConditionNames = {"_failureIf", "_successIf", "_skipIf",
                                                        "_while",     "_onSuccess", "_onFailure",
                                                        "_post",      "_onHalted"};

struct NodeSpec {
  std::string id;          // "Sequence", "GoTo", "SubTree"; empty = no node
  std::string subTree;     // only of "SubTree": ID of the tree that it runs
  std::string name;        // instance name; empty = shown as label()
  Attributes ports;        // values as written: constants or "{key}"
  Attributes conditions;   // _skipIf, _successIf, _failureIf, _while, _onSuccess, _post …
  bool autoRemap = false;  // only of "SubTree": _autoremap
  Attributes others;       // kept without meaning (_uid, _fullpath of Groot …)
  std::vector<NodeSpec> children;

  int line = 0;                   // in its file, 0 = unknown; not compared
  bool explicitNotation = false;  // <Action ID="GoTo"/> instead of <GoTo/>; not compared

  bool isSubTree() const { return id == "SubTree"; }
  /// The name, else the ID (of the tree that it runs, for a SubTree).
  const std::string& label() const;
};
bool operator==(const NodeSpec& a, const NodeSpec& b);
inline bool operator!=(const NodeSpec& a, const NodeSpec& b) {
  return !(a == b);
}

struct TreeSpec {
  std::string id;
  NodeSpec root;  // root.id empty: the tree has no node yet
  Attributes others;
  int line = 0;  // not compared
};
bool operator==(const TreeSpec& a, const TreeSpec& b);

struct Include {
  std::string path;  // as written, relative to the including file
  std::string rosPackage;
  int line = 0;  // not compared
};
bool operator==(const Include& a, const Include& b);

/// A part of a file that is kept as it is: the model block, foreign elements.
struct XmlBlock {
  std::string tag;
  Attributes attributes;
  std::string text;
  std::vector<XmlBlock> children;
};
bool operator==(const XmlBlock& a, const XmlBlock& b);

enum class FilePart { Model, Include, Tree, Other };

/// One tree file. `order` says how the parts follow each other; parts that are more than it names
/// are written after it. It has no meaning and is not compared.
struct TreeFile {
  int format = 4;        // of the file that was read, 3 or 4; written as 4; not compared
  std::string mainTree;  // main_tree_to_execute; empty = not given
  std::vector<Include> includes;
  std::vector<TreeSpec> trees;
  std::optional<XmlBlock> model;  // TreeNodesModel
  std::vector<XmlBlock> blocks;   // other elements below the root
  std::vector<FilePart> order;

  std::string path;      // where it was read, for relative includes and messages; not compared
  int templateLine = 0;  // line of a left-over {GOAL_SEQUENCE}, 0 = none; not compared

  const TreeSpec* find(std::string_view treeId) const;
  TreeSpec* find(std::string_view treeId);
};
bool operator==(const TreeFile& a, const TreeFile& b);
inline bool operator!=(const TreeFile& a, const TreeFile& b) {
  return !(a == b);
}

/// A tree file with everything that it includes: the trees that can be run, one per ID.
struct TreeTable {
  struct Entry {
    TreeSpec tree;
    std::string file;  // where it is defined
  };
  std::string file;      // the file that was opened
  std::string mainTree;  // ID of the tree to run; empty = not decided (several trees, none named)
  std::map<std::string, Entry, std::less<>> entries;  // by tree ID
  std::vector<XmlBlock> subTreeModels;                // <SubTree ID=…> of the model blocks
  std::set<std::string, std::less<>> declaredNodes;   // IDs of the other nodes of these blocks
  bool hasModel = false;                              // the file has such a block
  /// Where a {GOAL_SEQUENCE} was left over.
  struct TemplateText {
    std::string file;
    int line = 0;
  };
  std::vector<TemplateText> templates;

  const Entry* find(std::string_view treeId) const;
};

/// Child numbers from the root down; empty = the root itself.
using NodePath = std::vector<int>;

const NodeSpec* nodeAt(const TreeSpec& tree, const NodePath& path);  // nullptr = no such node
NodeSpec* nodeAt(TreeSpec& tree, const NodePath& path);

/// "{key}" -> "key", "{=}" or "=" -> `portName`; nothing for constants.
std::optional<std::string> referencedKey(std::string_view text, std::string_view portName);

/// A problem and the node it belongs to.
struct TreeIssue {
  base::Diagnostic diagnostic;  // file:line, message, hint how to repair it in brackets
  std::string treeId;
  NodePath node;
};
using TreeIssues = std::vector<TreeIssue>;
base::Diagnostics diagnosticsOf(const TreeIssues& issues);

/// A result behind what an earlier step had to say.
template <class T>
base::Result<T> after(base::Diagnostics earlier, base::Result<T> result) {
  base::append(earlier, result.diagnostics());
  if (!result) {
    return earlier;
  }
  return {*std::move(result), std::move(earlier)};
}

using TreeIds = std::set<std::string, std::less<>>;

/// Nodes, children, ports and constants of one tree against the catalogue. `treeIds` = the trees
/// that a SubTree may name, `declaredNodes` = nodes that a model block names.
TreeIssues checkTree(const TreeSpec& tree, const NodeCatalogue& catalogue, const TreeIds& treeIds,
                     const std::string& fileName = {}, const TreeIds& declaredNodes = {});
/// All trees of the table, and SubTrees that contain themselves.
TreeIssues checkTrees(const TreeTable& table, const NodeCatalogue& catalogue);
/// What an importer looks at in a file whose includes have been followed: all its trees, the tree
/// to run, recursion of SubTrees, left-over template text (an error here; the compiler only warns),
/// placeholders of HuNavSim 1.5. Scripts, types of entries and references that nothing writes are
/// the compiler's.
TreeIssues checkTable(const TreeTable& table, const NodeCatalogue& catalogue);
/// The trees that no SubTree calls: of the opened file, or of its includes when it has none.
std::vector<const TreeTable::Entry*> uncalledTrees(const TreeTable& table);
/// Why it is open which tree is to run: `mainTree` is empty, or names no tree.
std::optional<base::Diagnostic> problemOfMainTree(const TreeTable& table,
                                                  const std::string& mainTree);
/// The placeholders of HuNavSim 1.5 ({dist}, {duration}, {once}, {maxvel}, {forcefactor},
/// {stopdist}, {frontdist}, {safe_distance}) that the trees read; names without braces.
std::vector<std::string> placeholdersIn(const TreeTable& table);

/// Labels of the children of a node, equal ones numbered from 1: "SetGoal[2]".
std::vector<std::string> siblingNames(const std::vector<NodeSpec>& children);

}  // namespace bt

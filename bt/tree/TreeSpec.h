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

/// Behaviour trees as values that can be edited, compared and written. Not synchronised: distinct
/// values may be used from different threads.
namespace bt {

struct Attribute {
  std::string name;
  std::string text;
  friend bool operator==(const Attribute& a, const Attribute& b) {
    return a.name == b.name && a.text == b.text;
  }
};
using Attributes = std::vector<Attribute>;  // in file order
const std::string* findAttribute(const Attributes& attributes, std::string_view name);
void setAttribute(Attributes& attributes, std::string_view name, std::string text);
void removeAttribute(Attributes& attributes, std::string_view name);

/// Attributes that contain scripts and are valid for every node.
constexpr std::array<const char*, 8> kConditionNames = {"_failureIf", "_successIf", "_skipIf",
                                                        "_while",     "_onSuccess", "_onFailure",
                                                        "_post",      "_onHalted"};

struct NodeSpec {
  std::string id;          // "Sequence", "GoTo", "SubTree"; empty: no node
  std::string subTree;     // "SubTree" only: ID of the tree that it runs
  std::string name;        // instance name; empty: label() is shown
  Attributes ports;        // values as written: constants or "{key}"
  Attributes conditions;   // _skipIf, _successIf, _failureIf, _while, _onSuccess, _post …
  bool autoRemap = false;  // "SubTree" only: _autoremap
  Attributes others;       // preserved, not interpreted (_uid, _fullpath of Groot …)
  std::vector<NodeSpec> children;

  int line = 0;                   // in its file, 0: unknown; not compared
  bool explicitNotation = false;  // <Action ID="GoTo"/> instead of <GoTo/>; not compared

  bool isSubTree() const { return id == "SubTree"; }
  /// The name if set, otherwise the ID (for a SubTree, the ID of the tree that it runs).
  const std::string& label() const;
};
bool operator==(const NodeSpec& a, const NodeSpec& b);
inline bool operator!=(const NodeSpec& a, const NodeSpec& b) {
  return !(a == b);
}

struct TreeSpec {
  std::string id;
  NodeSpec root;  // root.id empty: the tree has no node
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

/// An XML element that is preserved unchanged: the model block or an unknown element.
struct XmlElement {
  std::string tag;
  Attributes attributes;
  std::string text;
  std::vector<XmlElement> children;
};
bool operator==(const XmlElement& a, const XmlElement& b);

enum class FilePart { Model, Include, Tree, Other };

/// One tree file. `order` is the order of the parts; parts that it does not list are written last.
/// It carries no meaning and is not compared.
struct TreeFile {
  int format = 4;        // of the file that was read, 3 or 4; written as 4; not compared
  std::string mainTree;  // main_tree_to_execute; empty: not given
  std::vector<Include> includes;
  std::vector<TreeSpec> trees;
  std::optional<XmlElement> model;  // TreeNodesModel
  std::vector<XmlElement> blocks;   // other elements below the root
  std::vector<FilePart> order;

  std::string path;      // source path, for relative includes and messages; not compared
  int templateLine = 0;  // line of an unreplaced {GOAL_SEQUENCE}, 0: none; not compared

  const TreeSpec* find(std::string_view treeId) const;
  TreeSpec* find(std::string_view treeId);
};
bool operator==(const TreeFile& a, const TreeFile& b);
inline bool operator!=(const TreeFile& a, const TreeFile& b) {
  return !(a == b);
}

/// A tree file with all its includes resolved: the trees that can be run, one per ID.
struct TreeTable {
  struct Entry {
    TreeSpec tree;
    std::string file;  // where it is defined
  };
  std::string file;      // the opened file
  std::string mainTree;  // ID of the tree to run; empty: undecided (several trees, none named)
  std::map<std::string, Entry, std::less<>> entries;  // by tree ID
  std::vector<XmlElement> subTreeModels;              // <SubTree ID=…> of the model blocks
  std::set<std::string, std::less<>> declaredNodes;   // IDs of the other nodes in the model blocks
  bool hasModel = false;                              // the file has a model block
  /// Position of an unreplaced {GOAL_SEQUENCE}.
  struct TemplatePlaceholder {
    std::string file;
    int line = 0;
  };
  std::vector<TemplatePlaceholder> templates;

  const Entry* find(std::string_view treeId) const;
};

/// Child indices from the root down; empty: the root itself.
using NodePath = std::vector<int>;

const NodeSpec* nodeAt(const TreeSpec& tree, const NodePath& path);  // nullptr: no such node
NodeSpec* nodeAt(TreeSpec& tree, const NodePath& path);

/// "{key}" gives "key", "{=}" or "=" gives `portName`; empty for constants.
std::optional<std::string> referencedKey(std::string_view text, std::string_view portName);

/// A problem and the node that it concerns.
struct TreeIssue {
  base::Diagnostic diagnostic;  // file:line, message and, in brackets, a hint for the fix
  std::string treeId;
  NodePath node;
};
using TreeIssues = std::vector<TreeIssue>;
base::Diagnostics diagnosticsOf(const TreeIssues& issues);

/// `result` with the diagnostics of an earlier step prepended.
template <class T>
base::Result<T> prependDiagnostics(base::Diagnostics earlier, base::Result<T> result) {
  base::append(earlier, result.diagnostics());
  if (!result) {
    return earlier;
  }
  return {*std::move(result), std::move(earlier)};
}

using TreeIds = std::set<std::string, std::less<>>;

/// Checks the nodes, children, ports and constants of one tree against the catalogue. `treeIds` are
/// the trees that a SubTree may name, `declaredNodes` the nodes declared in a model block.
TreeIssues checkTree(const TreeSpec& tree, const NodeCatalogue& catalogue, const TreeIds& treeIds,
                     const std::string& fileName = {}, const TreeIds& declaredNodes = {});
/// Checks all trees of the table, including recursion of SubTrees.
TreeIssues checkTrees(const TreeTable& table, const NodeCatalogue& catalogue);
/// Checks for the import of a file whose includes are resolved: all trees, the tree to run,
/// recursion of SubTrees, unreplaced template text (an error here; the compiler only warns) and
/// placeholders of HuNavSim 1.5. The compiler checks scripts, entry types and references that are
/// never written.
TreeIssues checkForImport(const TreeTable& table, const NodeCatalogue& catalogue);
/// The trees that no SubTree calls: those of the opened file, or those of its includes if the file
/// has none.
std::vector<const TreeTable::Entry*> topLevelTrees(const TreeTable& table);
/// Why the tree to run is undecided: `mainTree` is empty or names no tree.
std::optional<base::Diagnostic> mainTreeProblem(const TreeTable& table,
                                                const std::string& mainTree);
/// The placeholders of HuNavSim 1.5 ({dist}, {duration}, {once}, {maxvel}, {forcefactor},
/// {stopdist}, {frontdist}, {safe_distance}) that the trees read; names without braces.
std::vector<std::string> legacyPlaceholders(const TreeTable& table);

/// Labels of the children of a node; equal labels are numbered from 1: "SetGoal[2]".
std::vector<std::string> uniqueChildLabels(const std::vector<NodeSpec>& children);

}  // namespace bt

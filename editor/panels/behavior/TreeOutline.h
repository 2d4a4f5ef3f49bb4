#pragma once

#include <vector>

#include <QtWidgets>

#include "editor/document/PersonTree.h"
#include "editor/look/Theme.h"
#include "editor/run/SimulationRunner.h"
#include "sim2d/trace/Recording.h"
#include "sim2d/world/HumanBehavior.h"

namespace editor {

/// A read-only outline of a behaviour tree: one row per node with its relevant ports. During a run
/// the mark of each row shows the last return status by shape, and running nodes are emphasized.
class TreeOutline : public QTreeWidget {
  Q_OBJECT
 public:
  explicit TreeOutline(const Theme& theme);
  void setTheme(const Theme& theme);

  void showTree(const PersonTree& tree);
  /// By node names; without nodes: no run is shown.
  void showStatus(const sim2d::TreeStatuses& state);
  /// Shows the breakpoints at nodes of this tree.
  void showBreakpoints(const std::vector<sim2d::TreeBreakpoint>& points);
  /// As in recordings; empty = no such node.
  std::string nameOf(int node) const;
  int nodeNamed(const std::string& name) const;  // -1 = none.
  int nodeAt(const QPoint& place) const;         // Viewport coordinates; -1 = none.
  const OutlineNode* current() const;            // Null = none.
  int currentNode() const;                       // Index in nodes(), -1 = none.
  void selectNode(int node);                     // -1 keeps the selection.
  const std::vector<OutlineNode>& nodes() const { return nodes_; }
  base::NodeStatus statusOf(int node) const;

 Q_SIGNALS:
  void removeRequested();  // Requests removing the current node, by a key.

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void paintRow(std::size_t node);

  Theme theme_;
  PersonTree tree_;  // Owns the nodes that nodes_ points to.
  std::vector<OutlineNode> nodes_;
  std::vector<std::string> names_;  // Node names as in recordings.
  std::vector<QTreeWidgetItem*> rows_;
  std::vector<base::NodeStatus> statuses_;
  std::vector<sim2d::TreeBreakpoint> breakpoints_;
};

/// The name of a node, else its type, as in the palette, in problems and in the XML.
QString nodeTitle(const bt::NodeSpec& node);
/// The type of a node with a name of its own, or "subtree"; empty: the title is the type.
QString nodeKindText(const bt::NodeSpec& node);
/// The constant values of a node: "5 m, 30 s".
QString nodeValues(const bt::NodeSpec& node);
/// The return status of the nodes with these names. A recording from a file contains only ticked
/// nodes. Empty: unknown, or another tree.
std::vector<base::NodeStatus> statusesByNode(const sim2d::TreeStatuses& state,
                                             const std::vector<std::string>& names);
/// Draws a mark that shows the status by shape, 16 px wide, around the painter's origin.
void paintStatusMark(QPainter& painter, base::NodeStatus status, const Theme& theme);

/// Fills a menu with the breakpoints of a node: `path` as in recordings, for this person (id) or
/// for all people. Conditions are entered in a dialog over `window`.
void fillBreakpointMenu(QMenu& menu, SimulationRunner& runner, const std::string& path, int person,
                        QWidget& window);

/// "when it fails, for any person, if id > 2"
QString breakpointText(const sim2d::TreeBreakpoint& point);

}  // namespace editor

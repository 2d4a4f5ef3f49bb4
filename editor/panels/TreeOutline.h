#pragma once

#include <vector>

#include <QTreeWidget>

#include "editor/document/PersonTree.h"
#include "editor/look/Theme.h"
#include "sim2d/trace/Recording.h"
#include "sim2d/world/TreeBreakpoint.h"

namespace editor {

/// A behaviour tree as an outline, read-only: one row per node with what matters of its ports.
/// While a run is shown the mark of each row tells by shape what the node returned last, and nodes
/// that run stand out.
class TreeOutline : public QTreeWidget {
  Q_OBJECT
 public:
  explicit TreeOutline(const Theme& theme);
  void setTheme(const Theme& theme);

  void showTree(const PersonTree& tree);
  /// By the names of the nodes; without nodes: no run is shown.
  void showStatus(const sim2d::TreeStatuses& state);
  /// Those that stop a run at nodes of the tree that is shown.
  void showBreakpoints(const std::vector<sim2d::TreeBreakpoint>& points);
  /// As records give it; empty = there is no such node.
  std::string nameOf(int node) const;
  int nodeNamed(const std::string& name) const;  // -1 = none
  int nodeAt(const QPoint& place) const;         // of the viewport; -1 = none
  const OutlineNode* current() const;            // null = none
  int currentNode() const;                       // place in nodes(), -1 = none
  void selectNode(int node);                     // none: the choice stays
  const std::vector<OutlineNode>& nodes() const { return nodes_; }
  base::NodeStatus statusOf(int node) const;

 Q_SIGNALS:
  void removeWanted();  // of the current node, by a key

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void paintRow(std::size_t node);

  Theme theme_;
  PersonTree tree_;  // keeps what the nodes point to
  std::vector<OutlineNode> nodes_;
  std::vector<std::string> names_;  // of the nodes, as records give them
  std::vector<QTreeWidgetItem*> rows_;
  std::vector<base::NodeStatus> statuses_;
  std::vector<sim2d::TreeBreakpoint> breakpoints_;
};

/// "IsRobotVisible" -> "Is robot visible"; names of instances stay as they are.
QString nodeTitle(const bt::NodeSpec& node);
/// What controls, decorators and subtrees are, where their name alone says little: "run once".
QString nodeKindText(const bt::NodeSpec& node);
/// The values of a node that are constants: "5 m, 30 s".
QString nodeValues(const bt::NodeSpec& node);
/// What nodes of these names returned. A record of a file names those only that were ticked.
/// Empty: nothing is known, or it is of another tree.
std::vector<base::NodeStatus> statusesByNode(const sim2d::TreeStatuses& state,
                                             const std::vector<std::string>& names);
/// The mark that tells by shape what a node returned, 16 px wide, around the painter's origin.
void paintStatusMark(QPainter& painter, base::NodeStatus status, const Theme& theme);

}  // namespace editor

#pragma once

#include <string>
#include <utility>
#include <vector>

#include <QPainter>
#include <QSizeF>

#include "bt/tree/TreeSpec.h"
#include "editor/trees/TreeGraph.h"

namespace editor {

/// The whole tree for publications: all subtrees expanded, light colours, no state of a run. Pixels
/// are those of CSS, 96 per inch. Requires a QGuiApplication.
class TreePicture {
 public:
  explicit TreePicture(const bt::TreeTable& trees, TreeDirection direction = TreeDirection::Down);
  QSizeF size() const;
  void paint(QPainter& painter) const;
  bool isEmpty() const { return graph_.nodes().empty(); }
  /// The paths of the nodes, as in trees.csv.
  const std::vector<std::string>& paths() const { return graph_.names(); }
  /// Marks each node with a status, in the order of paths(); nodes with IDLE are pale.
  void showStatuses(std::vector<base::NodeStatus> statuses) {
    view_.statuses = std::move(statuses);
  }

 private:
  const Theme theme_ = Theme::light();
  TreeGraph graph_;
  TreeView view_;
};

}  // namespace editor

#pragma once

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

 private:
  const Theme theme_ = Theme::light();
  TreeGraph graph_;
};

}  // namespace editor

#include "editor/trees/TreePicture.h"

#include "editor/document/PersonTree.h"

namespace editor {

namespace {

/// As if all trees were in one file, so that included ones are drawn like the others.
PersonTree inOneFile(const bt::TreeTable& trees) {
  PersonTree tree;
  tree.isCustom = true;
  tree.table = trees;
  tree.file.mainTree = trees.mainTree;
  for (const auto& [id, entry] : trees.entries) {
    tree.file.trees.push_back(entry.tree);
  }
  return tree;
}

}  // namespace

TreePicture::TreePicture(const bt::TreeTable& trees, TreeDirection direction) : graph_(theme_) {
  graph_.setTree(inOneFile(trees));
  graph_.unfoldAll();
  graph_.setDirection(direction);
}

QSizeF TreePicture::size() const {
  return graph_.bounds().size();
}

void TreePicture::paint(QPainter& painter) const {
  painter.fillRect(graph_.bounds(), Qt::white);
  TreePainter(graph_, view_, theme_).paint(painter, graph_.bounds());
}

}  // namespace editor

#pragma once

#include <QtWidgets>

#include "bt/tree/TreeSpec.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"

namespace editor {

/// All building blocks of a tree, grouped by kind, with a search over names and descriptions: nodes
/// of the catalogue, trees of the file, and behaviour blocks as templates. Rows can be dragged.
class NodePalette : public QWidget {
  Q_OBJECT
 public:
  explicit NodePalette(const Theme& theme);
  void setTheme(const Theme& theme);
  /// The trees that a SubTree of the person may run.
  void showTrees(const QStringList& ids);
  QTreeWidget& list() const { return *list_; }
  QLineEdit& search() const { return *search_; }
  /// XML of the row; empty for headings.
  static QString xmlOf(const QTreeWidgetItem* row);

 Q_SIGNALS:
  void addRequested(const QString& xml);  // Emitted on a double click, or Enter.

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void addRows();
  QTreeWidgetItem* addGroup(const QString& title);
  void addNode(QTreeWidgetItem& group, const bt::NodeSpec& node, const QString& title,
               const QString& help);
  const QTreeWidgetItem* bestMatch() const;  // Best match of the search; null = none.
  void filter();
  void explain();

  Theme theme_;
  SearchField* search_;
  QTreeWidget* list_;
  NoMatchesPlaceholder* nothing_;
  QLabel* help_;  // Shown if there is space.
  QTreeWidgetItem* trees_ = nullptr;
};

}  // namespace editor

#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QTreeWidget>

#include "bt/tree/TreeSpec.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"

namespace editor {

/// All that a tree can be made of, by kind, with a search over names and explanations: nodes of the
/// catalogue, trees of the file, and blocks of behaviour as templates. Rows can be dragged.
class NodePalette : public QWidget {
  Q_OBJECT
 public:
  explicit NodePalette(const Theme& theme);
  void setTheme(const Theme& theme);
  /// Trees that a SubTree of the person may run.
  void showTrees(const QStringList& ids);
  QTreeWidget& list() const { return *list_; }
  QLineEdit& search() const { return *search_; }
  /// XML of the row; empty: it is a heading.
  static QString xmlOf(const QTreeWidgetItem* row);

 Q_SIGNALS:
  void wanted(const QString& xml);  // by a double click, or Enter

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void addRows();
  QTreeWidgetItem* addGroup(const QString& title);
  void addNode(QTreeWidgetItem& group, const bt::NodeSpec& node, const QString& title,
               const QString& help);
  const QTreeWidgetItem* bestFound() const;  // of the search; null = none
  void filter();
  void explain();

  Theme theme_;
  QLineEdit* search_;
  QAction* searchMark_;
  QTreeWidget* list_;
  NothingFound* nothing_;
  QLabel* help_;  // where there is room for it
  QTreeWidgetItem* trees_ = nullptr;
};

}  // namespace editor

#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QStyledItemDelegate>
#include <QTreeView>

#include "editor/document/EntityModel.h"

namespace editor {

/// Draws name and, at the right end of the row, the secondary text of one line.
class EntityRowDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  explicit EntityRowDelegate(const Theme& theme, QObject* parent = nullptr);
  void setTheme(const Theme& theme) { theme_ = theme; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  Theme theme_;
};

/// The left dock: the scenario as one tree with a filter. The selection goes both ways.
class ScenarioPanel : public QWidget {
  Q_OBJECT
 public:
  ScenarioPanel(ScenarioDocument& document, const Theme& theme, QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  QTreeView& tree() const { return *tree_; }
  QLineEdit& filter() const { return *filterField_; }
  EntityModel& model() const { return *model_; }

 Q_SIGNALS:
  void activated(editor::EntityId id);  // double click or return: go there on the map

 private:
  void takeSelection();
  void giveSelection();
  void expandGroups();
  void offerMenu(const QPoint& at);

  ScenarioDocument& document_;
  Theme theme_;
  EntityModel* model_;
  EntityFilter* filter_;
  QLineEdit* filterField_;
  QTreeView* tree_;
  EntityRowDelegate* delegate_;
  QAction* searchMark_;
  QLabel* empty_;
  bool syncing_ = false;
};

}  // namespace editor

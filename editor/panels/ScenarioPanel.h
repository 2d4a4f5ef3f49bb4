#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTreeView>

#include "editor/document/EntityModel.h"
#include "editor/panels/RowDelegate.h"

namespace editor {

/// Name and secondary text of an entity, and at the right end the eye that switches it on and off;
/// it is seen where the mouse is and where something is off.
class EntityRowDelegate : public RowDelegate {
  Q_OBJECT
 public:
  explicit EntityRowDelegate(const Theme& theme, QObject* parent = nullptr);
  void setTheme(const Theme& theme);
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;
  static QRect eyeOf(const QRect& row);

 Q_SIGNALS:
  void eyeClicked(const QModelIndex& index);

 protected:
  bool isPale(const QModelIndex& index) const override;
  int rightMargin(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QString sideText(const QModelIndex& index) const override;
  bool isHeading(const QModelIndex& index) const override;

 private:
  QIcon eye_, eyeOff_;
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
  /// Entries for one thing that is selected, alone or with others.
  void fillMenu(QMenu& menu, EntityId id);
  /// Lets its name be typed in its row.
  void rename(EntityId id);

 Q_SIGNALS:
  void activated(editor::EntityId id);  // double click or return: go there on the map
  void goalsWanted();                   // assign goals to who is selected

 private:
  void takeSelection();
  void showEmptiness();
  void giveSelection();
  void expandGroups();
  void offerMenu(const QPoint& at);
  void addPeopleActions(QMenu& menu);
  void switchEye(const QModelIndex& index);

  ScenarioDocument& document_;
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

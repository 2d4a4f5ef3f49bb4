#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QTreeView>

#include "editor/document/EntityModel.h"
#include "editor/look/Form.h"
#include "editor/look/PanelMenu.h"

namespace editor {

/// The left dock: the scenario as one tree with a filter. The selection goes both ways.
class ScenarioPanel : public QWidget {
  Q_OBJECT
 public:
  ScenarioPanel(ScenarioDocument& document, const Theme& theme);
  void setTheme(const Theme& theme);
  /// In runs behaviours are not given.
  void setEditing(bool editing) { isEditing_ = editing; }
  QTreeView& tree() const { return *tree_; }
  QLineEdit& filter() const { return *filterField_; }
  EntityModel& model() const { return *model_; }
  static QRect eyeOf(const QRect& row);  // that switches what is in the row on and off
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
  Theme theme_;
  EntityModel* model_;
  EntityFilter* filter_;
  QLineEdit* filterField_;
  QTreeView* tree_;
  QAction* searchMark_;
  QLabel* empty_;
  PanelMenu menu_;
  NothingFound* nothing_ = nullptr;
  bool syncing_ = false;
  bool isEditing_ = true;
  int groups_ = 0;  // that are seen
};

}  // namespace editor

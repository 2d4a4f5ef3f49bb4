#pragma once

#include <QtWidgets>

#include "editor/document/EntityModel.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/Form.h"

namespace editor {

/// The left dock: the scenario as a filterable tree. The selection is synchronized in both
/// directions.
class ScenarioPanel : public QWidget {
  Q_OBJECT
 public:
  ScenarioPanel(ScenarioDocument& document, const Theme& theme);
  void setTheme(const Theme& theme);
  /// During a run behaviours cannot be set.
  void setEditing(bool editing) { isEditing_ = editing; }
  QTreeView& tree() const { return *tree_; }
  QLineEdit& filter() const { return *filterField_; }
  EntityModel& model() const { return *model_; }
  static QRect eyeRect(const QRect& row);  // The icon that switches the entity of a row on and off.
  /// Adds the actions of a selected entity, alone or with others.
  void fillMenu(QMenu& menu, EntityId id);
  /// Opens the name editor in its row.
  void rename(EntityId id);

 Q_SIGNALS:
  void activated(editor::EntityId id);  // Double click or return: requests showing it on the map.
  void goalsRequested();                // Requests the goal assignment for the selection.

 private:
  void loadSelection();
  void updatePlaceholder();
  void storeSelection();
  void expandGroups();
  void offerMenu(const QPoint& at);
  void addPeopleActions(QMenu& menu);
  void toggleListed(const QModelIndex& index);

  ScenarioDocument& document_;
  Theme theme_;
  EntityModel* model_;
  EntityFilter* filter_ = new EntityFilter(*model_, this);
  SearchField* filterField_ =
      new SearchField(tr("Filter people, goals, areas"), tr("Filter"), this);
  QTreeView* tree_ = new QTreeView(this);
  QLabel* empty_ =
      emptyState(tr("Nothing on the map yet.\nPress P and click to place a person."), this);
  PanelMenu menu_;
  NoMatchesPlaceholder* nothing_ = nullptr;
  bool syncing_ = false;
  bool isEditing_ = true;
  int groups_ = 0;  // Number of visible groups.
};

}  // namespace editor

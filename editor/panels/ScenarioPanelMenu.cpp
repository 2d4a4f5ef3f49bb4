#include "editor/document/EditCommands.h"
#include "editor/document/Groups.h"
#include "editor/look/ActionText.h"
#include "editor/panels/ScenarioPanel.h"

// The menus of the right mouse button, of the list and of the canvas.
namespace editor {

void ScenarioPanel::offerMenu(const QPoint& at) {
  const EntityId id = filter_->idOf(tree_->indexAt(at));
  if (!id) {
    return;
  }
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  QAction* show = menu->addAction(tr("Show on the map"));
  describe(*show, tr("Move the map there"));
  connect(show, &QAction::triggered, this, [this, id] { Q_EMIT activated(id); });
  fillMenu(*menu, id);
  menu->addSeparator();
  QAction* copy = menu->addAction(tr("Duplicate"));
  describe(*copy, tr("A copy of what is selected"));
  connect(copy, &QAction::triggered, this, [this] {
    document_.setSelection(pushDuplicate(document_, document_.selection(), Vec2(0.5, -0.5)));
  });
  QAction* remove = menu->addAction(tr("Delete"));
  describe(*remove, tr("Remove what is selected; routes follow"));
  connect(remove, &QAction::triggered, this,
          [this] { pushRemove(document_, document_.selection()); });
  menu->popup(tree_->viewport()->mapToGlobal(at));
}

void ScenarioPanel::fillMenu(QMenu& menu, EntityId id) {
  menu.setToolTipsVisible(true);
  QAction* name = menu.addAction(tr("Rename"));
  describe(*name, id.kind == EntityKind::Goal
                      ? tr("Give the goal another number")
                      : tr("Give it another name; what refers to it follows"));
  connect(name, &QAction::triggered, this, [this, id] { rename(id); });
  if (id.kind != EntityKind::Goal) {
    const bool listed = model_->indexOf(id).data(EntityModel::ListedRole).toBool();
    QAction* eye = menu.addAction(listed ? tr("Switch off") : tr("Switch on"));
    describe(*eye, listed ? tr("Kept in the file, left out of the simulation")
                          : tr("Part of the simulation again"));
    connect(eye, &QAction::triggered, this,
            [this, listed] { pushListed(document_, document_.selection(), !listed); });
  }
  QAction* all = menu.addAction(tr("Select all of the kind"));
  describe(*all, tr("Everything of this kind, for changes of all at once"));
  connect(all, &QAction::triggered, this,
          [this, id] { document_.setSelection(document_.entities(id.kind)); });
  if (id.kind == EntityKind::Human) {
    addPeopleActions(menu);
  }
}

void ScenarioPanel::addPeopleActions(QMenu& menu) {
  int people = 0;
  int grouped = 0;
  for (const EntityId id : document_.selection()) {
    if (const sim2d::Human* human = document_.human(id)) {
      ++people;
      grouped += isInGroup(*human) ? 1 : 0;
    }
  }
  menu.addSeparator();
  QAction* goals = menu.addAction(tr("Assign goals…"));
  describe(*goals, tr("Which people visit which goals, in which order"));
  connect(goals, &QAction::triggered, this, &ScenarioPanel::goalsWanted);
  QAction* group = menu.addAction(tr("Walk as a group"));
  group->setEnabled(people > 1);
  describe(*group, people > 1 ? tr("These people keep together as one group")
                              : tr("A group takes two or more: select more people"));
  connect(group, &QAction::triggered, this,
          [this] { pushGroup(document_, document_.selection()); });
  QAction* alone = menu.addAction(tr("Walk alone"));
  alone->setEnabled(grouped > 0);
  describe(*alone, grouped > 0   ? tr("Leave the group")
                   : people == 1 ? tr("This person is in no group")
                                 : tr("None of these people is in a group"));
  connect(alone, &QAction::triggered, this,
          [this] { pushJoin(document_, document_.selection(), -1); });
}

}  // namespace editor

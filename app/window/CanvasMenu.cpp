#include "app/window/CanvasMenu.h"

#include "editor/panels/ScenarioPanel.h"

namespace app {

CanvasMenu::CanvasMenu(Workspace& workspace, WindowActions& actions, Docks& docks, QObject* parent)
    : QObject(parent), workspace_(workspace), actions_(actions), docks_(docks) {
  editor::MapView& view = workspace_.view();
  view.setContextMenuPolicy(Qt::CustomContextMenu);
  connect(&view, &QWidget::customContextMenuRequested, this, &CanvasMenu::offer);
}

void CanvasMenu::offer(const QPoint& at) {
  const bool editing = workspace_.runner().state() == editor::SimulationRunner::State::Editing;
  if (!editing || !workspace_.tools().isSelecting()) {
    return;
  }
  editor::MapView& view = workspace_.view();
  editor::ScenarioDocument& document = workspace_.document();
  const base::EntityId id =
      workspace_.scene().entityAt(editor::MapScene::worldFromScene(view.mapToScene(at)));
  if (id && !document.isSelected(id)) {
    document.setSelection({id});
  }
  auto* menu = new QMenu(&view);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  id ? fillForThing(*menu, id) : fillForGround(*menu);
  menu->popup(view.viewport()->mapToGlobal(at));
}

void CanvasMenu::fillForThing(QMenu& menu, base::EntityId id) {
  docks_.panel<editor::ScenarioPanel>().fillMenu(menu, id);
  actions_.canvas->fillArrangeMenu(*menu.addMenu(tr("Arrange")));
  menu.addSeparator();
  menu.addActions({actions_.cut, actions_.copy, actions_.duplicate, actions_.remove});
}

void CanvasMenu::fillForGround(QMenu& menu) {
  menu.addActions({actions_.paste, actions_.selectAll});
  menu.addSeparator();
  menu.addActions({actions_.zoomFit, actions_.grid, actions_.names, actions_.routes});
  menu.addSeparator();
  menu.addActions({actions_.settings});
}

}  // namespace app

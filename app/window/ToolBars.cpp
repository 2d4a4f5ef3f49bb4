
#include "app/window/WindowActions.h"
#include "app/window/settings/KeyMap.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/look/Form.h"
#include "editor/look/Icons.h"
#include "editor/panels/ScenarioPanel.h"
#include "editor/panels/behavior/BehaviorDialogs.h"

namespace app {

namespace {

constexpr int kToolBarHeight = 44;

/// Adds groups with separators between them.
void addGroups(QMenu& menu, const std::vector<QList<QAction*>>& groups) {
  for (const QList<QAction*>& group : groups) {
    if (!menu.isEmpty()) {
      menu.addSeparator();
    }
    menu.addActions(group);
  }
}

QWidget* spacer(int width, QWidget* parent) {
  auto* gap = new QWidget(parent);
  gap->setFixedWidth(width);
  return gap;
}

/// A button for several tools: it shows the last used one; its arrow opens the list.
QToolButton* makeToolGroup(const QList<QAction*>& actions, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setPopupMode(QToolButton::MenuButtonPopup);
  auto* menu = new QMenu(button);
  for (QAction* action : actions) {
    menu->addAction(action);
    QObject::connect(action, &QAction::toggled, button, [button, action](bool on) {
      if (on) {
        button->setDefaultAction(action);
      }
    });
  }
  button->setMenu(menu);
  button->setDefaultAction(actions.front());
  return button;
}

/// Tools of one group share a button at the position of the first one.
void addTools(QToolBar& bar, Workspace& workspace) {
  std::map<QString, QList<QAction*>> buttons;
  for (const editor::ToolManager::Entry& entry : workspace.tools().entries()) {
    buttons[entry.info.button].push_back(entry.action);
  }
  for (const editor::ToolManager::Entry& entry : workspace.tools().entries()) {
    const QList<QAction*>& shared = buttons[entry.info.button];
    if (entry.info.button.isEmpty()) {
      bar.addAction(entry.action);
    } else if (entry.action == shared.front()) {
      bar.addWidget(makeToolGroup(shared, &bar));
    }
  }
}

/// A button that opens or closes the panel with all layers.
QToolButton* makeLayersButton(const Docks& docks, QWidget* parent) {
  QAction* toggle = docks.toggleOf(*docks.dock(QStringLiteral("layers")));
  auto* button = new QToolButton(parent);
  button->setCheckable(true);
  button->setToolTip(QObject::tr("Layers\nChoose what the map shows"));
  button->setAccessibleName(QObject::tr("Layers"));
  QObject::connect(button, &QToolButton::clicked, toggle, &QAction::trigger);
  QObject::connect(toggle, &QAction::toggled, button, &QToolButton::setChecked);
  return button;
}

/// One menu per group of layers.
void addLayerMenus(QMenu& menu, const WindowActions& actions) {
  for (const WindowActions::LayerGroup& group : actions.layerGroups()) {
    QMenu* part = menu.addMenu(group.title);
    for (const editor::MapLayer& layer : group.layers) {
      part->addAction(layer.action);
    }
  }
}

void addBehaviorMenu(QMenuBar& bar, Workspace& workspace) {
  QMenu* menu = bar.addMenu(QObject::tr("&Behaviour"));
  const editor::ScenarioDocument& document = workspace.document();
  editor::fillBehaviorMenu(*menu, workspace.document(), workspace.theme(), &bar);
  QObject::connect(menu, &QMenu::aboutToShow, &document, [menu, &workspace, &document] {
    const std::vector<editor::EntityId>& selection = document.selection();
    const bool people = std::any_of(selection.begin(), selection.end(), [](editor::EntityId id) {
      return id.kind == base::EntityKind::Human;
    });
    const bool editing = workspace.runner().state() == editor::SimulationRunner::State::Editing;
    for (QAction* action : menu->actions()) {
      const QString why = editing ? QObject::tr("Select people first")
                                  : QObject::tr("Not during a run: Ctrl+R returns to editing");
      editor::setEnabled(*action, people && editing, why);
    }
    editor::setEnabled(*menu->actions().back(), editing && !document.scenario().humans.empty(),
                       editing
                           ? QObject::tr("The scenario has no people yet")
                           : QObject::tr("Not during a run: Ctrl+R returns to editing"));  // mix
  });
}

}  // namespace

QToolBar* makeToolBar(QMainWindow& window, Workspace& workspace, WindowActions& actions,
                      const Docks& docks) {
  auto* bar = new QToolBar(QObject::tr("Tools"), &window);
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setIconSize(QSize(24, 24));
  bar->setMinimumHeight(kToolBarHeight);  // Grows to show the actions that do not fit.
  bar->toggleViewAction()->setEnabled(false);
  editor::describe(*bar->toggleViewAction(), QObject::tr("Always visible"));
  bar->addWidget(spacer(8, bar));
  bar->addActions({actions.newOpenPlane, actions.open, actions.save});
  bar->addSeparator();
  bar->addActions({actions.undo, actions.redo});
  bar->addSeparator();
  addTools(*bar, workspace);
  bar->addSeparator();
  bar->addActions(workspace.playback().all());
  bar->addAction(workspace.drive().toggle());
  bar->addWidget(spacer(4, bar));
  bar->addWidget(workspace.playback().makeSpeedBox(bar));
  bar->addSeparator();
  QToolButton* layers = makeLayersButton(docks, bar);
  bar->addWidget(layers);
  bar->addActions({actions.rings, actions.forces, actions.grid, actions.snapToPoints,
                   actions.zoomFit, actions.switchTheme});
  const auto takeIcons = [&workspace, layers] {
    for (QAction* action : workspace.tools().actions().actions()) {
      action->setIcon(editor::themedIcon(action->data().toString(), workspace.theme()));
    }
    workspace.drive().toggle()->setIcon(
        editor::themedIcon(QStringLiteral("run-drive"), workspace.theme()));
    layers->setIcon(editor::themedIcon(QStringLiteral("view-layers"), workspace.theme()));
  };
  takeIcons();
  QObject::connect(&workspace, &Workspace::themeChanged, bar, takeIcons);
  return bar;
}

QMenu* makeMenus(QMainWindow& window, Workspace& workspace, WindowActions& actions, Docks& docks) {
  QMenuBar& bar = *window.menuBar();
  QMenu& file = *bar.addMenu(QObject::tr("&File"));
  addGroups(file, {{actions.newOpenPlane, actions.newEmptyRoom, actions.newFromMap, actions.open,
                    actions.openRun, actions.importTracks}});
  QMenu* recent = file.addMenu(QObject::tr("Open recen&t"));
  recent->setProperty(KeyMap::kListsFilesProperty, true);
  addGroups(file, {{actions.save, actions.saveAs, actions.exportTo},
                   {actions.savePicture, actions.saveFilm},
                   {actions.close, actions.quit}});

  QMenu& edit = *bar.addMenu(QObject::tr("&Edit"));
  addGroups(edit, {{actions.undo, actions.redo},
                   {actions.cut, actions.copy, actions.paste, actions.duplicate, actions.rename,
                    actions.remove},
                   {actions.copyFigure, actions.copyPlot, actions.savePlot},
                   {actions.selectAll, actions.deselect, actions.next, actions.previous}});
  actions.fillArrangeMenu(*edit.addMenu(QObject::tr("Arran&ge")));
  addGroups(edit, {actions.snapping, {actions.palette, actions.preferences}});

  QMenu& view = *bar.addMenu(QObject::tr("&View"));
  addGroups(view, {{actions.zoomIn, actions.zoomOut, actions.zoomFit},
                   {actions.names, actions.routes, actions.grid, actions.rings, actions.forces}});
  addLayerMenus(*view.addMenu(QObject::tr("All &layers")), actions);
  view.addMenu(QObject::tr("Trail length"))->addActions(workspace.scrub().trailLengths());
  addGroups(view,
            {docks.toggles() << docks.mapOnly() << docks.treeMaximized() << actions.resetLayout,
             {actions.switchTheme, actions.systemTheme, actions.fullScreen}});

  addGroups(*bar.addMenu(QObject::tr("&Scenario")),
            {workspace.tools().actions().actions(),
             {actions.assignGoals, actions.openMap, actions.settings}});

  const editor::PlaybackActions& playback = workspace.playback();
  addGroups(*bar.addMenu(QObject::tr("&Run")),
            {{playback.playPause, playback.step, playback.stepBack, playback.newest,
              playback.branchHere, playback.reset, workspace.drive().toggle()},
             workspace.scrub().all(),
             {actions.publishFoxglove, actions.publishRos2},
             {actions.history}});
  addBehaviorMenu(bar, workspace);
  addGroups(*bar.addMenu(QObject::tr("&Help")), {{actions.manual, actions.whatsThis, actions.tour},
                                                 {actions.palette, actions.shortcuts},
                                                 {actions.about}});
  return recent;
}

namespace {

/// A menu that closes when the selection changes or when switching between editing and a run.
QMenu* canvasMenu(Workspace& workspace) {
  auto* menu = new QMenu(&workspace.view());
  menu->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(&workspace.document(), &editor::ScenarioDocument::selectionChanged, menu,
                   &QWidget::close);
  QObject::connect(&workspace.runner(), &editor::SimulationRunner::stateChanged, menu,
                   &QWidget::close);
  return menu;
}

/// Adds the command to drive the robot. Manual driving applies to the selected robot. The selection
/// is changed only when the command is chosen, because the map's legend could move the robot away
/// from under the menu.
void addDriveAction(QMenu& menu, Workspace& workspace, base::EntityId robot) {
  QAction* const toggle = workspace.drive().toggle();
  if (workspace.document().isSelected(robot)) {
    menu.addAction(toggle);
    return;
  }
  QAction* const drive =
      menu.addAction(toggle->icon(), toggle->text(), toggle, [&workspace, robot, toggle] {
        workspace.document().setSelection({robot});
        toggle->setChecked(true);
      });
  drive->setToolTip(toggle->toolTip());
}

/// The context menu in a run: manual interaction with people and robots.
void showInteractionMenu(Workspace& workspace, const QPoint& at) {
  editor::MapView& view = workspace.view();
  const base::Vec2 place = view.worldAt(at);
  QMenu* const menu = canvasMenu(workspace);
  const editor::FrameLayer& layer = workspace.scene().frameLayer();
  const std::optional<int> agent = layer.agentAt(place);
  if (agent && *agent < 0 && workspace.runner().isLive()) {
    addDriveAction(*menu, workspace, layer.entityOf(*agent));
  }
  workspace.interaction().fillMenu(*menu, agent, place);
  if (agent && workspace.playback().branchHere->isEnabled()) {
    menu->addSeparator();
    menu->addAction(workspace.playback().branchHere);
  }
  if (menu->isEmpty()) {
    delete menu;
    return;
  }
  menu->popup(view.viewport()->mapToGlobal(at));
}

/// Pastes where the menu was opened.
QAction* makePasteHere(QMenu& menu, WindowActions& actions, const base::Vec2& place) {
  auto* paste = new QAction(QObject::tr("Paste here"), &menu);
  paste->setEnabled(actions.paste->isEnabled());
  QObject::connect(paste, &QAction::triggered, &actions,
                   [&actions, place] { actions.pasteAt(place); });
  return paste;
}

}  // namespace

void connectCanvasMenu(Workspace& workspace, WindowActions& actions, const Docks& docks) {
  editor::MapView& view = workspace.view();
  view.setContextMenuPolicy(Qt::CustomContextMenu);
  const auto offer = [&workspace, &actions, &docks, &view](const QPoint& at) {
    const bool editing = workspace.runner().state() == editor::SimulationRunner::State::Editing;
    if (!editing) {
      showInteractionMenu(workspace, at);
      return;
    }
    if (!workspace.tools().isSelecting()) {
      return;
    }
    editor::ScenarioDocument& document = workspace.document();
    const base::EntityId id = workspace.scene().entityAt(view.worldAt(at));
    if (id && !document.isSelected(id)) {
      document.setSelection({id});
    }
    QMenu* const menu = canvasMenu(workspace);
    if (id) {
      docks.panel<editor::ScenarioPanel>().fillMenu(*menu, id);
      actions.fillArrangeMenu(*menu->addMenu(QObject::tr("Arrange")));
      addGroups(*menu, {{actions.cut, actions.copy, actions.duplicate, actions.remove}});
    } else {
      addGroups(*menu, {{makePasteHere(*menu, actions, view.worldAt(at)), actions.selectAll},
                        {actions.zoomFit, actions.grid, actions.names, actions.routes},
                        {actions.settings}});
    }
    menu->popup(view.viewport()->mapToGlobal(at));
  };
  QObject::connect(&view, &QWidget::customContextMenuRequested, &docks, offer);
}

}  // namespace app

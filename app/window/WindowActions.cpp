#include "app/window/WindowActions.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QUndoStack>

#include "editor/canvas/Tool.h"
#include "editor/document/EditCommands.h"
#include "editor/look/Form.h"
#include "editor/look/Icons.h"
#include "editor/tools/SelectionActions.h"

namespace app {

using editor::CanvasOptions;
using editor::EntityId;

WindowActions::WindowActions(Workspace& workspace, QObject* parent)
    : QObject(parent), workspace_(workspace) {
  makeFileActions();
  makeEditActions();
  makeViewActions();
  makeLayers();
  makeArranging();
  connectEditing();
  setTheme(workspace.theme());
  followSelection();
}

QAction* WindowActions::make(const QString& text, const QString& icon, const QKeySequence& shortcut,
                             const QString& says) {
  auto* action = new QAction(text, this);
  action->setShortcut(shortcut);
  editor::describe(*action, says);
  if (!icon.isEmpty()) {
    icons_.emplace_back(action, icon);
  }
  return action;
}

void WindowActions::makeFileActions() {
  newRoom = make(tr("&New open plane"), QStringLiteral("file-new"), QKeySequence::New,
                 tr("A new scenario without a map"));
  newWalledRoom = make(tr("New empty &room…"), QStringLiteral("start-room"),
                       QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_N),
                       tr("A new scenario in a room of a given size"));
  newFromMap = make(tr("New from a &map…"), QStringLiteral("start-map"),
                    QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N),
                    tr("A new scenario on a map of the navigation stack"));
  open = make(tr("&Open…"), QStringLiteral("file-open"), QKeySequence::Open,
              tr("Open a scenario or a map"));
  openRun = make(tr("Open r&un…"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O),
                 tr("Look at a recorded run: the folder that `run` has written"));
  save = make(tr("&Save"), QStringLiteral("file-save"), QKeySequence::Save,
              tr("Save the scenario and its behaviour trees"));
  saveAs = make(tr("Save &as…"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
                tr("Save under another name"));
  exportTo = make(tr("&Export…"), {}, QKeySequence(Qt::CTRL | Qt::Key_E),
                  tr("Write scenario, trees and map for another simulator"));
  close = make(tr("&Close"), {}, QKeySequence(Qt::CTRL | Qt::Key_W), tr("Back to the start page"));
  quit = make(tr("&Quit"), {}, QKeySequence(Qt::CTRL | Qt::Key_Q), tr("Leave the program"));
  openMap = make(tr("Change &map…"), QStringLiteral("start-map"), {},
                 tr("Put another map under the scenario"));
  assignGoals = make(tr("Assign &goals…"), {}, QKeySequence(Qt::CTRL | Qt::Key_G),
                     tr("Which people visit which goals, in which order"));
  settings = make(tr("Scenario &settings"), {}, QKeySequence(Qt::CTRL | Qt::Key_Comma),
                  tr("Seed, duration and what belongs to the whole scenario"));
  about = make(tr("&About"), {}, {}, tr("Version and licence"));
}

void WindowActions::makeEditActions() {
  QUndoStack& stack = workspace_.document().undoStack();
  undo = stack.createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  redo = stack.createRedoAction(this, tr("&Redo"));
  redo->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z));
  const auto tell = [this] {  // the names say what would be taken back
    editor::describe(*undo, tr("Take the last change back"));
    editor::describe(*redo, tr("Make the change again that was taken back"));
  };
  connect(&stack, &QUndoStack::indexChanged, this, tell);
  tell();
  icons_.emplace_back(undo, QStringLiteral("edit-undo"));
  icons_.emplace_back(redo, QStringLiteral("edit-redo"));
  cut = make(tr("Cu&t"), {}, QKeySequence::Cut, tr("Copy what is selected and remove it"));
  copy = make(tr("&Copy"), {}, QKeySequence::Copy, tr("Copy what is selected, as YAML text"));
  paste = make(tr("&Paste"), {}, QKeySequence::Paste, tr("Add what was copied beside it"));
  duplicate = make(tr("Dup&licate"), QStringLiteral("edit-duplicate"),
                   QKeySequence(Qt::CTRL | Qt::Key_D), tr("A copy of what is selected"));
  rename = make(tr("Rena&me"), {}, QKeySequence(Qt::Key_F2),
                tr("Another name for what is selected; what refers to it follows"));
  remove = make(tr("&Delete"), QStringLiteral("edit-delete"), QKeySequence::Delete,
                tr("Remove what is selected; routes follow"));
  selectAll = make(tr("Select &all"), {}, QKeySequence::SelectAll, tr("Everything on the map"));
  deselect = make(tr("Select &nothing"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A),
                  tr("Clear the selection"));
  next = make(tr("N&ext"), {}, QKeySequence(Qt::Key_PageDown),
              tr("The next person, or the next of the kind that is selected"));
  previous = make(tr("Pre&vious"), {}, QKeySequence(Qt::Key_PageUp),
                  tr("The previous person, or the previous of the kind that is selected"));
  for (QAction* action : {next, previous}) {  // lists scroll by the same keys
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    workspace_.view().addAction(action);
  }
}

QAction* WindowActions::toggle(const QString& text, const QString& icon,
                               const QKeySequence& shortcut, bool CanvasOptions::*option,
                               const QString& says) {
  QAction* action =
      make(text, icon, shortcut, says.isEmpty() ? tr("Show or hide on the map") : says);
  action->setCheckable(true);
  editor::MapScene& scene = workspace_.scene();
  action->setChecked(scene.options().*option);
  connect(action, &QAction::toggled, &scene, [&scene, option](bool on) {
    CanvasOptions options = scene.options();
    options.*option = on;
    scene.setOptions(options);
  });
  connect(&scene, &editor::MapScene::optionsChanged, action,
          [action, &scene, option] { action->setChecked(scene.options().*option); });
  return action;
}

void WindowActions::makeViewActions() {
  zoomIn = make(tr("Zoom &in"), QStringLiteral("add"), QKeySequence::ZoomIn, tr("Nearer"));
  zoomOut = make(tr("Zoom &out"), QStringLiteral("remove"), QKeySequence::ZoomOut, tr("Farther"));
  zoomFit = make(tr("&Fit"), QStringLiteral("view-fit"), QKeySequence(Qt::Key_F),
                 tr("The whole map in the window"));
  fullScreen = make(tr("Full scr&een"), {}, QKeySequence(Qt::Key_F11), tr("Only the map"));
  fullScreen->setCheckable(true);
  resetLayout = make(tr("Reset the la&yout"), {}, {}, tr("Docks as they were at first"));
  switchTheme = make(tr("Light or dar&k"), QStringLiteral("view-theme"),
                     QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_T), tr("Switch the colours"));
  systemTheme = make(tr("Colours of the &system"), {}, {}, tr("Follow the desktop's colours"));
  systemTheme->setCheckable(true);
  names = toggle(tr("&Names"), QStringLiteral("view-names"), QKeySequence(Qt::Key_N),
                 &CanvasOptions::names);
  routes = toggle(tr("&Routes"), QStringLiteral("tool-route"), QKeySequence(Qt::SHIFT | Qt::Key_R),
                  &CanvasOptions::routes);
  grid = toggle(tr("&Grid"), QStringLiteral("view-grid"), QKeySequence(Qt::SHIFT | Qt::Key_G),
                &CanvasOptions::grid);
  rulers = toggle(tr("R&ulers"), {}, {}, &CanvasOptions::rulers);
  trails = toggle(tr("&Trails"), QStringLiteral("view-trails"), QKeySequence(Qt::Key_T),
                  &CanvasOptions::trails, tr("Where people have been, in a run"));
  rings = toggle(tr("&Personal spaces"), QStringLiteral("view-rings"), QKeySequence(Qt::Key_X),
                 &CanvasOptions::proxemics, tr("Rings around the people that are selected"));
  forces = toggle(tr("For&ces"), QStringLiteral("view-forces"), QKeySequence(Qt::SHIFT | Qt::Key_F),
                  &CanvasOptions::forces, tr("What moves the people that are selected, in a run"));
  overlays = {names, routes, grid, rulers, trails, rings, forces};
  editor::MapView& view = workspace_.view();
  connect(zoomIn, &QAction::triggered, &view, &editor::MapView::zoomIn);
  connect(zoomOut, &QAction::triggered, &view, &editor::MapView::zoomOut);
  connect(zoomFit, &QAction::triggered, &view, [&view] { view.fitAll(); });
}

void WindowActions::makeLayers() {
  layers = {toggle(tr("&Map"), {}, {}, &CanvasOptions::map),
            toggle(tr("&People"), {}, {}, &CanvasOptions::people),
            toggle(tr("&Robots"), {}, {}, &CanvasOptions::robots),
            toggle(tr("&Goals"), {}, {}, &CanvasOptions::goals),
            toggle(tr("&Obstacles and doors"), {}, {}, &CanvasOptions::obstacles),
            toggle(tr("&Areas"), {}, {}, &CanvasOptions::areas),
            toggle(tr("Gro&ups"), {}, {}, &CanvasOptions::groups)};
  snapToPoints = toggle(tr("Snap to p&oints"), QStringLiteral("snap"), QKeySequence(Qt::Key_S),
                        &CanvasOptions::snapToPoints,
                        tr("Corners, ends and centres of other things hold what is drawn"));
  snapping = {snapToPoints,
              toggle(tr("Snap to &walls"), {}, {}, &CanvasOptions::snapToWalls,
                     tr("Corners and edges of the map's walls hold what is drawn")),
              toggle(tr("Snap to the gr&id"), {}, QKeySequence(Qt::SHIFT | Qt::Key_S),
                     &CanvasOptions::snapToGrid, tr("What is drawn lies on half metres"))};
}

void WindowActions::makeArranging() {
  using editor::Align;
  using editor::Distribute;
  editor::ScenarioDocument& document = workspace_.document();
  const auto add = [this](const QString& text, const QString& says, std::size_t least,
                          const std::function<void()>& work) {
    QAction* action = make(text, {}, {}, says);
    connect(action, &QAction::triggered, this, work);
    arranging_.emplace_back(action, least);
  };
  const std::pair<QString, Align> sides[] = {
      {tr("Align &left"), Align::Left},       {tr("Align &centres across"), Align::CentreX},
      {tr("Align &right"), Align::Right},     {tr("Align &tops"), Align::Top},
      {tr("Align &middles"), Align::CentreY}, {tr("Align &bottoms"), Align::Bottom}};
  for (const auto& [text, side] : sides) {
    add(text, tr("Move what is selected onto one line"), 2,
        [&document, how = side] { editor::alignSelection(document, how); });
  }
  const std::pair<QString, Distribute> ways[] = {{tr("Distribute &across"), Distribute::Across},
                                                 {tr("Distribute &up"), Distribute::Up}};
  for (const auto& [text, way] : ways) {
    add(text, tr("Equal gaps between what is selected"), 3,
        [&document, how = way] { editor::distributeSelection(document, how); });
  }
  const std::pair<QString, double> turns[] = {{tr("Rotate 15° left\t["), editor::kSnapAngle},
                                              {tr("Rotate 15° right\t]"), -editor::kSnapAngle},
                                              {tr("Rotate 90° left"), 0.5 * base::kPi},
                                              {tr("Rotate 90° right"), -0.5 * base::kPi}};
  for (const auto& [text, angle] : turns) {
    add(text, tr("Turn what is selected about its middle"), 1,
        [&document, by = angle] { editor::rotateSelection(document, by); });
  }
}

void WindowActions::fillArrangeMenu(QMenu& menu) const {
  std::size_t before = 0;
  for (const auto& [action, least] : arranging_) {
    if (before != 0 && least != before) {
      menu.addSeparator();
    }
    menu.addAction(action);
    before = least;
  }
}

void WindowActions::connectEditing() {
  editor::ScenarioDocument& document = workspace_.document();
  connectClipboard();
  connect(duplicate, &QAction::triggered, this, [&document] {
    document.setSelection(
        editor::pushDuplicate(document, document.selection(), base::Vec2(0.5, -0.5)));
  });
  connect(remove, &QAction::triggered, this,
          [&document] { editor::pushRemove(document, document.selection()); });
  connect(selectAll, &QAction::triggered, this, [&document] { editor::selectAll(document); });
  connect(deselect, &QAction::triggered, this, [&document] { document.setSelection({}); });
  connect(settings, &QAction::triggered, this, [&document] { document.setSelection({}); });
  connect(next, &QAction::triggered, this, [this] { selectNext(1); });
  connect(previous, &QAction::triggered, this, [this] { selectNext(-1); });
  connect(&document, &editor::ScenarioDocument::selectionChanged, this,
          &WindowActions::followSelection);
  connect(&workspace_.runner(), &editor::SimulationRunner::stateChanged, this,
          &WindowActions::followSelection);
}

void WindowActions::selectNext(int by) {
  editor::ScenarioDocument& document = workspace_.document();
  const std::vector<EntityId>& selection = document.selection();
  const auto kind = selection.empty() ? base::EntityKind::Human : selection.back().kind;
  const std::vector<EntityId> all = document.entities(kind);
  if (all.empty()) {
    return;
  }
  const int count = static_cast<int>(all.size());
  const int at = selection.empty() ? (by > 0 ? -1 : 0) : document.indexOf(selection.back());
  const EntityId wanted = all[static_cast<std::size_t>((at + by + count) % count)];
  document.setSelection({wanted});
  const std::optional<editor::Entity> value = document.entity(wanted);
  const std::optional<base::Vec2> place = value ? editor::positionOf(*value) : std::nullopt;
  if (place &&
      !workspace_.view().viewport()->rect().contains(workspace_.view().viewportFrom(*place))) {
    workspace_.view().centerOnEntity(wanted);
  }
}

void WindowActions::connectClipboard() {
  editor::ScenarioDocument& document = workspace_.document();
  connect(copy, &QAction::triggered, this, &WindowActions::copySelection);
  connect(cut, &QAction::triggered, this, [this, &document] {
    copySelection();
    pastes_ = -1;  // the first paste puts it back where it was
    editor::removeSelection(document);
  });
  connect(paste, &QAction::triggered, this, [this, &document] {
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    const double by = 0.5 * (pastes_ + 1);
    if (data != nullptr && editor::paste(document, *data, base::Vec2(by, -by))) {
      ++pastes_;
    }
  });
  connect(QGuiApplication::clipboard(), &QClipboard::dataChanged, this, [this] {
    pastes_ = 0;
    followSelection();
  });
}

void WindowActions::copySelection() {
  QGuiApplication::clipboard()->setMimeData(
      editor::copiedSelection(workspace_.document()).release());
  pastes_ = 0;
}

void WindowActions::followSelection() {
  const bool editing = workspace_.runner().state() == editor::SimulationRunner::State::Editing;
  const bool any = !workspace_.document().selection().empty();
  cut->setEnabled(any && editing);
  copy->setEnabled(any);
  duplicate->setEnabled(any && editing);
  rename->setEnabled(editing && workspace_.document().selection().size() == 1);
  remove->setEnabled(any && editing);
  paste->setEnabled(editing && editor::canPaste(QGuiApplication::clipboard()->mimeData()));
  openMap->setEnabled(editing);
  assignGoals->setEnabled(editing);
  const std::size_t count = workspace_.document().selection().size();
  for (const auto& [action, least] : arranging_) {
    action->setEnabled(editing && count >= least);
  }
}

void WindowActions::setTheme(const editor::Theme& theme) {
  for (const auto& [action, icon] : icons_) {
    action->setIcon(editor::themedIcon(icon, theme));
  }
}

}  // namespace app

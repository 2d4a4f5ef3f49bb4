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

// Numbers: keys and modifiers are enums that do not mix.
constexpr int kCtrl = Qt::CTRL;
constexpr int kShift = Qt::SHIFT;

WindowActions::WindowActions(Workspace& workspace, QObject* parent)
    : QObject(parent), ofRuns(new OverlayActions(workspace, this)), workspace_(workspace) {
  makeFileActions();
  makeEditActions();
  makeViewActions();
  makeLayers();
  makeArranging();
  connectEditing();
  setTheme(workspace.theme());
  followSelection();
}

QAction* WindowActions::make(const QString& text, const QString& says, const QKeySequence& shortcut,
                             const char* icon) {
  auto* action = new QAction(text, this);
  action->setShortcut(shortcut);
  editor::describe(*action, says);
  if (icon != nullptr) {
    icons_.emplace_back(action, icon);
  }
  return action;
}

void WindowActions::makeFileActions() {
  newRoom = make(tr("&New open plane"), tr("A new scenario without a map"), QKeySequence::New,
                 "file-new");
  newWalledRoom = make(tr("New empty &room…"), tr("A new scenario in a room of a given size"),
                       kCtrl | Qt::ALT | Qt::Key_N, "start-room");
  newFromMap = make(tr("New from a &map…"), tr("A new scenario on a map of the navigation stack"),
                    kCtrl | kShift | Qt::Key_N, "start-map");
  open = make(tr("&Open…"), tr("Open a scenario or a map"), QKeySequence::Open, "file-open");
  openRun = make(tr("Open r&un…"), tr("Look at a recorded run: the folder that `run` has written"),
                 kCtrl | kShift | Qt::Key_O);
  save = make(tr("&Save"), tr("Save the scenario and its behaviour trees"), QKeySequence::Save,
              "file-save");
  saveAs = make(tr("Save &as…"), tr("Save under another name"), kCtrl | kShift | Qt::Key_S);
  exportTo = make(tr("&Export…"), tr("Write scenario, trees and map for another simulator"),
                  kCtrl | Qt::Key_E);
  close = make(tr("&Close"), tr("Back to the start page"), kCtrl | Qt::Key_W);
  quit = make(tr("&Quit"), tr("Leave the program"), kCtrl | Qt::Key_Q);
  openMap = make(tr("Change &map…"), tr("Put another map under the scenario"), {}, "start-map");
  assignGoals = make(tr("Assign &goals…"), tr("Which people visit which goals, in which order"),
                     kCtrl | Qt::Key_G);
  settings =
      make(tr("Scenario &settings"), tr("Seed, duration and what belongs to the whole scenario"),
           kCtrl | Qt::Key_Comma);
  history = make(tr("&Looking back…"),
                 tr("How much memory a run may take, so that all of it can be looked back at"));
  watchLive = make(tr("Watch in &Foxglove"),
                   tr("Runs that begin from now on can be watched live, at ws://localhost:8765"));
  onRos2 = make(tr("On topics of &ROS 2"),
                tr("Runs that begin from now on are told on topics; /cmd_vel, /initialpose and "
                   "/goal_pose reach the first robot"));
  for (QAction* action : {watchLive, onRos2}) {
    action->setCheckable(true);
  }
  shortcuts =
      make(tr("&Keyboard shortcuts…"), tr("All keys, with a search"), QKeySequence::HelpContents);
  about = make(tr("&About"), tr("Version and licence"));
}

void WindowActions::makeEditActions() {
  QUndoStack& stack = workspace_.document().undoStack();
  undo = stack.createUndoAction(this, tr("&Undo"));
  undo->setProperty(kName, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  redo = stack.createRedoAction(this, tr("&Redo"));
  redo->setProperty(kName, tr("&Redo"));
  redo->setShortcut(kCtrl | kShift | Qt::Key_Z);
  const auto tell = [this] {  // the names say what would be taken back
    editor::describe(*undo, tr("Take the last change back"));
    editor::describe(*redo, tr("Make the change again that was taken back"));
  };
  connect(&stack, &QUndoStack::indexChanged, this, tell);
  tell();
  icons_.emplace_back(undo, "edit-undo");
  icons_.emplace_back(redo, "edit-redo");
  cut = make(tr("Cu&t"), tr("Copy what is selected and remove it"), QKeySequence::Cut);
  copy = make(tr("&Copy"), tr("Copy what is selected, as YAML text"), QKeySequence::Copy);
  copyFigure =
      make(tr("Copy as figure"), tr("The moment of the run as a figure for a paper: PNG and SVG"),
           kCtrl | kShift | Qt::Key_C);
  copyPlot = make(tr("Copy the metric as a plot"),
                  tr("The metric that is selected, over time: PNG and SVG"));
  paste = make(tr("&Paste"), tr("Add what was copied beside it"), QKeySequence::Paste);
  duplicate =
      make(tr("Dup&licate"), tr("A copy of what is selected"), kCtrl | Qt::Key_D, "edit-duplicate");
  rename = make(tr("Rena&me"), tr("Another name for what is selected; what refers to it follows"),
                Qt::Key_F2);
  remove = make(tr("&Delete"), tr("Remove what is selected; routes follow"), QKeySequence::Delete,
                "edit-delete");
  selectAll = make(tr("Select &all"), tr("Everything on the map"), QKeySequence::SelectAll);
  deselect = make(tr("Select &nothing"), tr("Clear the selection"), kCtrl | kShift | Qt::Key_A);
  next = make(tr("N&ext"), tr("The next person, or the next of the kind that is selected"),
              Qt::Key_PageDown);
  previous =
      make(tr("Pre&vious"), tr("The previous person, or the previous of the kind that is selected"),
           Qt::Key_PageUp);
  for (QAction* action : {next, previous}) {  // lists scroll by the same keys
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    workspace_.view().addAction(action);
  }
}

QAction* WindowActions::toggle(const QString& text, bool CanvasOptions::*option,
                               const QKeySequence& shortcut, const char* icon,
                               const QString& says) {
  QAction* action =
      make(text, says.isEmpty() ? tr("Show or hide on the map") : says, shortcut, icon);
  followOption(*action, workspace_.scene(), option);
  return action;
}

void WindowActions::makeViewActions() {
  zoomIn = make(tr("Zoom &in"), tr("Nearer"), QKeySequence::ZoomIn, "add");
  zoomOut = make(tr("Zoom &out"), tr("Farther"), QKeySequence::ZoomOut, "remove");
  zoomFit =
      make(tr("&Fit"), tr("All that is known of the map in the window"), Qt::Key_F, "view-fit");
  fullScreen = make(tr("Full scr&een"), tr("Only the map"), Qt::Key_F11);
  fullScreen->setCheckable(true);
  resetLayout = make(tr("Reset the la&yout"), tr("Docks as they were at first"));
  switchTheme = make(tr("Light or dar&k"), tr("Switch the colours"), kCtrl | kShift | Qt::Key_T,
                     "view-theme");
  systemTheme = make(tr("Colours of the &system"), tr("Follow the desktop's colours"));
  systemTheme->setCheckable(true);
  names = toggle(tr("&Names"), &CanvasOptions::names, Qt::Key_N, "view-names");
  routes = toggle(tr("&Routes"), &CanvasOptions::routes, kShift | Qt::Key_R, "tool-route");
  grid = toggle(tr("&Grid"), &CanvasOptions::grid, kShift | Qt::Key_G, "view-grid");
  rulers = toggle(tr("R&ulers"), &CanvasOptions::rulers);
  trails = toggle(tr("&Trails"), &CanvasOptions::trails, Qt::Key_T, "view-trails",
                  tr("Where people have been, in a run"));
  rings = toggle(
      tr("&Personal spaces"), &CanvasOptions::proxemics, Qt::Key_X, "view-rings",
      tr("Hall's zones round the people that are selected; in a run round all if nobody is"));
  forces = toggle(tr("For&ces"), &CanvasOptions::forces, kShift | Qt::Key_F, "view-forces",
                  tr("What moves the people that are selected, in a run; all if nobody is"));
  robotPath = toggle(tr("Robot pat&hs"), &CanvasOptions::robotPath, {}, nullptr,
                     tr("What planners of robots follow, in a run"));
  lidar = toggle(tr("L&aser scans"), &CanvasOptions::lidar, kShift | Qt::Key_L, nullptr,
                 tr("What lidars of robots see, in a run"));
  detections = toggle(tr("&Detections"), &CanvasOptions::detections, kShift | Qt::Key_D, nullptr,
                      tr("Where robots take people and themselves to be, in a run"));
  candidates = toggle(tr("&Weighed ways"), &CanvasOptions::candidates, kShift | Qt::Key_W, nullptr,
                      tr("Between which ways planners of robots chose, in a run"));
  overlays = {names,  routes,    grid,  rulers,     trails,    rings,
              forces, robotPath, lidar, detections, candidates};
  editor::MapView& view = workspace_.view();
  connect(zoomIn, &QAction::triggered, &view, &editor::MapView::zoomIn);
  connect(zoomOut, &QAction::triggered, &view, &editor::MapView::zoomOut);
  connect(zoomFit, &QAction::triggered, &view, [&view] { view.fitAll(); });
}

void WindowActions::remember(Memory& memory) {
  ofRuns->remember(memory);
  const std::pair<QAction*, const char*> kept[] = {
      {names, "map/names"},           {routes, "map/routes"},   {grid, "map/grid"},
      {rulers, "map/rulers"},         {trails, "map/trails"},   {rings, "map/rings"},
      {forces, "map/forces"},         {lidar, "map/lidar"},     {robotPath, "map/robotPath"},
      {detections, "map/detections"}, {candidates, "map/ways"},
  };
  for (const auto& [action, key] : kept) {
    const QVariant before = memory.value(key);
    if (before.isValid()) {
      action->setChecked(before.toBool());
    }
    connect(action, &QAction::toggled, this,
            [&memory, where = key](bool on) { memory.setValue(where, on); });
  }
}

void WindowActions::makeLayers() {
  layers = {toggle(tr("&Map"), &CanvasOptions::map),
            toggle(tr("&People"), &CanvasOptions::people),
            toggle(tr("&Robots"), &CanvasOptions::robots),
            toggle(tr("&Goals"), &CanvasOptions::goals),
            toggle(tr("&Obstacles and doors"), &CanvasOptions::obstacles),
            toggle(tr("&Areas and docks"), &CanvasOptions::areas),
            toggle(tr("Gro&ups"), &CanvasOptions::groups)};
  snapToPoints = toggle(tr("Snap to p&oints"), &CanvasOptions::snapToPoints, Qt::Key_S, "snap",
                        tr("Corners, ends and centres of other things hold what is drawn"));
  snapping = {snapToPoints,
              toggle(tr("Snap to &walls"), &CanvasOptions::snapToWalls, {}, nullptr,
                     tr("Corners and edges of the map's walls hold what is drawn")),
              toggle(tr("Snap to the gr&id"), &CanvasOptions::snapToGrid, kShift | Qt::Key_S,
                     nullptr, tr("What is drawn lies on half metres"))};
}

void WindowActions::makeArranging() {
  using editor::Align;
  using editor::Distribute;
  editor::ScenarioDocument& document = workspace_.document();
  const auto add = [&](const auto& ways, const QString& says, std::size_t least, auto arrange) {
    for (const auto& [text, way] : ways) {
      QAction* action = make(text, says);
      connect(action, &QAction::triggered, this,
              [&document, arrange, how = way] { arrange(document, how); });
      arranging_.emplace_back(action, least);
    }
  };
  const std::pair<QString, Align> sides[] = {
      {tr("Align &left"), Align::Left},       {tr("Align &centres across"), Align::CentreX},
      {tr("Align &right"), Align::Right},     {tr("Align &tops"), Align::Top},
      {tr("Align &middles"), Align::CentreY}, {tr("Align &bottoms"), Align::Bottom}};
  add(sides, tr("Move what is selected onto one line"), 2, editor::alignSelection);
  const std::pair<QString, Distribute> gaps[] = {{tr("Distribute &across"), Distribute::Across},
                                                 {tr("Distribute &up"), Distribute::Up}};
  add(gaps, tr("Equal gaps between what is selected"), 3, editor::distributeSelection);
  const std::pair<QString, double> turns[] = {{tr("Rotate 15° left\t["), editor::kSnapAngle},
                                              {tr("Rotate 15° right\t]"), -editor::kSnapAngle},
                                              {tr("Rotate 90° left"), 0.5 * base::kPi},
                                              {tr("Rotate 90° right"), -0.5 * base::kPi}};
  add(turns, tr("Turn what is selected about its middle"), 1, editor::rotateSelection);
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
  for (const QAction* action : {deselect, settings}) {
    connect(action, &QAction::triggered, this, [this, &document] {
      document.setSelection({});
      workspace_.scene().setGuest({});  // it stands over the selection
    });
  }
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
    editor::pushRemove(document, document.selection());
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
  const std::size_t count = workspace_.document().selection().size();
  const bool any = count > 0;
  cut->setEnabled(any && editing);
  copy->setEnabled(any);
  duplicate->setEnabled(any && editing);
  rename->setEnabled(editing && count == 1);
  remove->setEnabled(any && editing);
  paste->setEnabled(editing && editor::canPaste(QGuiApplication::clipboard()->mimeData()));
  openMap->setEnabled(editing);
  assignGoals->setEnabled(editing);
  for (const auto& [action, least] : arranging_) {
    action->setEnabled(editing && count >= least);
  }
}

void WindowActions::setTheme(const editor::Theme& theme) {
  for (const auto& [action, icon] : icons_) {
    action->setIcon(editor::themedIcon(QString::fromLatin1(icon), theme));
  }
}

}  // namespace app

#include "app/window/WindowActions.h"

#include <algorithm>
#include <utility>

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

void bindOption(QAction& action, editor::MapScene& scene, bool CanvasOptions::*option) {
  action.setCheckable(true);
  action.setChecked(scene.options().*option);
  QObject::connect(&action, &QAction::toggled, &scene, [&scene, option](bool on) {
    CanvasOptions options = scene.options();
    options.*option = on;
    scene.setOptions(options);
  });
  QObject::connect(&scene, &editor::MapScene::optionsChanged, &action,
                   [&action, &scene, option] { action.setChecked(scene.options().*option); });
}

OverlayActions::OverlayActions(Workspace& workspace, QObject* parent)
    : QObject(parent), workspace_(workspace) {
  density = toggle(tr("&Density of people"), &CanvasOptions::density, Qt::Key_H,
                   tr("People per m² as a colour map"));
  sight = toggle(tr("&Field of view"), &CanvasOptions::sight, Qt::Key_E,
                 tr("Area that the selected people see; walls block the view"));
  gaussian = toggle(tr("&Gaussian spaces"), &CanvasOptions::gaussian, Qt::Key_X,
                    tr("Gaussian personal space, longer in the walking direction"));
  velocities = toggle(tr("&Velocities"), &CanvasOptions::velocities, Qt::Key_V,
                      tr("Velocity vector of each body"));
  plans = toggle(tr("People's &paths"), &CanvasOptions::plans, Qt::Key_P,
                 tr("Remaining path of each person; newest step only"));
  contacts = toggle(tr("&Contacts"), &CanvasOptions::contacts, Qt::Key_C,
                    tr("Where bodies touched, and which body ran into the other"));
  thoughts = toggle(tr("&Thoughts"), &CanvasOptions::thoughts, Qt::Key_T,
                    tr("Current action of each person and its reason, below the name"));
  speech = toggle(tr("&Speech"), &CanvasOptions::speech, Qt::Key_B,
                  tr("What people say, and which people hear it"));
  localCosts = toggle(tr("&Local costmap"), &CanvasOptions::localCosts, Qt::Key_M,
                      tr("Local costmap that the controller of a robot with Nav2 uses"));
  globalCosts = toggle(tr("Gl&obal costmap"), &CanvasOptions::globalCosts, Qt::Key_K,
                       tr("Global costmap that the planner of a robot with Nav2 uses"));
}

QAction* OverlayActions::toggle(const QString& text, bool CanvasOptions::*option, int letter,
                                const QString& description) {
  auto* action = new QAction(text, this);
  action->setShortcut(int{Qt::SHIFT} | letter);
  editor::describe(*action, description);
  bindOption(*action, workspace_.scene(), option);
  all << action;
  return action;
}

namespace {

using Named = std::pair<const char*, bool CanvasOptions::*>;
constexpr Named kOverlayNames[] = {
    {"density", &CanvasOptions::density},   {"sight", &CanvasOptions::sight},
    {"gaussian", &CanvasOptions::gaussian}, {"velocities", &CanvasOptions::velocities},
    {"plans", &CanvasOptions::plans},       {"contacts", &CanvasOptions::contacts},
    {"thoughts", &CanvasOptions::thoughts}, {"zones", &CanvasOptions::proxemics},
    {"forces", &CanvasOptions::forces},     {"local-costs", &CanvasOptions::localCosts},
    {"ways", &CanvasOptions::candidates},   {"global-costs", &CanvasOptions::globalCosts},
    {"laser", &CanvasOptions::lidar}};

}  // namespace

std::vector<std::string> OverlayActions::names() {
  std::vector<std::string> all;
  for (const auto& [name, option] : kOverlayNames) {
    all.emplace_back(name);
  }
  return all;
}

void OverlayActions::show(const std::vector<std::string>& names) {
  CanvasOptions options = workspace_.scene().options();
  for (const auto& [name, option] : kOverlayNames) {
    const bool isWanted = std::find(names.begin(), names.end(), name) != names.end();
    const bool isUsual = option != &CanvasOptions::lidar;  // in pictures only if requested
    options.*option = isWanted || (isUsual && options.*option);
  }
  workspace_.scene().setOptions(options);
}

void OverlayActions::restoreAndStore(UserSettings& userSettings) {
  const std::pair<QAction*, const char*> kept[] = {
      {density, "map/density"},       {sight, "map/sight"},
      {gaussian, "map/gaussian"},     {plans, "map/plans"},
      {contacts, "map/contacts"},     {velocities, "map/velocities"},
      {thoughts, "map/thoughts"},     {speech, "map/speech"},
      {localCosts, "map/localCosts"}, {globalCosts, "map/globalCosts"}};
  for (const auto& [action, key] : kept) {
    const QVariant before = userSettings.value(key);
    if (before.isValid()) {
      action->setChecked(before.toBool());
    }
    connect(action, &QAction::toggled, this,
            [&userSettings, where = key](bool on) { userSettings.setValue(where, on); });
  }
}

using editor::EntityId;

// Integers, because keys and modifiers are different enums.
constexpr int kCtrl = Qt::CTRL;
constexpr int kShift = Qt::SHIFT;

WindowActions::WindowActions(Workspace& workspace, QObject* parent)
    : QObject(parent), runOverlays(new OverlayActions(workspace, this)), workspace_(workspace) {
  makeFileActions();
  makeEditActions();
  makeViewActions();
  makeLayers();
  makeArranging();
  connectEditing();
  setTheme(workspace.theme());
  updateEnabled();
}

QAction* WindowActions::make(const QString& text, const QString& description,
                             const QKeySequence& shortcut, const char* icon) {
  auto* action = new QAction(text, this);
  action->setShortcut(shortcut);
  editor::describe(*action, description);
  if (icon != nullptr) {
    icons_.emplace_back(action, icon);
  }
  return action;
}

void WindowActions::makeFileActions() {
  newOpenPlane = make(tr("&New open plane"), tr("Create a scenario without a map"),
                      QKeySequence::New, "file-new");
  newEmptyRoom = make(tr("New empty &room…"), tr("Create a scenario in a room of a given size"),
                      kCtrl | Qt::ALT | Qt::Key_N, "start-room");
  newFromMap = make(tr("New from a &map…"), tr("Create a scenario on a Nav2 map or a map image"),
                    kCtrl | kShift | Qt::Key_N, "start-map");
  open = make(tr("&Open…"), tr("Open a scenario or a map"), QKeySequence::Open, "file-open");
  openRun = make(tr("Open r&un…"), tr("Open a recorded run: the output folder of `run`"),
                 kCtrl | kShift | Qt::Key_O);
  save = make(tr("&Save"), tr("Save the scenario and its behaviour trees"), QKeySequence::Save,
              "file-save");
  saveAs =
      make(tr("Save &as…"), tr("Save the scenario under another name"), kCtrl | kShift | Qt::Key_S);
  exportTo = make(tr("&Export…"), tr("Export scenario, trees and map for another simulator"),
                  kCtrl | Qt::Key_E);
  close = make(tr("&Close"), tr("Return to the start page"), kCtrl | Qt::Key_W);
  quit = make(tr("&Quit"), tr("Quit the program"), kCtrl | Qt::Key_Q);
  openMap = make(tr("Change &map…"), tr("Choose another map for the scenario"), {}, "start-map");
  assignGoals = make(tr("Assign &goals…"),
                     tr("Choose the goals that people visit, and their "
                        "order"),
                     kCtrl | Qt::Key_G);
  settings =
      make(tr("Scenario &settings"), tr("Edit seed, duration and other settings of the scenario"),
           kCtrl | Qt::Key_Comma);
  history = make(tr("Run &history…"), tr("Set the memory for the history of a run"));
  publishFoxglove =
      make(tr("Watch in &Foxglove"), tr("Publish new runs live at ws://localhost:8765"));
  publishRos2 =
      make(tr("Publish to &ROS 2"),
           tr("Publish new runs on ROS 2 topics; /cmd_vel, /initialpose and /goal_pose control the "
              "first robot"));
  for (QAction* action : {publishFoxglove, publishRos2}) {
    action->setCheckable(true);
  }
  shortcuts = make(tr("&Keyboard shortcuts…"), tr("Search all keyboard shortcuts"),
                   QKeySequence::HelpContents);
  about = make(tr("&About"), tr("Show version information"));
}

void WindowActions::makeEditActions() {
  QUndoStack& stack = workspace_.document().undoStack();
  undo = stack.createUndoAction(this, tr("&Undo"));
  undo->setProperty(kNameProperty, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  redo = stack.createRedoAction(this, tr("&Redo"));
  redo->setProperty(kNameProperty, tr("&Redo"));
  redo->setShortcut(kCtrl | kShift | Qt::Key_Z);
  const auto tell = [this] {  // the texts name the change
    editor::describe(*undo, tr("Undo the last change"));
    editor::describe(*redo, tr("Redo the last undone change"));
  };
  connect(&stack, &QUndoStack::indexChanged, this, tell);
  tell();
  icons_.emplace_back(undo, "edit-undo");
  icons_.emplace_back(redo, "edit-redo");
  cut = make(tr("Cu&t"), tr("Copy the selection and remove it"), QKeySequence::Cut);
  copy = make(tr("&Copy"), tr("Copy the selection as YAML text"), QKeySequence::Copy);
  copyFigure =
      make(tr("Copy as figure"), tr("Copy the displayed step of the run as a figure: PNG and SVG"),
           kCtrl | kShift | Qt::Key_C);
  copyPlot = make(tr("Copy metric as plot"),
                  tr("Copy a plot of the selected metric over time: PNG and SVG"));
  paste = make(tr("&Paste"), tr("Insert the copied items"), QKeySequence::Paste);
  duplicate =
      make(tr("Dup&licate"), tr("Duplicate the selection"), kCtrl | Qt::Key_D, "edit-duplicate");
  rename = make(tr("Rena&me"), tr("Rename the selection; references are updated"), Qt::Key_F2);
  remove = make(tr("&Delete"), tr("Remove the selection; routes are updated"), QKeySequence::Delete,
                "edit-delete");
  selectAll = make(tr("Select &all"), tr("Select everything on the map"), QKeySequence::SelectAll);
  deselect = make(tr("Select &none"), tr("Clear the selection"), kCtrl | kShift | Qt::Key_A);
  next = make(tr("N&ext"), tr("Select the next person, or the next item of the selected kind"),
              Qt::Key_PageDown);
  previous = make(tr("Pre&vious"),
                  tr("Select the previous person, or the previous item of the selected "
                     "kind"),
                  Qt::Key_PageUp);
  for (QAction* action : {next, previous}) {  // lists use the same keys
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    workspace_.view().addAction(action);
  }
}

QAction* WindowActions::toggle(const QString& text, bool CanvasOptions::*option,
                               const QKeySequence& shortcut, const char* icon,
                               const QString& description) {
  QAction* action = make(text, description.isEmpty() ? tr("Show or hide on the map") : description,
                         shortcut, icon);
  bindOption(*action, workspace_.scene(), option);
  return action;
}

void WindowActions::makeViewActions() {
  zoomIn = make(tr("Zoom &in"), tr("Enlarge the map"), QKeySequence::ZoomIn, "add");
  zoomOut = make(tr("Zoom &out"), tr("Reduce the map"), QKeySequence::ZoomOut, "remove");
  zoomFit = make(tr("&Fit"), tr("Fit the whole map in the window"), Qt::Key_F, "view-fit");
  fullScreen = make(tr("Full scr&een"), tr("Show only the map"), Qt::Key_F11);
  fullScreen->setCheckable(true);
  resetLayout = make(tr("Reset the la&yout"), tr("Restore the default panel layout"));
  switchTheme = make(tr("Light or dar&k"), tr("Switch between the light and the dark theme"),
                     kCtrl | kShift | Qt::Key_T, "view-theme");
  systemTheme = make(tr("Follow &system theme"), tr("Use the light or dark theme of the "
                                                    "desktop"));
  systemTheme->setCheckable(true);
  names = toggle(tr("&Names"), &CanvasOptions::names, Qt::Key_N, "view-names");
  routes = toggle(tr("&Routes"), &CanvasOptions::routes, kShift | Qt::Key_R, "tool-route");
  grid = toggle(tr("&Grid"), &CanvasOptions::grid, kShift | Qt::Key_G, "view-grid");
  rulers = toggle(tr("R&ulers"), &CanvasOptions::rulers);
  trails = toggle(tr("&Trails"), &CanvasOptions::trails, Qt::Key_T, "view-trails",
                  tr("Past paths of people in a run"));
  rings =
      toggle(tr("&Personal spaces"), &CanvasOptions::proxemics, Qt::Key_X, "view-rings",
             tr("Hall's zones around selected people; in a run around all if none is selected"));
  forces = toggle(tr("For&ces"), &CanvasOptions::forces, kShift | Qt::Key_F, "view-forces",
                  tr("Forces on selected people in a run; on all if none is selected"));
  robotPath = toggle(tr("Robot pat&hs"), &CanvasOptions::robotPath, {}, nullptr,
                     tr("Paths that robot planners follow in a run"));
  lidar = toggle(tr("Lid&ar scans"), &CanvasOptions::lidar, kShift | Qt::Key_L, nullptr,
                 tr("Lidar scans of robots in a run"));
  detections = toggle(tr("&Detections"), &CanvasOptions::detections, kShift | Qt::Key_D, nullptr,
                      tr("Positions of people and of themselves as robots estimate them in a run"));
  candidates = toggle(tr("Candidate tra&jectories"), &CanvasOptions::candidates, kShift | Qt::Key_W,
                      nullptr, tr("Trajectories that robot planners evaluated in a run"));
  overlays = {names,  routes,    grid,  rulers,     trails,    rings,
              forces, robotPath, lidar, detections, candidates};
  editor::MapView& view = workspace_.view();
  connect(zoomIn, &QAction::triggered, &view, &editor::MapView::zoomIn);
  connect(zoomOut, &QAction::triggered, &view, &editor::MapView::zoomOut);
  connect(zoomFit, &QAction::triggered, &view, [&view] { view.fitAll(); });
}

void WindowActions::restoreAndStore(UserSettings& userSettings) {
  runOverlays->restoreAndStore(userSettings);
  const std::pair<QAction*, const char*> kept[] = {
      {names, "map/names"},           {routes, "map/routes"},   {grid, "map/grid"},
      {rulers, "map/rulers"},         {trails, "map/trails"},   {rings, "map/rings"},
      {forces, "map/forces"},         {lidar, "map/lidar"},     {robotPath, "map/robotPath"},
      {detections, "map/detections"}, {candidates, "map/ways"},
  };
  for (const auto& [action, key] : kept) {
    const QVariant before = userSettings.value(key);
    if (before.isValid()) {
      action->setChecked(before.toBool());
    }
    connect(action, &QAction::toggled, this,
            [&userSettings, where = key](bool on) { userSettings.setValue(where, on); });
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
                        tr("Snap drawn items to corners, ends and centres of other items"));
  snapping = {snapToPoints,
              toggle(tr("Snap to &walls"), &CanvasOptions::snapToWalls, {}, nullptr,
                     tr("Snap drawn items to corners and edges of map walls")),
              toggle(tr("Snap to the gr&id"), &CanvasOptions::snapToGrid, kShift | Qt::Key_S,
                     nullptr, tr("Snap drawn items to a grid of 0.5 m"))};
}

void WindowActions::makeArranging() {
  using editor::Align;
  using editor::Distribute;
  editor::ScenarioDocument& document = workspace_.document();
  const auto add = [&](const auto& ways, const QString& description, std::size_t least,
                       auto arrange) {
    for (const auto& [text, way] : ways) {
      QAction* action = make(text, description);
      connect(action, &QAction::triggered, this,
              [&document, arrange, how = way] { arrange(document, how); });
      arranging_.emplace_back(action, least);
    }
  };
  const std::pair<QString, Align> sides[] = {
      {tr("Align &left"), Align::Left},       {tr("Align &centres"), Align::CentreX},
      {tr("Align &right"), Align::Right},     {tr("Align &tops"), Align::Top},
      {tr("Align &middles"), Align::CentreY}, {tr("Align &bottoms"), Align::Bottom}};
  add(sides, tr("Align the selected items"), 2, editor::alignSelection);
  const std::pair<QString, Distribute> gaps[] = {
      {tr("Distribute &horizontally"), Distribute::Across},
      {tr("Distribute &vertically"), Distribute::Up}};
  add(gaps, tr("Set equal gaps between the selected items"), 3, editor::distributeSelection);
  const std::pair<QString, double> turns[] = {{tr("Rotate 15° left\t["), editor::kSnapAngle},
                                              {tr("Rotate 15° right\t]"), -editor::kSnapAngle},
                                              {tr("Rotate 90° left"), 0.5 * base::kPi},
                                              {tr("Rotate 90° right"), -0.5 * base::kPi}};
  add(turns, tr("Rotate the selection about its centre"), 1, editor::rotateSelection);
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
      workspace_.scene().setSpawnedAgent({});  // the guest has precedence over the selection
    });
  }
  connect(next, &QAction::triggered, this, [this] { selectNext(1); });
  connect(previous, &QAction::triggered, this, [this] { selectNext(-1); });
  connect(&document, &editor::ScenarioDocument::selectionChanged, this,
          &WindowActions::updateEnabled);
  connect(&workspace_.runner(), &editor::SimulationRunner::stateChanged, this,
          &WindowActions::updateEnabled);
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
    pastes_ = -1;  // the first paste restores the position
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
    updateEnabled();
  });
}

void WindowActions::copySelection() {
  QGuiApplication::clipboard()->setMimeData(
      editor::copiedSelection(workspace_.document()).release());
  pastes_ = 0;
}

void WindowActions::updateEnabled() {
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

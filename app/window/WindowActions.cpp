#include "app/window/WindowActions.h"

#include "editor/canvas/Tool.h"
#include "editor/document/EditCommands.h"
#include "editor/look/Form.h"
#include "editor/look/Icons.h"
#include "editor/tools/SelectionActions.h"

namespace app {

using editor::CanvasOptions;
using editor::EntityId;

namespace {

// Integers, because keys and modifiers are different enums.
constexpr int kCtrl = Qt::CTRL;
constexpr int kShift = Qt::SHIFT;

constexpr const char* kOpacities = "map/opacities";
constexpr const char* kShowOrHide = QT_TR_NOOP("Show or hide on the map");

/// Connects a checkable action with an option of the map.
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

}  // namespace

/// A checkable command for an option of the map.
struct WindowActions::Toggle {
  const char* text;
  bool CanvasOptions::*option;
  int shortcut;  // 0: none
  const char* tip;
  const char* key = nullptr;  // key of the stored state; null: not stored
  QAction* WindowActions::*action = nullptr;
  const char* icon = nullptr;
};

namespace {

using Named = std::pair<const char*, bool CanvasOptions::*>;
constexpr Named kOverlayNames[] = {
    {"density", &CanvasOptions::density},   {"sight", &CanvasOptions::sight},
    {"gaussian", &CanvasOptions::gaussian}, {"velocities", &CanvasOptions::velocities},
    {"plans", &CanvasOptions::plans},       {"contacts", &CanvasOptions::contacts},
    {"thoughts", &CanvasOptions::thoughts}, {"zones", &CanvasOptions::proxemics},
    {"forces", &CanvasOptions::forces},     {"local-costs", &CanvasOptions::localCosts},
    {"ways", &CanvasOptions::candidates},   {"global-costs", &CanvasOptions::globalCosts},
    {"laser", &CanvasOptions::lidar},       {"masks", &CanvasOptions::masks}};

}  // namespace

std::vector<std::string> WindowActions::overlayNames() {
  std::vector<std::string> all;
  for (const auto& [name, option] : kOverlayNames) {
    all.emplace_back(name);
  }
  return all;
}

void WindowActions::showOverlays(const std::vector<std::string>& shown) {
  CanvasOptions options = workspace_.scene().options();
  for (const auto& [name, option] : kOverlayNames) {
    const bool isWanted = std::find(shown.begin(), shown.end(), name) != shown.end();
    const bool isUsual = option != &CanvasOptions::lidar;  // in pictures only if requested
    options.*option = isWanted || (isUsual && options.*option);
  }
  workspace_.scene().setOptions(options);
}

WindowActions::WindowActions(Workspace& workspace, QObject* parent)
    : QObject(parent), workspace_(workspace) {
  makeFileActions();
  makeHelpActions();
  makeEditActions();
  makeViewActions();
  makeToggles();
  makeLayerGroups();
  makeArranging();
  connectEditing();
  setTheme(workspace.theme());
  updateEnabled();
}

QAction* WindowActions::make(const QString& text, const QString& description,
                             const QKeySequence& shortcut, const char* icon) {
  QAction* action = editor::makeAction(text, shortcut, description, this);
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
  savePicture = make(tr("Save p&icture…"),
                     tr("Save the displayed step of the run, or the start of the scenario, as PNG, "
                        "SVG or PDF"),
                     kCtrl | kShift | Qt::Key_I);
  saveFilm = make(tr("Save fi&lm…"), tr("Save the run as a GIF, MP4 or WebP film"),
                  kCtrl | kShift | Qt::Key_F);
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
  importTracks = make(
      tr("Import tra&jectories…"),
      tr("Show recorded trajectories of people: CSV, JuPedSim, TrajNet++, ETH/UCY and others"));
}

void WindowActions::makeHelpActions() {
  palette = make(tr("&Find a command…"), tr("Search all commands and run one"),
                 kCtrl | kShift | Qt::Key_P, "search");
  preferences = make(tr("Preference&s…"),
                     tr("Theme, folders, copies of unsaved work and keyboard shortcuts"));
  tour = make(tr("&Guided tour"), tr("Place a person, run the simulation and read a metric"));
  manual = make(tr("&Manual"), tr("Open the manual page of what has the keyboard focus"),
                QKeySequence::HelpContents);
  whatsThis = make(tr("&What's this?"), tr("Click anything in the window for an explanation"),
                   QKeySequence::WhatsThis);
  shortcuts = make(tr("&Keyboard shortcuts…"), tr("Search and change all keyboard shortcuts"),
                   kCtrl | Qt::Key_F1);
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
  savePlot = make(tr("Save metric as plot…"),
                  tr("Save a plot of the selected metric over time: PNG, SVG or PDF"));
  paste =
      make(tr("&Paste"), tr("Insert the copied items at the mouse pointer"), QKeySequence::Paste);
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
  editor::MapView& view = workspace_.view();
  connect(zoomIn, &QAction::triggered, &view, &editor::MapView::zoomIn);
  connect(zoomOut, &QAction::triggered, &view, &editor::MapView::zoomOut);
  connect(zoomFit, &QAction::triggered, &view, [&view] { view.fitAll(); });
}

QList<QAction*> WindowActions::togglesOf(const std::vector<Toggle>& rows) {
  QList<QAction*> all;
  for (const Toggle& row : rows) {
    QAction* action = make(tr(row.text), tr(row.tip), row.shortcut, row.icon);
    bindOption(*action, workspace_.scene(), row.option);
    optionOf_[action] = row.option;
    all << action;
    if (row.action != nullptr) {
      this->*row.action = action;
    }
    if (row.key != nullptr) {
      stored_.emplace_back(action, row.key);
    }
  }
  return all;
}

void WindowActions::makeToggles() {
  using Actions = WindowActions;
  using Options = CanvasOptions;
  overlays = togglesOf(
      {{QT_TR_NOOP("&Names"), &Options::names, Qt::Key_N, kShowOrHide, "map/names", &Actions::names,
        "view-names"},
       {QT_TR_NOOP("Rou&tes"), &Options::routes, kShift | Qt::Key_R, kShowOrHide, "map/routes",
        &Actions::routes, "tool-route"},
       {QT_TR_NOOP("&Grid"), &Options::grid, kShift | Qt::Key_G, kShowOrHide, "map/grid",
        &Actions::grid, "view-grid"},
       {QT_TR_NOOP("R&ulers"), &Options::rulers, 0, kShowOrHide, "map/rulers"},
       {QT_TR_NOOP("Tr&ails"), &Options::trails, Qt::Key_T,
        QT_TR_NOOP("Past paths of people in a run"), "map/trails", nullptr, "view-trails"},
       {QT_TR_NOOP("&Personal spaces"), &Options::proxemics, Qt::Key_X,
        QT_TR_NOOP("Hall's zones around selected people; in a run around all if none is selected"),
        "map/rings", &Actions::rings, "view-rings"},
       {QT_TR_NOOP("For&ces"), &Options::forces, kShift | Qt::Key_F,
        QT_TR_NOOP("Forces on selected people in a run; on all if none is selected"), "map/forces",
        &Actions::forces, "view-forces"},
       {QT_TR_NOOP("Robot pat&hs"), &Options::robotPath, 0,
        QT_TR_NOOP("Paths that robot planners follow in a run"), "map/robotPath"},
       {QT_TR_NOOP("Lid&ar scans"), &Options::lidar, kShift | Qt::Key_L,
        QT_TR_NOOP("Lidar scans of robots in a run"), "map/lidar", &Actions::lidar},
       {QT_TR_NOOP("&Detections"), &Options::detections, kShift | Qt::Key_D,
        QT_TR_NOOP("Positions of people and of themselves as robots estimate them in a run"),
        "map/detections", &Actions::detections},
       {QT_TR_NOOP("Candidate tra&jectories"), &Options::candidates, kShift | Qt::Key_W,
        QT_TR_NOOP("Trajectories that robot planners evaluated in a run"), "map/ways",
        &Actions::candidates}});
  layers = togglesOf({{QT_TR_NOOP("&Map"), &Options::map, 0, kShowOrHide},
                      {QT_TR_NOOP("&People"), &Options::people, 0, kShowOrHide},
                      {QT_TR_NOOP("&Robots"), &Options::robots, 0, kShowOrHide},
                      {QT_TR_NOOP("&Goals"), &Options::goals, 0, kShowOrHide},
                      {QT_TR_NOOP("&Obstacles and doors"), &Options::obstacles, 0, kShowOrHide},
                      {QT_TR_NOOP("&Areas and docks"), &Options::areas, 0, kShowOrHide},
                      {QT_TR_NOOP("Gro&ups"), &Options::groups, 0, kShowOrHide}});
  snapping = togglesOf({{QT_TR_NOOP("Snap to p&oints"), &Options::snapToPoints, Qt::Key_S,
                         QT_TR_NOOP("Snap drawn items to corners, ends and centres of other items"),
                         nullptr, &Actions::snapToPoints, "snap"},
                        {QT_TR_NOOP("Snap to &walls"), &Options::snapToWalls, 0,
                         QT_TR_NOOP("Snap drawn items to corners and edges of map walls")},
                        {QT_TR_NOOP("Snap to the gr&id"), &Options::snapToGrid, kShift | Qt::Key_S,
                         QT_TR_NOOP("Snap drawn items to a grid of 0.5 m")},
                        {QT_TR_NOOP("Alignment guides"), &Options::guides, 0,
                         QT_TR_NOOP("Align dragged items with edges, centres and distances of "
                                    "others; Alt suspends this"),
                         "map/guides"}});
  makeRunOverlays();
}

void WindowActions::makeRunOverlays() {
  using Options = CanvasOptions;
  runOverlays = togglesOf(
      {{QT_TR_NOOP("&Density of people"), &Options::density, kShift | Qt::Key_H,
        QT_TR_NOOP("People per m² as a colour map"), "map/density"},
       {QT_TR_NOOP("&Field of view"), &Options::sight, kShift | Qt::Key_E,
        QT_TR_NOOP("Area that the selected people see; walls block the view"), "map/sight"},
       {QT_TR_NOOP("&Gaussian spaces"), &Options::gaussian, kShift | Qt::Key_X,
        QT_TR_NOOP("Gaussian personal space, longer in the walking direction"), "map/gaussian"},
       {QT_TR_NOOP("&Velocities"), &Options::velocities, kShift | Qt::Key_V,
        QT_TR_NOOP("Velocity vector of each body"), "map/velocities"},
       {QT_TR_NOOP("Peopl&e's paths"), &Options::plans, kShift | Qt::Key_P,
        QT_TR_NOOP("Remaining path of each person; newest step only"), "map/plans"},
       {QT_TR_NOOP("C&ontacts"), &Options::contacts, kShift | Qt::Key_C,
        QT_TR_NOOP("Where bodies touched, and which body ran into the other"), "map/contacts"},
       {QT_TR_NOOP("T&houghts"), &Options::thoughts, kShift | Qt::Key_T,
        QT_TR_NOOP("Current action of each person and its reason, below the name"), "map/thoughts"},
       {QT_TR_NOOP("&Speech"), &Options::speech, kShift | Qt::Key_B,
        QT_TR_NOOP("What people say, and which people hear it"), "map/speech"},
       {QT_TR_NOOP("&Local costmap"), &Options::localCosts, kShift | Qt::Key_M,
        QT_TR_NOOP("Local costmap that the controller of a robot with Nav2 uses"),
        "map/localCosts"},
       {QT_TR_NOOP("Gl&obal costmap"), &Options::globalCosts, kShift | Qt::Key_K,
        QT_TR_NOOP("Global costmap that the planner of a robot with Nav2 uses"), "map/globalCosts"},
       {QT_TR_NOOP("F&ilter masks"), &Options::masks, kShift | Qt::Key_J,
        QT_TR_NOOP("Keepout zones and speed limits of the costmap filters of a robot with Nav2"),
        "map/masks"}});
}

void WindowActions::makeLayerGroups() {
  const auto add = [this](const QString& title, const QList<QAction*>& actions) {
    LayerGroup& group = layerGroups_.emplace_back(LayerGroup{title, {}});
    for (QAction* action : actions) {
      group.layers.push_back({action, optionOf_.at(action)});
    }
  };
  // `overlays`: names, routes, grid, rulers, trails, spaces, forces, then perception of robots.
  constexpr int kAlways = 4, kOfPeople = 3, kPeopleInRun = 8;
  add(tr("Background"), QList<QAction*>{layers.front()} << overlays.mid(2, 2));
  add(tr("Scenario"), layers.mid(1) << overlays.mid(0, 2));
  add(tr("People in a run"), overlays.mid(kAlways, kOfPeople) << runOverlays.mid(0, kPeopleInRun));
  add(tr("Robots in a run"), overlays.mid(kAlways + kOfPeople) << runOverlays.mid(kPeopleInRun));
}

void WindowActions::restoreOpacities(const UserSettings& userSettings) {
  const QVariantMap stored = userSettings.value(kOpacities).toMap();
  CanvasOptions options = workspace_.scene().options();
  for (const auto& [action, key] : stored_) {
    const double opacity = stored.value(QString::fromLatin1(key), 1.0).toDouble();
    options.setOpacity(optionOf_.at(action), std::clamp(opacity, 0.1, 1.0));
  }
  workspace_.scene().setOptions(options);
}

void WindowActions::storeOpacities(UserSettings& userSettings) const {
  QVariantMap opacities;
  for (const auto& [action, key] : stored_) {
    opacities[QString::fromLatin1(key)] =
        workspace_.scene().options().opacityOf(optionOf_.at(action));
  }
  userSettings.setValue(kOpacities, opacities);
}

void WindowActions::restoreAndStore(UserSettings& userSettings) {
  restoreOpacities(userSettings);
  for (const auto& [action, key] : stored_) {
    const QVariant before = userSettings.value(key);
    if (before.isValid()) {
      action->setChecked(before.toBool());
    }
    connect(action, &QAction::toggled, this,
            [&userSettings, where = key](bool on) { userSettings.setValue(where, on); });
  }
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
    editor::pushRemove(document, document.selection());
  });
  connect(paste, &QAction::triggered, this, [this] { pasteAt(workspace_.view().pointer()); });
  connect(QGuiApplication::clipboard(), &QClipboard::dataChanged, this,
          &WindowActions::updateEnabled);
}

void WindowActions::pasteAt(const std::optional<base::Vec2>& place) {
  if (const QMimeData* data = QGuiApplication::clipboard()->mimeData()) {
    editor::pasteAt(workspace_.document(), *data, place);
  }
}

void WindowActions::copySelection() {
  QGuiApplication::clipboard()->setMimeData(
      editor::copiedSelection(workspace_.document()).release());
}

void WindowActions::updateEnabled() {
  const bool editing = workspace_.runner().state() == editor::SimulationRunner::State::Editing;
  const std::size_t count = workspace_.document().selection().size();
  const bool any = count > 0;
  const QString inRun = tr("Not during a run: Ctrl+R returns to editing");
  const QString none = editing ? tr("Select something first") : inRun;
  for (QAction* action : {cut, duplicate, remove}) {
    editor::setEnabled(*action, any && editing, none);
  }
  editor::setEnabled(*copy, any, tr("Select something first"));
  editor::setEnabled(*rename, editing && count == 1,
                     editing ? tr("Select exactly one item first") : inRun);
  editor::setEnabled(*paste, editing && editor::canPaste(QGuiApplication::clipboard()->mimeData()),
                     editing ? tr("The clipboard contains no items of a scenario") : inRun);
  for (QAction* action : {openMap, assignGoals}) {
    editor::setEnabled(*action, editing, inRun);
  }
  for (const auto& [action, least] : arranging_) {
    editor::setEnabled(
        *action, editing && count >= least,
        editing
            ? tr("Select at least %1 first").arg(editor::counted(least, tr("item"), tr("items")))
            : inRun);
  }
}

void WindowActions::setTheme(const editor::Theme& theme) {
  for (const auto& [action, icon] : icons_) {
    action->setIcon(editor::themedIcon(QString::fromLatin1(icon), theme));
  }
}

}  // namespace app

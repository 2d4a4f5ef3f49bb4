#include "app/window/WindowActions.h"

#include "editor/canvas/Tool.h"
#include "editor/document/EditCommands.h"
#include "editor/look/Form.h"
#include "editor/look/Icons.h"
#include "editor/tools/SelectionActions.h"

namespace app {

using editor::EntityId;

namespace {

// Integers, because keys and modifiers are different enums.
constexpr int kCtrl = Qt::CTRL;
constexpr int kShift = Qt::SHIFT;

}  // namespace

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
  openRun =
      make(tr("Open r&un…"),
           tr("Open a recorded run or the results of a study: the output folder of a command"),
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
  history = make(tr("&Memory for runs…"), tr("Set the memory for the recorded steps of a run"));
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

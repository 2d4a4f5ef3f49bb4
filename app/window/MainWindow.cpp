#include "app/window/MainWindow.h"

#include "app/window/ContactNotes.h"
#include "app/window/NoticeBar.h"
#include "app/window/PlotExport.h"
#include "app/window/RunCommands.h"
#include "app/window/TreeCommands.h"
#include "app/window/export/RunExportCommands.h"
#include "app/window/files/FileCommands.h"
#include "app/window/files/FileDialogs.h"
#include "editor/look/AppStyle.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/look/Icons.h"
#include "editor/look/TableExport.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/ScenarioPanel.h"
#include "editor/panels/behavior/BehaviorPanel.h"
#include "editor/panels/behavior/GoalAssignment.h"
#include "editor/panels/runs/SideBySide.h"
#include "editor/trees/TreeEditor.h"

namespace app {

using editor::SimulationRunner;

namespace {

constexpr const char* kGeometryKey = "window/geometry";
constexpr const char* kWindowStateKey = "window/state";
constexpr const char* kThemeKey = "window/theme";
constexpr int kLayoutVersion = 2;
constexpr QSize kLeastWindow(860, 480);  // fits 1920 x 1080 at 200 % with the timeline
constexpr const char* kCutNotice = "cut-run";
constexpr const char* kOptionsNotice = "options";
constexpr int kSavedWidth = 120;
constexpr int kMenuHeight = 28;
constexpr int kLeastMiddle = 160;  // [px]

}  // namespace

MainWindow::MainWindow(const WindowSetup& setup, QWidget* parent)
    : QMainWindow(parent),
      workspace_(setup.theme, setup.tools),
      userSettings_(setup.storesSettings),
      followsSystem_(setup.followsSystem),
      notices_(new NoticeBar(setup.theme, this)),
      docks_(new Docks(*this, workspace_, setup.panels)),
      files_(
          new FileCommands(workspace_, docks_->panel<editor::IssuesPanel>(), userSettings_, *this)),
      toolBar_(makeToolBar(*this, workspace_, *actions_, *docks_)) {
  setObjectName(QStringLiteral("window"));
  setMinimumSize(kLeastWindow);
  resize(std::min(defaultSize().width(), screen()->availableGeometry().width()),
         editor::limitedToScreen(*this, defaultSize().height()));
  setContextMenuPolicy(Qt::NoContextMenu);
  setWindowIcon(editor::themedIcon(QStringLiteral("app"), editor::Theme::light()));
  workspace_.document().setShippedMaps(setup.shippedMaps);
  workspace_.setRunSettings({setup.compatibility, setup.options.threads, setup.options.exact});
  if (setup.options.allowCode) {
    workspace_.allowAllCodeOf(QString::fromStdString(setup.options.scenario));
  }
  askBeforeExternalCode(workspace_, *notices_);
  files_->setOptions(setup.options, setup.compatibility);
  if (setup.storesSettings) {  // not in pictures
    connect(files_, &FileCommands::optionsApplied, this, &MainWindow::reportOptions);
    connect(&workspace_.document().undoStack(), &QUndoStack::indexChanged, this,
            [this] { notices_->drop(QString::fromLatin1(kOptionsNotice)); });
  }
  workspace_.runner().setHistory(historyMemory(userSettings_));
  actions_->restoreAndStore(userSettings_);
  placeParts(setup);
  connectFiles();
  connectView();
  connectRun();
  const auto* runs = new PlaybackSettings(workspace_, userSettings_, this);
  connect(files_, &FileCommands::runOpened, runs, &PlaybackSettings::restoreLoop);
  new RunSharing(workspace_, *actions_->publishFoxglove, *actions_->publishRos2, *notices_,
                 notices_);
  const auto* figures = new FigureCommands(workspace_, *docks_, *actions_, docks_);
  exports_ = new RunExportCommands(workspace_, *docks_, *actions_, userSettings_, *this);
  const auto* plots = new PlotExport(workspace_, docks_->context(), *this);
  const auto tell = [this](const QString& words) { statusBar()->showMessage(words, kMessageMs); };
  connect(figures, &FigureCommands::message, this, tell);
  connect(plots, &PlotExport::message, this, tell);
  connect(files_, &FileCommands::message, this, tell);
  connect(exports_, &RunExportCommands::saved, this,
          [tell](const QString& file) { tell(tr("Saved %1").arg(file)); });
  if (restoreGeometry(userSettings_.value(kGeometryKey).toByteArray())) {
    resize(size().boundedTo(screen()->availableSize()));  // the last screen may have been larger
  }
  guard_ = new DocumentGuard(workspace_, *files_, *notices_, setup.recoveryFolder,
                             setup.openFilesFolder, this);
  connect(guard_, &DocumentGuard::scenarioFileChanged, this, &MainWindow::showTitle);
  addHelp(setup);
  showStart(true);
  showTitle();
  const QString theme = userSettings_.value(kThemeKey).toString();
  const bool isDark = theme == QLatin1String("dark");
  if (followsSystem_ && (isDark || theme == QLatin1String("light"))) {
    setTheme(isDark ? editor::Theme::dark() : editor::Theme::light());
    actions_->systemTheme->setChecked(false);  // stores the theme, so after setting it
  }
}

void MainWindow::placeParts(const WindowSetup& setup) {
  addToolBar(Qt::TopToolBarArea, toolBar_);
  recent_ = makeMenus(*this, workspace_, *actions_, *docks_);
  status_->addPanels(docks_->bottomToggles());
  saved_->setContentsMargins(0, 0, 12, 0);
  saved_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  saved_->setFixedSize(kSavedWidth, kMenuHeight);
  saved_->setForegroundRole(QPalette::PlaceholderText);
  menuBar()->setCornerWidget(saved_);
  startPage_ =
      new StartPage(workspace_, *actions_, userSettings_, setup.demos, setup.thumbnailFolder, this);
  centre_->addWidget(startPage_);
  keys_->setStartPage(*startPage_);
  auto* pane = new QWidget(this);
  editor::configuredLayout(new QVBoxLayout(pane), {}, 0, {paneTitle_})
      ->addWidget(&workspace_.view(), 1);
  paneTitle_->hide();
  canvas_->addWidget(pane);
  canvas_->setChildrenCollapsible(false);
  centre_->addWidget(canvas_);
  workspace_.view().setAcceptDrops(false);  // drops are handled by the window
  setAcceptDrops(true);
  auto* middle = new QWidget(this);
  editor::configuredLayout(new QVBoxLayout(middle), {}, 0)->addWidget(centre_, 1);
  connect(notices_, &NoticeBar::coverChanged, &workspace_.view(), &editor::MapView::setCoveredTop);
  notices_->coverTop(*middle);
  middle->setMinimumHeight(kLeastMiddle);
  docks_->setCentre(middle);
  // Not by a focus proxy of the splitter: Tab would return to the map before it reaches the panels.
  connect(notices_, &NoticeBar::focusReleased, this, [this] {
    (isOnStartPage() ? static_cast<QWidget*>(startPage_) : &workspace_.view())->setFocus();
  });
  setCentralWidget(middle);
  connect(docks_->treeMaximized(), &QAction::toggled, this, [this, middle](bool on) {
    auto* tree = on ? findChild<editor::TreeEditor*>() : nullptr;  // keeps notices visible
    tree == nullptr ? notices_->coverTop(*middle)
                    : notices_->insertInto(*qobject_cast<QBoxLayout*>(tree->layout()));
  });
}

/// Objects connected to the workspace are deleted before it, because its destructor emits signals.
MainWindow::~MainWindow() {
  workspace_.document().disconnect(this);
  workspace_.document().undoStack().disconnect(this);
  workspace_.runner().disconnect(this);
  workspace_.feed().disconnect(this);
  delete tour_;
  delete help_;
  delete preferences_;
  delete guard_;
  delete exports_;
  delete status_;
  delete files_;
  qDeleteAll(findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly));
  qDeleteAll(findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly));
  delete takeCentralWidget();
  delete docks_;
  delete actions_;
}

void MainWindow::connectFiles() {
  FileCommands* files = files_;
  files->connectActions(*actions_);
  connect(actions_->quit, &QAction::triggered, this, &QWidget::close);
  connect(actions_->shortcuts, &QAction::triggered, this, &MainWindow::showShortcuts);
  connect(actions_->preferences, &QAction::triggered, this, &MainWindow::showPreferences);
  connect(actions_->tour, &QAction::triggered, this, &MainWindow::startTour);
  connect(actions_->history, &QAction::triggered, this, [this] {
    showHistoryDialog(userSettings_, workspace_.runner(), workspace_.theme(), this);
  });
  connect(actions_->about, &QAction::triggered, this, &MainWindow::showAbout);
  connect(recent_, &QMenu::aboutToShow, this, [this] { files_->fillRecentMenu(*recent_); });
  files_->fillRecentMenu(*recent_);
  connect(files, &FileCommands::recentChanged, this, [this] {
    files_->fillRecentMenu(*recent_);
    startPage_->fillRecent();
  });
  connect(files, &FileCommands::opened, this, [this] {
    showStart(false);
    workspace_.view().fitAll(false);
  });
  docks_->context().folder = [files] { return files->folder(); };
  connect(files, &FileCommands::closed, this, [this] { showStart(true); });
  connect(files, &FileCommands::issuesRaised, this, [this] {
    if (isOnStartPage()) {
      guard_->reportUnreadable(files_->problems());
      startPage_->fillRecent();  // the file may be missing
      return;
    }
    showDock(QStringLiteral("issues"));
  });
  connect(startPage_, &StartPage::fileRequested, files, &FileCommands::openFile);
  StudyPanel& study = docks_->panel<StudyPanel>();
  askBeforeExternalCode(study, *notices_);
  files_->setStudyCheck([&study] { return study.isRunning(); });
  connect(&study, &StudyPanel::openRunRequested, this,
          [files](const QString& run, bool isTemporary) {
            if (files->maybeSave()) {
              files->openRun(run, isTemporary);
            }
          });
  connect(&study, &StudyPanel::saveRequested, files, &FileCommands::save);
  connect(files, &FileCommands::studyOpened, this, [this](const QString& path) {
    if (isOnStartPage()) {
      files_->newOpenPlane();
    }
    showDock(QStringLiteral("study"));
    docks_->panel<StudyPanel>().openFile(path);
  });
  editor::ScenarioDocument& document = workspace_.document();
  connect(&document, &editor::ScenarioDocument::aboutToBeReplaced, this,
          [this] { editor::commitPendingEdit(*this); });
  connect(&document, &editor::ScenarioDocument::pathChanged, this, &MainWindow::showTitle);
  connect(&document, &editor::ScenarioDocument::dirtyChanged, this, &MainWindow::showTitle);
}

void MainWindow::showDock(const QString& name) {
  QDockWidget* dock = docks_->dock(name);
  dock->show();
  dock->raise();
}

void MainWindow::connectView() {
  connectCanvasMenu(workspace_, *actions_, *docks_);
  auto& layers = docks_->panel<editor::LayersPanel>();
  for (const WindowActions::LayerGroup& group : actions_->layerGroups()) {
    layers.addGroup(group.title, group.layers);
  }
  connect(&layers, &editor::LayersPanel::opacityChanged, this,
          [this] { actions_->storeOpacities(userSettings_); });
  connect(actions_->fullScreen, &QAction::toggled, this, &MainWindow::showFullScreenMap);
  connect(actions_->resetLayout, &QAction::triggered, docks_, &Docks::resetLayout);
  actions_->systemTheme->setChecked(followsSystem_);
  connect(actions_->switchTheme, &QAction::triggered, this, [this] {
    actions_->systemTheme->setChecked(false);
    setTheme(workspace_.theme().isDark() ? editor::Theme::light() : editor::Theme::dark());
    saveTheme();
  });
  connect(actions_->systemTheme, &QAction::toggled, this, [this](bool on) {
    followsSystem_ = on;
    if (on) {
      setTheme(editor::Theme::fromSystem(QApplication::style()->standardPalette()));
    }
    saveTheme();
  });
  connect(actions_->rename, &QAction::triggered, this, [this] {
    const std::vector<editor::EntityId>& selection = workspace_.document().selection();
    if (!selection.empty()) {
      docks_->panel<editor::ScenarioPanel>().rename(selection.front());
    }
  });
  connect(&docks_->context(), &editor::PanelContext::sideViewRequested, this,
          &MainWindow::showSideBySide);
  connect(&docks_->context(), &editor::PanelContext::panelRequested, this, &MainWindow::showDock);
  connect(&docks_->context(), &editor::PanelContext::canvasTitleChanged, this,
          [this](const QString& title) {
            editor::stylePaneTitle(*paneTitle_, workspace_.theme());
            paneTitle_->setText(title);
            paneTitle_->setVisible(!title.isEmpty());
          });
  connect(&docks_->context(), &editor::PanelContext::fileRequested, this, &MainWindow::showFile);
  const auto assign = [this] {
    editor::openGoalAssignment(workspace_.document(), workspace_.theme(), this);
  };
  connect(actions_->assignGoals, &QAction::triggered, this, assign);
  connect(&docks_->context(), &editor::PanelContext::goalsRequested, this, assign);
}

void MainWindow::connectRun() {
  SimulationRunner& runner = workspace_.runner();
  connect(&runner, &SimulationRunner::stateChanged, this, &MainWindow::updateActions);
  connect(&runner, &SimulationRunner::inputsRefused, this,
          [this](const base::Diagnostics& problems) {
            statusBar()->showMessage(QString::fromStdString(problems.front().message), kMessageMs);
          });
  connect(files_, &FileCommands::runOpened, this, [this](const QString& folder) {
    showContactNotes(folder, workspace_);
    const std::optional<base::Diagnostic> cut = files_->truncationOfRun();
    cut ? notices_->warn(QString::fromLatin1(kCutNotice), QString::fromStdString(cut->message))
        : notices_->drop(QString::fromLatin1(kCutNotice));
  });
  connect(&runner, &SimulationRunner::stateChanged, this, [this] {
    if (!workspace_.isRecordedRun()) {
      notices_->drop(QString::fromLatin1(kCutNotice));
    }
  });
  connect(&workspace_, &Workspace::editReverted, this, [this] {
    statusBar()->showMessage(tr("A recorded run cannot be edited: Ctrl+R closes it"), kMessageMs);
  });
  const auto raise = [this](const base::Diagnostics& problems) {
    Q_EMIT docks_->context().problemsFound(problems);
    showDock(QStringLiteral("issues"));
  };
  const auto* trees = new TreeCommands(workspace_, *docks_, *notices_, *this);
  connect(trees, &TreeCommands::issuesRequested, this,
          [this] { showDock(QStringLiteral("issues")); });
  connect(trees, &TreeCommands::message, this,
          [this](const QString& text) { statusBar()->showMessage(text, kMessageMs); });
  connect(&workspace_.feed(), &editor::MetricsFeed::failed, this, raise);
  connect(&runner, &SimulationRunner::failed, this, [raise](const QString& reason) {
    raise({base::error("run.failed", {reason.toStdString()})});
  });
  const auto list = [this](const base::Diagnostics& remarks) {
    Q_EMIT docks_->context().problemsFound(remarks);
  };
  connect(&runner, &SimulationRunner::warned, this, list);
  connect(&runner, &SimulationRunner::breakpointHit, this, &MainWindow::showBreakpoint);
  connect(&runner, &SimulationRunner::historyTruncated, this, list);
}

/// Selects the person and the node at which a breakpoint stopped the run.
void MainWindow::showBreakpoint(const sim2d::TreeBreakpointHit& at) {
  editor::ScenarioDocument& document = workspace_.document();
  for (const sim2d::Human& human : document.scenario().humans) {
    if (human.id == at.person) {
      document.setSelection({human.key});
    }
  }
  showDock(QStringLiteral("behaviour"));
  editor::TreeOutline& outline = docks_->panel<editor::BehaviorPanel>().outline();
  outline.selectNode(outline.nodeNamed(at.at.path));
}

void MainWindow::updateActions() {
  const bool isRecorded = workspace_.isRecordedRun();
  const QString closed = tr("Open a scenario first");
  for (QAction* action : {actions_->save, actions_->saveAs, actions_->exportTo}) {
    editor::setEnabled(*action, !isOnStartPage() && !isRecorded,
                       isRecorded ? tr("A recorded run is shown: Ctrl+R closes it") : closed);
  }
  editor::setEnabled(
      *actions_->openMap,
      !isOnStartPage() && workspace_.runner().state() == SimulationRunner::State::Editing,
      isOnStartPage() ? closed : tr("Not during a run: Ctrl+R returns to editing"));
  for (QAction* action :
       {actions_->close, workspace_.playback().playPause, workspace_.playback().step}) {
    editor::setEnabled(*action, !isOnStartPage(), closed);
  }
  showTitle();
}

void MainWindow::showSideBySide(QWidget* view, int columns) {
  if (view != nullptr) {
    canvas_->addWidget(view);
    const int column = canvas_->width() / (columns + 1);
    canvas_->setSizes({column, columns * column});
    view->show();
  }
  editor::later(*canvas_, [this] { workspace_.view().fitAll(false); });  // after layout
}

void MainWindow::showStart(bool start) {
  centre_->setCurrentWidget(start ? static_cast<QWidget*>(startPage_) : canvas_);
  docks_->setShown(!start);
  toolBar_->setVisible(!start);
  status_->setIdle(start);
  if (start) {
    tour_->stop();
  }
  exports_->setOpen(!start);
  updateActions();
  if (!start) {
    workspace_.view().setFocus();
    if (!std::exchange(placed_, true) &&  // first display: restore the last layout
        !restoreState(userSettings_.value(kWindowStateKey).toByteArray(), kLayoutVersion)) {
      docks_->setInitialSizes();
    }
  }
}

void MainWindow::showTitle() {
  setProperty(editor::kFolderProperty, files_->folder());
  const editor::ScenarioDocument& document = workspace_.document();
  if (isOnStartPage()) {
    setWindowTitle(tr("HuNavSim Desktop"));
    setWindowModified(false);
    saved_->clear();
    return;
  }
  if (workspace_.isRecordedRun()) {
    setWindowTitle(tr("%1 (recorded run) – HuNavSim Desktop").arg(workspace_.recordedName()));
    setWindowModified(false);
    saved_->setText(tr("Recorded run"));
    return;
  }
  setWindowTitle(document.displayName() + QStringLiteral("[*] – HuNavSim Desktop"));
  const bool isOnlyHere = document.isDirty() || files_->isFileMissing();
  setWindowModified(isOnlyHere);
  setWindowFilePath(document.path());
  saved_->setText(isOnlyHere                  ? tr("Not saved")
                  : document.isReadOnly()     ? tr("Read only")
                  : document.path().isEmpty() ? tr("New")
                                              : tr("Saved"));
}

void MainWindow::setTheme(const editor::Theme& theme) {
  editor::applyTheme(theme);
  workspace_.setTheme(theme);
  actions_->setTheme(theme);
  Q_EMIT docks_->context().themeChanged(theme);
  startPage_->showTheme();
  notices_->setTheme(theme);
  status_->setTheme();
  if (viewer_ != nullptr) {
    viewer_->setTheme(theme);
  }
}

void MainWindow::showFullScreenMap(bool on) {
  if (!isOnStartPage()) {
    menuBar()->setVisible(!on);
    docks_->setShown(!on);  // first, because it saves the tool bar state
    toolBar_->setVisible(!on);
    statusBar()->setVisible(!on);
    addAction(actions_->fullScreen);  // keeps the shortcut without a menu bar
  }
  on ? showFullScreen() : showNormal();
}

void MainWindow::saveLayout() {
  docks_->treeMaximized()->setChecked(false);  // the next session starts with the map
  userSettings_.setValue(kGeometryKey, saveGeometry());
  if (!isOnStartPage()) {
    userSettings_.setValue(kWindowStateKey, saveState(kLayoutVersion));
  }
}

void MainWindow::reportOptions() {
  notices_->inform(
      QString::fromLatin1(kOptionsNotice),
      tr("The options of the command line replace values of %1. Saving writes them to the file.")
          .arg(workspace_.document().displayName()),
      {{tr("Use the values of the file"), [this] {
          workspace_.document().undoStack().undo();
          workspace_.document().undoStack().setClean();
        }}});
}

void MainWindow::endSession() {
  editor::commitPendingEdit(*this);
  guard_->endSession();
  saveLayout();
  QApplication::exit();  // also leaves the event loops of dialogs
}

/// Stores a theme chosen in the window, not one given on the command line.
void MainWindow::saveTheme() {
  userSettings_.setValue(kThemeKey, followsSystem_                ? QStringLiteral("system")
                                    : workspace_.theme().isDark() ? QStringLiteral("dark")
                                                                  : QStringLiteral("light"));
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!files_->maybeSave()) {
    event->ignore();
    return;
  }
  saveLayout();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls.front().isLocalFile()) {
    event->acceptProposedAction();
  }
}

/// Opens the file, or assigns a tree to the person it is dropped on.
void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  const editor::MapView& view = workspace_.view();
  editor::EntityId under;
  if (view.isVisible() && view.rect().contains(view.mapFrom(this, event->pos()))) {
    const QPoint at = view.viewport()->mapFrom(this, event->pos());
    under = workspace_.scene().entityAt(view.worldAt(at));
  }
  // Deferred: the drag source is blocked until this returns, and dialogs may follow.
  const QString path = event->mimeData()->urls().front().toLocalFile();
  editor::later(*files_, [this, path, under] { files_->dropFile(path, under); });
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  event->ignore();
  keys_->handleUnusedKey(*event);
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::ThemeChange && followsSystem_) {
    setTheme(editor::Theme::fromSystem(QApplication::style()->standardPalette()));
  }
}

}  // namespace app

#include "app/window/MainWindow.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QScreen>

#include "app/window/CodeQuestion.h"
#include "app/window/DocumentGuard.h"
#include "app/window/FigureCommands.h"
#include "app/window/FileDialogs.h"
#include "app/window/HistoryDialog.h"
#include "app/window/KeyRules.h"
#include "app/window/NoticeBar.h"
#include "app/window/RunMemory.h"
#include "app/window/RunSharing.h"
#include "app/window/ShortcutsDialog.h"
#include "app/window/StatusLine.h"
#include "app/window/ToolBars.h"
#include "editor/look/DeleteWhenClosed.h"
#include "editor/look/Form.h"
#include "editor/look/HouseStyle.h"
#include "editor/look/Icons.h"
#include "editor/look/Later.h"
#include "editor/look/Typing.h"
#include "editor/panels/BehaviorPanel.h"
#include "editor/panels/GoalAssignment.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/ScenarioPanel.h"
#include "editor/panels/TextViewer.h"
#include "editor/trees/TreeStudio.h"

namespace app {

using editor::SimulationRunner;

namespace {

constexpr const char* kGeometryKey = "window/geometry";
constexpr const char* kWindowStateKey = "window/state";
constexpr const char* kThemeKey = "window/theme";
constexpr int kLayoutVersion = 2;
constexpr QSize kLeastWindow(860, 480);  // fits 1920 x 1080 at 200 %, the time line too
constexpr const char* kCutNotice = "cut-run";
constexpr int kSavedWidth = 120;
constexpr int kMenuHeight = 28;
constexpr int kMessageMs = 8000;
constexpr int kLeastMiddle = 160;  // whatever notices want: the canvas gives up room, no panel does

}  // namespace

MainWindow::MainWindow(const WindowSetup& setup, QWidget* parent)
    : QMainWindow(parent),
      workspace_(setup.theme, setup.tools),
      memory_(setup.remembers),
      followsSystem_(setup.followsSystem),
      actions_(new WindowActions(workspace_, this)),
      keys_(new KeyRules(*this, workspace_)),
      notices_(new NoticeBar(setup.theme, this)),
      centre_(new QStackedWidget(this)),
      canvas_(new QSplitter(Qt::Horizontal, this)),
      docks_(new Docks(*this, workspace_, setup.panels)),
      files_(new FileCommands(workspace_, docks_->panel<editor::IssuesPanel>(), memory_, *this)),
      status_(new StatusLine(*statusBar(), workspace_)),
      toolBar_(makeToolBar(*this, workspace_, *actions_)),
      saved_(new QLabel(this)) {
  setObjectName(QStringLiteral("window"));
  setMinimumSize(kLeastWindow);
  resize(std::min(usualSize().width(), screen()->availableGeometry().width()),
         editor::heightOnScreen(*this, usualSize().height()));
  setContextMenuPolicy(Qt::NoContextMenu);
  setWindowIcon(editor::themedIcon(QStringLiteral("app"), editor::Theme::light()));
  workspace_.document().setShippedMaps(setup.shippedMaps);
  workspace_.setRunSettings({setup.compatibility, setup.options.threads, setup.options.exact});
  if (setup.options.allowCode) {
    workspace_.allowCodeOf(QString::fromStdString(setup.options.scenario));
  }
  new CodeQuestion(workspace_, *notices_, notices_);  // goes with them, before the workspace
  files_->setOptions(setup.options, setup.compatibility);
  workspace_.runner().setHistory(historyMemory(memory_));
  actions_->remember(memory_);
  placeParts(setup);
  connectFiles();
  connectView();
  connectRun();
  const auto* runs = new RunMemory(workspace_, memory_, this);
  connect(files_, &FileCommands::runOpened, runs, &RunMemory::followRun);
  new RunSharing(workspace_, *actions_->watchLive, *actions_->onRos2, *notices_, notices_);
  const auto* figures = new FigureCommands(workspace_, *docks_, *actions_, docks_);
  connect(figures, &FigureCommands::told, this,
          [this](const QString& words) { statusBar()->showMessage(words, kMessageMs); });
  restoreGeometry(memory_.value(kGeometryKey).toByteArray());
  guard_ = new DocumentGuard(workspace_, *files_, *notices_, setup.recoveryFolder, this);
  connect(guard_, &DocumentGuard::scenarioThere, this, &MainWindow::showTitle);
  showStart(true);
  showTitle();
  const QString theme = memory_.value(kThemeKey).toString();
  const bool isDark = theme == QLatin1String("dark");
  if (followsSystem_ && (isDark || theme == QLatin1String("light"))) {
    setTheme(isDark ? editor::Theme::dark() : editor::Theme::light());
    actions_->systemTheme->setChecked(false);  // remembers the theme: it is there by now
  }
}

void MainWindow::placeParts(const WindowSetup& setup) {
  addToolBar(Qt::TopToolBarArea, toolBar_);
  recent_ = makeMenus(*this, workspace_, *actions_, *docks_);
  status_->addPanels(docks_->togglesBelow());
  saved_->setContentsMargins(0, 0, 12, 0);
  saved_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  saved_->setFixedSize(kSavedWidth, kMenuHeight);
  saved_->setForegroundRole(QPalette::PlaceholderText);
  menuBar()->setCornerWidget(saved_);
  startPage_ = new StartPage(workspace_, *actions_, memory_, setup.demos, this);
  centre_->addWidget(startPage_);
  canvas_->addWidget(&workspace_.view());
  canvas_->setChildrenCollapsible(false);
  canvas_->setFocusProxy(&workspace_.view());
  centre_->addWidget(canvas_);
  workspace_.view().setAcceptDrops(false);  // files fall through to the window
  setAcceptDrops(true);
  auto* middle = new QWidget(this);
  editor::arranged(new QVBoxLayout(middle), {}, 0, {notices_})->addWidget(centre_, 1);
  middle->setMinimumHeight(kLeastMiddle);
  docks_->setCentre(middle);
  connect(notices_, &NoticeBar::keyboardFree, this,
          [this] { centre_->currentWidget()->setFocus(); });
  setCentralWidget(middle);
  auto* above = qobject_cast<QVBoxLayout*>(middle->layout());
  connect(docks_->treeLarge(), &QAction::toggled, this, [this, above](bool on) {
    auto* tree = on ? findChild<editor::TreeStudio*>() : nullptr;  // notices stay in sight
    QVBoxLayout* to = tree == nullptr ? above : qobject_cast<QVBoxLayout*>(tree->layout());
    to->insertWidget(0, notices_);
    notices_->setVisible(!notices_->notices().empty());
  });
}

/// Who listens to the workspace goes before it: its end still makes changes that are told.
MainWindow::~MainWindow() {
  workspace_.document().disconnect(this);
  workspace_.runner().disconnect(this);
  workspace_.feed().disconnect(this);
  delete guard_;
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
  connect(actions_->newRoom, &QAction::triggered, this, [files] {
    if (files->mayLeave()) {
      files->newRoom();
    }
  });
  connect(actions_->newFromMap, &QAction::triggered, files, &FileCommands::askNewFromMap);
  connect(actions_->open, &QAction::triggered, files, &FileCommands::askOpen);
  connect(actions_->openRun, &QAction::triggered, files, &FileCommands::askOpenRun);
  connect(actions_->openMap, &QAction::triggered, files, &FileCommands::askOtherMap);
  connect(actions_->save, &QAction::triggered, files, &FileCommands::save);
  connect(actions_->saveAs, &QAction::triggered, files, &FileCommands::saveAs);
  connect(actions_->exportTo, &QAction::triggered, files, &FileCommands::askExport);
  connect(actions_->newWalledRoom, &QAction::triggered, files, &FileCommands::askNewRoom);
  connect(actions_->close, &QAction::triggered, this, [this] {
    if (files_->mayLeave()) {
      workspace_.document().clear();
      showStart(true);
    }
  });
  connect(actions_->quit, &QAction::triggered, this, &QWidget::close);
  connect(actions_->shortcuts, &QAction::triggered, this, &MainWindow::showShortcuts);
  connect(actions_->history, &QAction::triggered, this,
          [this] { askHistory(memory_, workspace_.runner(), workspace_.theme(), this); });
  connect(actions_->about, &QAction::triggered, this, &MainWindow::tellAbout);
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
      guard_->tellUnread(files_->problems());
      startPage_->fillRecent();  // it may have gone
      return;
    }
    showIssues();
  });
  connect(startPage_, &StartPage::fileWanted, files, &FileCommands::openFile);
  StudyPanel& study = docks_->panel<StudyPanel>();
  CodeQuestion::askFor(study, *notices_);
  connect(&study, &StudyPanel::runWanted, this, [files](const QString& run) {
    if (files->mayLeave()) {
      files->openFile(run);
    }
  });
  editor::ScenarioDocument& document = workspace_.document();
  connect(&document, &editor::ScenarioDocument::aboutToBeReplaced, this,
          [this] { editor::finishTyping(*this); });
  connect(&document, &editor::ScenarioDocument::pathChanged, this, &MainWindow::showTitle);
  connect(&document, &editor::ScenarioDocument::dirtyChanged, this, &MainWindow::showTitle);
}

void MainWindow::showIssues() {
  QDockWidget* issues = docks_->dock(QStringLiteral("issues"));
  issues->show();
  issues->raise();
}

void MainWindow::connectView() {
  connectCanvasMenu(workspace_, *actions_, *docks_);
  connect(actions_->fullScreen, &QAction::toggled, this, &MainWindow::showFullScreenMap);
  connect(actions_->resetLayout, &QAction::triggered, docks_, &Docks::resetLayout);
  actions_->systemTheme->setChecked(followsSystem_);
  connect(actions_->switchTheme, &QAction::triggered, this, [this] {
    actions_->systemTheme->setChecked(false);
    setTheme(workspace_.theme().isDark() ? editor::Theme::light() : editor::Theme::dark());
    rememberTheme();
  });
  connect(actions_->systemTheme, &QAction::toggled, this, [this](bool on) {
    followsSystem_ = on;
    if (on) {
      setTheme(editor::Theme::fromSystem(QApplication::style()->standardPalette()));
    }
    rememberTheme();
  });
  connect(actions_->rename, &QAction::triggered, this, [this] {
    const std::vector<editor::EntityId>& selection = workspace_.document().selection();
    if (!selection.empty()) {
      docks_->panel<editor::ScenarioPanel>().rename(selection.front());
    }
  });
  connect(&docks_->context(), &editor::PanelContext::besideWanted, this, &MainWindow::showBeside);
  connect(&docks_->context(), &editor::PanelContext::fileWanted, this, &MainWindow::showFile);
  const auto assign = [this] {
    editor::openGoalAssignment(workspace_.document(), workspace_.theme(), this);
  };
  connect(actions_->assignGoals, &QAction::triggered, this, assign);
  connect(&docks_->context(), &editor::PanelContext::goalsWanted, this, assign);
}

void MainWindow::connectRun() {
  SimulationRunner& runner = workspace_.runner();
  connect(&runner, &SimulationRunner::stateChanged, this, &MainWindow::followState);
  connect(&runner, &SimulationRunner::inputsRefused, this,
          [this](const base::Diagnostics& problems) {
            statusBar()->showMessage(QString::fromStdString(problems.front().message), kMessageMs);
          });
  connect(files_, &FileCommands::runOpened, this, [this](const QString& /*folder*/) {
    const std::optional<base::Diagnostic> cut = files_->cutOfRun();
    cut ? notices_->warn(QString::fromLatin1(kCutNotice), QString::fromStdString(cut->message))
        : notices_->drop(QString::fromLatin1(kCutNotice));
  });
  connect(&runner, &SimulationRunner::stateChanged, this, [this] {
    if (!workspace_.isOfRecord()) {
      notices_->drop(QString::fromLatin1(kCutNotice));
    }
  });
  connect(&workspace_, &Workspace::editRefused, this, [this] {
    statusBar()->showMessage(tr("A recorded run is not edited: Ctrl+R leaves it"), kMessageMs);
  });
  const auto raise = [this](const base::Diagnostics& problems) {
    Q_EMIT docks_->context().problemsFound(problems);
    showIssues();
  };
  connect(&runner, &SimulationRunner::notStarted, this, raise);
  connect(&workspace_.feed(), &editor::MetricsFeed::failed, this, raise);
  connect(&runner, &SimulationRunner::failed, this, [raise](const QString& reason) {
    raise({base::error("run.failed", {reason.toStdString()})});
  });
  const auto list = [this](const base::Diagnostics& remarks) {
    Q_EMIT docks_->context().problemsFound(remarks);
  };
  connect(&runner, &SimulationRunner::warned, this, list);
  connect(&runner, &SimulationRunner::broke, this, &MainWindow::showBreak);
  connect(&runner, &SimulationRunner::historyCut, this, list);
}

/// The person whose tree stopped the run, with the node.
void MainWindow::showBreak(const sim2d::TreeBreak& at) {
  editor::ScenarioDocument& document = workspace_.document();
  for (const sim2d::Human& human : document.scenario().humans) {
    if (human.id == at.person) {
      document.setSelection({human.key});
    }
  }
  QDockWidget* behaviour = docks_->dock(QStringLiteral("behaviour"));
  behaviour->show();
  behaviour->raise();
  editor::TreeOutline& outline = docks_->panel<editor::BehaviorPanel>().outline();
  outline.selectNode(outline.nodeNamed(at.at.path));
}

void MainWindow::followState() {
  const bool isRecorded = workspace_.isOfRecord();
  for (QAction* action : {actions_->save, actions_->saveAs, actions_->exportTo}) {
    action->setEnabled(!isOnStartPage() && !isRecorded);
  }
  actions_->openMap->setEnabled(!isOnStartPage() &&
                                workspace_.runner().state() == SimulationRunner::State::Editing);
  for (QAction* action :
       {actions_->close, workspace_.playback().playPause, workspace_.playback().step}) {
    action->setEnabled(!isOnStartPage());
  }
  showTitle();
}

void MainWindow::showBeside(QWidget* view, int columns) {
  if (view != nullptr) {
    canvas_->addWidget(view);
    const int column = canvas_->width() / (columns + 1);
    canvas_->setSizes({column, columns * column});
    view->show();
  }
  editor::later(*canvas_, [this] { workspace_.view().fitAll(false); });  // once it has its size
}

void MainWindow::showStart(bool start) {
  centre_->setCurrentWidget(start ? static_cast<QWidget*>(startPage_) : canvas_);
  docks_->setShown(!start);
  toolBar_->setVisible(!start);
  status_->setIdle(start);
  followState();
  if (!start) {
    workspace_.view().setFocus();
    if (!std::exchange(placed_, true) &&  // when the docks are first seen: as they were last time
        !restoreState(memory_.value(kWindowStateKey).toByteArray(), kLayoutVersion)) {
      docks_->placeFirst();
    }
  }
}

void MainWindow::showTitle() {
  const editor::ScenarioDocument& document = workspace_.document();
  if (isOnStartPage()) {
    setWindowTitle(tr("HuNavSim Desktop"));
    setWindowModified(false);
    saved_->clear();
    return;
  }
  if (workspace_.isOfRecord()) {
    setWindowTitle(tr("%1 (recorded run) – HuNavSim Desktop").arg(workspace_.recordedName()));
    setWindowModified(false);
    saved_->setText(tr("Recorded run"));
    return;
  }
  setWindowTitle(document.displayName() + QStringLiteral("[*] – HuNavSim Desktop"));
  const bool isOnlyHere = document.isDirty() || files_->isLost();
  setWindowModified(isOnlyHere);
  setWindowFilePath(document.path());
  saved_->setText(isOnlyHere              ? tr("Not saved")
                  : document.isReadOnly() ? tr("Read only")
                                          : tr("Saved"));
}

void MainWindow::setTheme(const editor::Theme& theme) {
  editor::dressApplication(theme);
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
    docks_->setShown(!on);  // first: it remembers the tool bar as well
    toolBar_->setVisible(!on);
    statusBar()->setVisible(!on);
    addAction(actions_->fullScreen);  // its key works without the menu bar
  }
  on ? showFullScreen() : showNormal();
}

void MainWindow::tellAbout() {
  QMessageBox::about(this, tr("About HuNavSim Desktop"),
                     tr("<b>HuNavSim Desktop %1</b><br>Scenarios for human-aware navigation: draw, "
                        "simulate, measure.")
                         .arg(QApplication::applicationVersion()));
}

void MainWindow::showShortcuts() {
  if (keysDialog_ == nullptr) {
    keysDialog_ = new ShortcutsDialog(*menuBar(), this);
    editor::deleteWhenClosed(*keysDialog_);
  }
  keysDialog_->show();  // beside the window, to try the keys out
  keysDialog_->raise();
  keysDialog_->activateWindow();
}

/// A name without a folder is one beside the scenario.
void MainWindow::showFile(const QString& file, int line) {
  if (viewer_ == nullptr) {
    viewer_ = new editor::TextViewer(workspace_.theme(), this);
  }
  const QFileInfo scenario(workspace_.document().path());
  const bool there = QFileInfo::exists(file) || scenario.path().isEmpty();
  const QString problem =
      viewer_->showFile(there ? file : scenario.absoluteDir().filePath(file), line);
  if (!problem.isEmpty()) {
    statusBar()->showMessage(problem, kMessageMs);
  }
}

void MainWindow::remember() {
  docks_->treeLarge()->setChecked(false);  // the next start begins with the map
  memory_.setValue(kGeometryKey, saveGeometry());
  if (!isOnStartPage()) {
    memory_.setValue(kWindowStateKey, saveState(kLayoutVersion));
  }
}

/// What is chosen in the window; not a theme given to one start of the program.
void MainWindow::rememberTheme() {
  memory_.setValue(kThemeKey, followsSystem_                ? QStringLiteral("system")
                              : workspace_.theme().isDark() ? QStringLiteral("dark")
                                                            : QStringLiteral("light"));
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!files_->mayLeave()) {
    event->ignore();
    return;
  }
  remember();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls.front().isLocalFile()) {
    event->acceptProposedAction();
  }
}

/// A file is opened, or given to the person it falls on.
void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  const editor::MapView& view = workspace_.view();
  editor::EntityId under;
  if (view.isVisible() && view.rect().contains(view.mapFrom(this, event->pos()))) {
    const QPoint at = view.viewport()->mapFrom(this, event->pos());
    under = workspace_.scene().entityAt(view.worldAt(at));
  }
  // later: the program that drags waits until this is through, and there may be questions
  const QString path = event->mimeData()->urls().front().toLocalFile();
  editor::later(*files_, [this, path, under] { files_->dropFile(path, under); });
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  event->ignore();
  keys_->takeLeft(*event);
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::ThemeChange && followsSystem_) {
    setTheme(editor::Theme::fromSystem(QApplication::style()->standardPalette()));
  }
}

}  // namespace app

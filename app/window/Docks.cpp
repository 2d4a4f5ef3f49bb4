#include "app/window/Docks.h"

#include <iterator>

#include "app/window/settings/Language.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/Form.h"
#include "editor/look/Icons.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/runs/Playback.h"
#include "editor/panels/runs/RunPlots.h"
#include "sim2d/base/Find.h"

namespace app {

namespace {

constexpr int kMostShown = 999;  // count in a button; titles have all digits

constexpr int kSideWidth = 320;    // [px]; at 1280 x 800 the map gets 3/5 of the window
constexpr int kScenarioShare = 2;  // share of the column's height
constexpr int kPropertiesShare = 3;
constexpr int kTitleHeight = 32;

/// The title bar of a dock. It is hidden if the dock is one of several tabs.
class DockTitle : public QWidget {
 public:
  explicit DockTitle(QDockWidget& dock) : QWidget(&dock), dock_(dock) {
    connect(&dock_, &QDockWidget::topLevelChanged, this, &DockTitle::updateTitle);
    connect(&dock_, &QDockWidget::dockLocationChanged, this, &DockTitle::updateTitle);
    connect(&dock_, &QDockWidget::visibilityChanged, this, &DockTitle::updateTitle);
  }
  QSize sizeHint() const override { return {80, isNeeded() ? kTitleHeight : 0}; }
  QSize minimumSizeHint() const override { return sizeHint(); }

  /// Call after neighbouring docks were opened or closed.
  void updateTitle() {
    updateGeometry();
    update();
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    if (!isNeeded()) {
      return;
    }
    QPainter painter(this);
    QFont bold = font();
    bold.setPointSizeF(9.5);
    bold.setWeight(QFont::DemiBold);
    painter.setFont(bold);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(12, 0, -12, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     dock_.windowTitle());
  }

 private:
  bool isNeeded() const {
    const auto* window = qobject_cast<QMainWindow*>(dock_.parentWidget());
    if (dock_.isFloating() || window == nullptr) {
      return true;
    }
    // Closed docks stay in the tab group but have no tab.
    const QList<QDockWidget*> others = window->tabifiedDockWidgets(&dock_);
    return std::all_of(others.begin(), others.end(),
                       [](const QDockWidget* other) { return other->isHidden(); });
  }

  QDockWidget& dock_;
};

}  // namespace

Docks::Docks(QMainWindow& window, Workspace& workspace, const editor::PanelRegistry& panels)
    : QObject(&window),
      window_(window),
      workspace_(workspace),
      context_(workspace.view(), workspace.document(), workspace.runner(), workspace.events(),
               workspace.feed()) {
  context_.drive = workspace_.drive().toggle();
  context_.branch = workspace_.playback().branchHere;
  window_.setDockOptions(QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks);
  window_.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  window_.setDocumentMode(true);
  mapOnly_ = editor::makeAction(tr("&Map only"), Qt::Key_F9,
                                tr("Close all panels; select again to restore them"), this);
  mapOnly_->setCheckable(true);
  connect(mapOnly_, &QAction::toggled, this, &Docks::showMapOnly);
  treeLarge_ = editor::makeAction(
      tr("Tree instead of the map"), Qt::Key_F8,
      tr("Show the behaviour tree instead of the map; select again to show the map"), this);
  treeLarge_->setCheckable(true);
  connect(treeLarge_, &QAction::toggled, this, &Docks::showTreeLarge);
  window_.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window_.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  connect(&context_, &editor::PanelContext::counted, this, &Docks::showCount);
  for (const editor::PanelRegistry::Entry& entry : panels.entries()) {
    add(entry);
  }
  for (const auto* plot : window_.findChildren<editor::MetricPlot*>()) {
    connect(plot, &editor::MetricPlot::menuRequested, &workspace_.branching(),
            &editor::BranchCommand::offerIn);
  }
  addTimeline();
  resetLayout();
}

void Docks::addTimeline() {
  auto* timeline = new editor::TimelineBar(workspace_.document(), workspace_.events(),
                                           workspace_.runner(), workspace_.theme());
  connect(&context_, &editor::PanelContext::themeChanged, timeline, &editor::TimelineBar::setTheme);
  connect(&context_, &editor::PanelContext::comparedChanged, timeline,
          &editor::TimelineBar::setCompared);
  connect(timeline, &editor::TimelineBar::timeAfterEndChosen, &context_,
          &editor::PanelContext::timeAfterEndChosen);
  timeline->setMenuActions({workspace_.playback().branchHere});
  timelineBar_ = new QToolBar(tr("Timeline"), &window_);
  timelineBar_->setObjectName(QStringLiteral("timeline"));
  timelineBar_->setMovable(false);
  timelineBar_->toggleViewAction()->setEnabled(false);  // always visible
  editor::describe(*timelineBar_->toggleViewAction(), tr("Always visible"));
  timelineBar_->addWidget(timeline);
  scrubButtons_ = timelineBar_->addWidget(makeScrubButtons());
  window_.addToolBar(Qt::BottomToolBarArea, timelineBar_);
  timelineBar_->installEventFilter(this);
}

/// The buttons of the timeline, with its background colour.
QWidget* Docks::makeScrubButtons() {
  auto* buttons = new QWidget(timelineBar_);
  buttons->setAutoFillBackground(true);
  buttons->setBackgroundRole(QPalette::Light);
  auto* row = new QHBoxLayout(buttons);
  row->setContentsMargins(4, 0, 4, 0);
  row->setSpacing(2);
  for (QAction* action : workspace_.scrub().all()) {
    auto* button = new QToolButton(buttons);
    button->setDefaultAction(action);
    button->setIconSize(QSize(20, 20));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);  // as in tool bars
    row->addWidget(button);
  }
  return buttons;
}

/// Hides the buttons in a narrow window; shortcuts and menus remain.
bool Docks::eventFilter(QObject* watched, QEvent* event) {
  constexpr int kRoomForButtons = 1100;  // px
  if (watched == timelineBar_ && event->type() == QEvent::Resize) {
    scrubButtons_->setVisible(timelineBar_->width() >= kRoomForButtons);
  }
  return QObject::eventFilter(watched, event);
}

void Docks::add(const editor::PanelRegistry::Entry& entry) {
  const auto& [order, title, area, isTab, initialHeight, isOpen, isCounted] = entry.info;
  auto* dock = new QDockWidget(title, &window_);
  dock->setObjectName(sourceText(title).toLower());
  dock->setTitleBarWidget(new DockTitle(*dock));
  connect(dock->toggleViewAction(), &QAction::toggled, this, [this] {
    for (const QDockWidget* each : docks_) {
      static_cast<DockTitle*>(each->titleBarWidget())->updateTitle();
    }
  });
  dock->setWidget(entry.make(context_));
  dock->setAutoFillBackground(true);
  dock->setBackgroundRole(QPalette::Light);
  QDockWidget* neighbour = nullptr;
  for (QDockWidget* other : docks_) {
    if (isTab && window_.dockWidgetArea(other) == area) {
      neighbour = other;
    }
  }
  window_.addDockWidget(area, dock);
  if (neighbour != nullptr) {
    window_.tabifyDockWidget(neighbour, dock);
  }
  docks_.push_back(dock);
  if (isOpen) {
    open_.push_back(dock);
  }
  addToggle(*dock);
  toggleOf(*dock)->setProperty(kCountedProperty, isCounted);
  toggleOf(*dock)->setProperty(kMarkedProperty,
                               qobject_cast<editor::IssuesPanel*>(dock->widget()) != nullptr);
  if (initialHeight > 0) {
    ensureHeight(*dock, initialHeight);
  }
}

/// Sets the height of the dock when it is first shown, or first after the layout was reset, if it
/// is alone in its area or too low.
void Docks::ensureHeight(QDockWidget& dock, int initialHeight) {
  connect(&dock, &QDockWidget::visibilityChanged, this, [this, &dock, initialHeight](bool on) {
    if (!on || !hadRoom_.insert(&dock).second) {
      return;
    }
    const QList<QDockWidget*> others = window_.tabifiedDockWidgets(&dock);
    const bool isAlone = std::all_of(others.begin(), others.end(),
                                     [](const QDockWidget* other) { return other->isHidden(); });
    if (isAlone) {
      window_.resizeDocks({&dock}, {initialHeight}, Qt::Vertical);
    }
    editor::later(dock, [this, &dock, initialHeight] {  // when Qt has given it its place
      if (!dock.visibleRegion().isEmpty() && dock.height() < initialHeight) {
        window_.resizeDocks({&dock}, {initialHeight}, Qt::Vertical);
      }
    });
  });
}

void Docks::addToggle(QDockWidget& dock) {
  const int number = static_cast<int>(docks_.size());
  const QKeySequence key(number > 10 ? QStringLiteral("Alt+Shift+%1").arg(number % 10)
                                     : QStringLiteral("Alt+%1").arg(number % 10));
  QAction* toggle =
      editor::makeAction(dock.windowTitle(), key, tr("Open or close this panel"), this);
  toggle->setCheckable(true);
  toggle->setIconVisibleInMenu(false);  // there it has a check mark
  connect(toggle, &QAction::triggered, &dock, [this, &dock](bool on) {
    dock.setVisible(on);
    if (on) {
      behind_[&dock] = frontBeside(dock);  // Qt knows the tab group of visible docks only
      dock.raise();
    } else if (const QPointer<QDockWidget> before = behind_[&dock]; before != nullptr) {
      editor::later(*before, [before] {  // after Qt has removed the tab
        if (!before->isHidden()) {
          before->raise();
        }
      });
    }
  });
  connect(&dock, &QDockWidget::visibilityChanged, toggle, &QAction::setChecked);
  toggles_[&dock] = toggle;
}

/// The front tab beside the dock; null: none.
QDockWidget* Docks::frontBeside(QDockWidget& dock) const {
  const QList<QDockWidget*> others = window_.tabifiedDockWidgets(&dock);
  const auto front = std::find_if(others.begin(), others.end(), [](const QDockWidget* each) {
    return each->isVisible() && !each->visibleRegion().isEmpty();
  });
  return front == others.end() ? nullptr : *front;
}

QList<QAction*> Docks::toggles() const {
  QList<QAction*> all;
  for (const QDockWidget* each : docks_) {
    all.push_back(toggleOf(*each));
  }
  return all;
}

QList<QAction*> Docks::bottomToggles() const {
  QList<QAction*> below;
  for (QDockWidget* each : docks_) {
    if (window_.dockWidgetArea(each) == Qt::BottomDockWidgetArea) {
      below.push_back(toggleOf(*each));
    }
  }
  return below;
}

/// Closes all other docks until `restoreDocks`.
void Docks::showOnly(const std::vector<const QDockWidget*>& kept) {
  openBeforeMaximized_.clear();
  sizesBefore_ = window_.saveState();
  std::copy_if(docks_.begin(), docks_.end(), std::back_inserter(openBeforeMaximized_),
               [](const QDockWidget* each) { return !each->isHidden(); });
  for (QDockWidget* each : docks_) {
    each->setVisible(std::find(kept.begin(), kept.end(), each) != kept.end());
  }
}

void Docks::restoreDocks() {
  for (QDockWidget* each : docks_) {
    each->setVisible(std::find(openBeforeMaximized_.begin(), openBeforeMaximized_.end(), each) !=
                     openBeforeMaximized_.end());
  }
  window_.restoreState(std::exchange(sizesBefore_, {}));
}

void Docks::showMapOnly(bool on) {
  if (on) {
    treeLarge_->setChecked(false);
  }
  on ? showOnly({}) : restoreDocks();
}

void Docks::showTreeLarge(bool on) {
  QDockWidget* const tree = dock(QStringLiteral("tree"));
  QDockWidget* const behaviour = dock(QStringLiteral("behaviour"));
  if (tree == nullptr || behaviour == nullptr || centre_ == nullptr) {
    return;
  }
  if (!on) {
    behaviour->setMaximumWidth(QWIDGETSIZE_MAX);
    centre_->show();
    restoreDocks();
    return;
  }
  mapOnly_->setChecked(false);
  tree->setFloating(false);
  showOnly({tree, behaviour});
  centre_->hide();
  tree->raise();
  behaviour->raise();
  behaviour->setMaximumWidth(kSideWidth);  // the tree gets the space of the map
  tree->widget()->setFocus();
}

QDockWidget* Docks::dock(const QString& name) const {
  QDockWidget* const* found = base::findBy(docks_, &QObject::objectName, name.toLower());
  return found == nullptr ? nullptr : *found;
}

QStringList Docks::names() const {
  QStringList result;
  for (const QDockWidget* dock : docks_) {
    result.push_back(dock->objectName());
  }
  return result;
}

void Docks::show(const QStringList& names) {
  treeLarge_->setChecked(false);
  for (QDockWidget* dock : docks_) {
    dock->setVisible(names.contains(dock->objectName()));
  }
  for (const QString& name : names) {
    dock(name)->raise();
  }
}

void Docks::resetLayout() {
  hadRoom_.clear();
  mapOnly_->setChecked(false);
  treeLarge_->setChecked(false);
  for (QDockWidget* dock : docks_) {
    dock->setFloating(false);
    dock->setVisible(std::find(open_.begin(), open_.end(), dock) != open_.end());
  }
  setInitialSizes();
}

void Docks::setInitialSizes() {
  QDockWidget* const scenario = dock(QStringLiteral("scenario"));
  QDockWidget* const properties = dock(QStringLiteral("properties"));
  window_.resizeDocks({properties}, {kSideWidth}, Qt::Horizontal);
  window_.resizeDocks({scenario, properties}, {100 * kScenarioShare, 100 * kPropertiesShare},
                      Qt::Vertical);
  properties->raise();
}

void Docks::showCount(const QWidget* panel, int count, base::Severity worst) {
  QDockWidget* const* found = base::findBy(docks_, &QDockWidget::widget, panel);
  if (found == nullptr) {
    return;
  }
  QAction& toggle = *toggleOf(**found);
  const QString title = toggle.text();
  (*found)->setWindowTitle(count > 0 ? QStringLiteral("%1  %2").arg(title).arg(count) : title);
  toggle.setIconText(count > kMostShown ? QStringLiteral("%1  %2+").arg(title).arg(kMostShown)
                                        : (*found)->windowTitle());
  const editor::Theme& theme = workspace_.theme();
  const bool isError = worst == base::Severity::Error;
  toggle.setIcon(count == 0 || worst == base::Severity::Info
                     ? QIcon()
                     : editor::tintedIcon(
                           isError ? QStringLiteral("error") : QStringLiteral("warning"),
                           theme.color(isError ? editor::Role::Error : editor::Role::WarningMark)));
}

void Docks::setShown(bool shown) {
  if (!shown) {
    treeLarge_->setChecked(false);
  }
  if (!shown && shownBefore_.empty() && window_.isVisible()) {
    layoutBefore_ = window_.saveState();
  }
  for (QDockWidget* dock : docks_) {
    if (!shown) {
      shownBefore_.emplace(dock, !dock->isHidden());
      dock->hide();
    } else if (const auto was = shownBefore_.find(dock); was != shownBefore_.end()) {
      dock->setVisible(was->second);
    }
  }
  timelineBar_->setVisible(shown);
  const QString closed = tr("Open a scenario first");
  editor::setEnabled(*mapOnly_, shown, closed);
  editor::setEnabled(*treeLarge_, shown, closed);
  for (const auto& [dock, toggle] : toggles_) {
    editor::setEnabled(*toggle, shown, closed);
  }
  if (shown) {
    shownBefore_.clear();
    window_.restoreState(std::exchange(layoutBefore_, {}));  // restores sizes; empty: ignored
  }
}

}  // namespace app

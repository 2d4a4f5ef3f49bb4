#include "app/window/Docks.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <QPainter>

#include "editor/look/Form.h"
#include "editor/panels/Playback.h"

namespace app {

namespace {

constexpr int kLeftWidth = 260;
constexpr int kRightWidth = 320;
constexpr int kScenarioShare = 3;  // of the height at the left
constexpr int kMeasureShare = 2;
constexpr int kBottomEditing = 152;
constexpr int kBottomRunning = 232;
constexpr int kTitleHeight = 32;

/// The heading of a dock; gives way to the tab when the dock is one of several.
class DockTitle : public QWidget {
 public:
  explicit DockTitle(QDockWidget& dock) : QWidget(&dock), dock_(dock) {
    connect(&dock_, &QDockWidget::topLevelChanged, this, &DockTitle::follow);
    connect(&dock_, &QDockWidget::dockLocationChanged, this, &DockTitle::follow);
    connect(&dock_, &QDockWidget::visibilityChanged, this, &DockTitle::follow);
  }
  QSize sizeHint() const override { return {80, isNeeded() ? kTitleHeight : 0}; }
  QSize minimumSizeHint() const override { return sizeHint(); }

  /// After docks beside it came or went.
  void follow() {
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
    // Docks that are closed keep their place among the tabs but have none.
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
  window_.setDockOptions(QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks);
  window_.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  window_.setDocumentMode(true);
  window_.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window_.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  connect(&context_, &editor::PanelContext::counted, this, &Docks::showCount);
  for (const editor::PanelRegistry::Entry& entry : panels.entries()) {
    add(entry);
  }
  addTimeline();
  connect(&workspace_.runner(), &editor::SimulationRunner::stateChanged, this, &Docks::grow);
  resetLayout();
}

void Docks::addTimeline() {
  auto* timeline = new editor::TimelineBar(workspace_.document(), workspace_.events(),
                                           workspace_.runner(), workspace_.theme());
  connect(&context_, &editor::PanelContext::themeChanged, timeline, &editor::TimelineBar::setTheme);
  timelineBar_ = new QToolBar(tr("Timeline"), &window_);
  timelineBar_->setObjectName(QStringLiteral("timeline"));
  timelineBar_->setMovable(false);
  timelineBar_->toggleViewAction()->setEnabled(false);  // always seen
  editor::describe(*timelineBar_->toggleViewAction(), tr("Always seen"));
  timelineBar_->addWidget(timeline);
  window_.addToolBar(Qt::BottomToolBarArea, timelineBar_);
}

void Docks::add(const editor::PanelRegistry::Entry& entry) {
  const auto& [order, title, area, isTab, room] = entry.info;
  auto* dock = new QDockWidget(title, &window_);
  dock->setObjectName(title.toLower());
  editor::describe(*dock->toggleViewAction(), tr("Show or hide this panel"));
  dock->setTitleBarWidget(new DockTitle(*dock));
  connect(dock->toggleViewAction(), &QAction::toggled, this, [this] {
    for (const QDockWidget* each : docks_) {
      static_cast<DockTitle*>(each->titleBarWidget())->follow();
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
  if (room > 0) {
    const auto hadRoom = std::make_shared<bool>(false);
    connect(dock, &QDockWidget::visibilityChanged, this,
            [this, dock, room = room, hadRoom](bool on) {
              if (on && !std::exchange(*hadRoom, true) && dock->height() < room) {
                window_.resizeDocks({dock}, {room}, Qt::Vertical);
              }
            });
  }
}

QDockWidget* Docks::dock(const QString& name) const {
  const auto found = std::find_if(docks_.begin(), docks_.end(), [&](const QDockWidget* dock) {
    return dock->objectName() == name.toLower();
  });
  return found == docks_.end() ? nullptr : *found;
}

QStringList Docks::names() const {
  QStringList result;
  for (const QDockWidget* dock : docks_) {
    result.push_back(dock->objectName());
  }
  return result;
}

void Docks::show(const QStringList& names) {
  for (QDockWidget* dock : docks_) {
    dock->setVisible(names.contains(dock->objectName()));
  }
  for (const QString& name : names) {
    dock(name)->raise();
  }
}

void Docks::resetLayout() {
  for (QDockWidget* dock : docks_) {
    dock->setFloating(false);
    dock->show();
  }
  placeFirst();
}

void Docks::placeFirst() {
  QDockWidget* const scenario = dock(QStringLiteral("scenario"));
  QDockWidget* const properties = dock(QStringLiteral("properties"));
  QDockWidget* const issues = dock(QStringLiteral("issues"));
  window_.resizeDocks({scenario, properties}, {kLeftWidth, kRightWidth}, Qt::Horizontal);
  window_.resizeDocks({issues}, {grown_ ? kBottomRunning : kBottomEditing}, Qt::Vertical);
  window_.resizeDocks({scenario, dock(QStringLiteral("measure"))},
                      {100 * kScenarioShare, 100 * kMeasureShare}, Qt::Vertical);
  properties->raise();
  (grown_ ? dock(QStringLiteral("metrics")) : issues)->raise();
}

void Docks::grow(editor::SimulationRunner::State state) {
  if (!grown_ && state != editor::SimulationRunner::State::Editing) {
    grown_ = true;
    QDockWidget* metrics = dock(QStringLiteral("metrics"));
    metrics->raise();
    window_.resizeDocks({metrics}, {kBottomRunning}, Qt::Vertical);
  }
}

void Docks::showCount(const QWidget* panel, int count) {
  for (QDockWidget* dock : docks_) {
    if (dock->widget() == panel) {
      const QString title = dock->toggleViewAction()->text();
      dock->setWindowTitle(count > 0 ? QStringLiteral("%1  %2").arg(title).arg(count) : title);
      dock->toggleViewAction()->setText(title);
    }
  }
}

void Docks::setShown(bool shown) {
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
  if (shown) {
    shownBefore_.clear();
    window_.restoreState(std::exchange(layoutBefore_, {}));  // their sizes; refuses an empty one
  }
}

}  // namespace app

#include "app/window/Docks.h"

#include <utility>

#include <QTabBar>
#include <QToolBar>

#include "app/window/DockTitle.h"
#include "editor/look/ActionText.h"
#include "editor/panels/BehaviorPanel.h"
#include "editor/panels/EventsPanel.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/MetricsChoicePanel.h"
#include "editor/panels/MetricsDock.h"
#include "editor/panels/PropertyPanel.h"
#include "editor/panels/ScenarioPanel.h"
#include "editor/panels/TimelineBar.h"

namespace app {

namespace {

constexpr int kLeftWidth = 260;
constexpr int kRightWidth = 320;
constexpr int kScenarioShare = 3;  // of the height at the left
constexpr int kMeasureShare = 2;
constexpr int kBottomEditing = 152;
constexpr int kBottomRunning = 232;

}  // namespace

Docks::Docks(QMainWindow& window, Workspace& workspace)
    : QObject(&window),
      window_(window),
      workspace_(workspace),
      scenario_(new editor::ScenarioPanel(workspace.document(), workspace.theme())),
      choice_(new editor::MetricsChoicePanel(workspace.document(), workspace.feed(),
                                             workspace.theme())),
      properties_(new editor::PropertyPanel(workspace.document(), workspace.theme())),
      behavior_(
          new editor::BehaviorPanel(workspace.document(), workspace.runner(), workspace.theme())),
      issues_(new editor::IssuesPanel(workspace.document(), workspace.theme())),
      metrics_(new editor::MetricsDock(workspace.feed(), workspace.runner(), workspace.theme())),
      events_(new editor::EventsPanel(workspace.events(), workspace.runner(), workspace.theme())),
      timeline_(new editor::TimelineBar(workspace.document(), workspace.events(),
                                        workspace.runner(), workspace.theme())) {
  window_.setDockOptions(QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks);
  window_.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  window_.setDocumentMode(true);
  window_.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window_.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  add(Qt::LeftDockWidgetArea, tr("Scenario"), scenario_, false);
  add(Qt::LeftDockWidgetArea, tr("Measure"), choice_, false);
  add(Qt::RightDockWidgetArea, tr("Properties"), properties_, true);
  add(Qt::RightDockWidgetArea, tr("Behaviour"), behavior_, true);
  add(Qt::BottomDockWidgetArea, tr("Issues"), issues_, true);
  add(Qt::BottomDockWidgetArea, tr("Metrics"), metrics_, true);
  add(Qt::BottomDockWidgetArea, tr("Events"), events_, true);
  timelineBar_ = new QToolBar(tr("Timeline"), &window_);
  timelineBar_->setObjectName(QStringLiteral("timeline"));
  timelineBar_->setMovable(false);
  timelineBar_->toggleViewAction()->setEnabled(false);  // always seen
  editor::describe(*timelineBar_->toggleViewAction(), tr("Always seen"));
  timelineBar_->addWidget(timeline_);
  window_.addToolBar(Qt::BottomToolBarArea, timelineBar_);
  connect(issues_, &editor::IssuesPanel::countChanged, this,
          [this](int count) { showCount(dock(QStringLiteral("issues")), tr("Issues"), count); });
  connect(events_, &editor::EventsPanel::countChanged, this,
          [this](int count) { showCount(dock(QStringLiteral("events")), tr("Events"), count); });
  connect(&workspace_.runner(), &editor::SimulationRunner::frameShown, properties_,
          &editor::PropertyPanel::showFrame);
  connect(&workspace_.runner(), &editor::SimulationRunner::frameShown, behavior_,
          &editor::BehaviorPanel::showFrame);
  connect(behavior_, &editor::BehaviorPanel::told, issues_, &editor::IssuesPanel::setActionIssues);
  connect(choice_, &editor::MetricsChoicePanel::saved, issues_,
          &editor::IssuesPanel::setActionIssues);
  connect(&workspace_.runner(), &editor::SimulationRunner::stateChanged, this,
          [this](editor::SimulationRunner::State state) {
            if (state != editor::SimulationRunner::State::Editing) {
              grow();
            }
          });
  resetLayout();
}

QDockWidget* Docks::add(Qt::DockWidgetArea area, const QString& title, QWidget* panel,
                        bool tabbed) {
  auto* dock = new QDockWidget(title, &window_);
  dock->setObjectName(title.toLower());
  editor::describe(*dock->toggleViewAction(), tr("Show or hide this panel"));
  auto* heading = new DockTitle(*dock);
  dock->setTitleBarWidget(heading);
  headings_.push_back(heading);
  connect(dock->toggleViewAction(), &QAction::toggled, this, [this] {
    for (DockTitle* each : headings_) {
      each->follow();
    }
  });
  dock->setWidget(panel);
  dock->setAutoFillBackground(true);
  dock->setBackgroundRole(QPalette::Light);
  QDockWidget* neighbour = nullptr;
  for (QDockWidget* other : docks_) {
    if (tabbed && window_.dockWidgetArea(other) == area) {
      neighbour = other;
    }
  }
  window_.addDockWidget(area, dock);
  if (neighbour != nullptr) {
    window_.tabifyDockWidget(neighbour, dock);
  }
  docks_.push_back(dock);
  return dock;
}

QDockWidget* Docks::dock(const QString& name) const {
  for (QDockWidget* dock : docks_) {
    if (dock->objectName() == name.toLower()) {
      return dock;
    }
  }
  return nullptr;
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
  window_.resizeDocks({dock(QStringLiteral("scenario")), dock(QStringLiteral("properties"))},
                      {kLeftWidth, kRightWidth}, Qt::Horizontal);
  window_.resizeDocks({dock(QStringLiteral("issues"))}, {grown_ ? kBottomRunning : kBottomEditing},
                      Qt::Vertical);
  window_.resizeDocks({dock(QStringLiteral("scenario")), dock(QStringLiteral("measure"))},
                      {100 * kScenarioShare, 100 * kMeasureShare}, Qt::Vertical);
  dock(QStringLiteral("properties"))->raise();
  dock(grown_ ? QStringLiteral("metrics") : QStringLiteral("issues"))->raise();
}

void Docks::grow() {
  if (!grown_) {
    grown_ = true;
    QDockWidget* metrics = dock(QStringLiteral("metrics"));
    metrics->raise();
    window_.resizeDocks({metrics}, {kBottomRunning}, Qt::Vertical);
  }
}

void Docks::showCount(QDockWidget* dock, const QString& title, int count) {
  dock->setWindowTitle(count > 0 ? QStringLiteral("%1  %2").arg(title).arg(count) : title);
  dock->toggleViewAction()->setText(title);
}

void Docks::setTheme(const editor::Theme& theme) {
  scenario_->setTheme(theme);
  choice_->setTheme(theme);
  properties_->setTheme(theme);
  behavior_->setTheme(theme);
  issues_->setTheme(theme);
  metrics_->setTheme(theme);
  events_->setTheme(theme);
  timeline_->setTheme(theme);
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

QWidget* Docks::timeline() const {
  return timeline_;
}

}  // namespace app

#include "editor/panels/MetricsDock.h"

#include <algorithm>
#include <cmath>

#include "editor/look/CoreText.h"
#include "editor/panels/MetricDelegates.h"
#include "editor/panels/PanelRegistry.h"

namespace editor {

namespace {

constexpr int kMinPlotWidth = 560;  // Minimum width of the dock for showing the plot [px].
constexpr int kMinSparklineWidth = 420;

bool hasCurve(const app::MetricTimeSeries& curve) {
  return std::any_of(curve.values.begin(), curve.values.end(),
                     [](double value) { return std::isfinite(value) && value != 0.0; });
}

}  // namespace

MetricsDock::MetricsDock(ScenarioDocument& document, MetricsFeed& feed, SimulationRunner& runner,
                         const Theme& theme)
    : document_(document),
      feed_(feed),
      runner_(runner),
      people_(feed, runner),
      table_(new MetricsTable(document, feed, people_, theme)),
      plot_(new MetricPlot(theme, true)) {
  makeChooser();
  beside_->addWidget(emptyState(tr("Metrics appear when a simulation runs: press Space."), this));
  beside_->addWidget(plot_);
  beside_->addWidget(noValue_);
  auto* both = new QSplitter(Qt::Horizontal, this);
  both->addWidget(table_);
  both->addWidget(beside_);
  both->setStretchFactor(0, 3);
  both->setStretchFactor(1, 2);
  both->setSizes({560, 300});
  both->setChildrenCollapsible(false);
  configuredLayout(new QVBoxLayout(this), {}, 0, {both});
  connect(&feed_, &MetricsFeed::updated, this, &MetricsDock::showSnapshot);
  connect(&feed_, &MetricsFeed::cleared, this, &MetricsDock::showSnapshot);
  connect(&document_, &ScenarioDocument::selectionChanged, this, &MetricsDock::showSelectedPeople);
  connect(table_, &MetricsTable::filtered, this, &MetricsDock::followFilter);
  connect(table_, &MetricsTable::chosen, this, [this](const std::string& key) {
    chosen_ = key;
    hasChosen_ = true;
    showPlot();
  });
  connect(&runner, &SimulationRunner::frameShown, this, [this](const FramePtr& frame) {
    if (frame) {
      plot_->setCursor(frame->time);
    }
  });
  showSelectedPeople();
  showSnapshot();
}

void MetricsDock::makeChooser() {
  robot_->setAccessibleName(tr("Metrics of"));
  robot_->setToolTip(tr("Robot whose metrics are shown"));
  robot_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  robot_->setFocusPolicy(Qt::TabFocus);
  robot_->hide();
  table_->top().insertWidget(1, robot_);  // Beside the search, so that nothing below moves.
  connect(robot_, qOverload<int>(&QComboBox::activated), this,
          [this](int index) { feed_.setRobot(robot_->itemData(index).toInt()); });
}

void MetricsDock::fillChooser() {
  const auto robots = feed_.robots();
  const int count = static_cast<int>(robots.size());
  bool isSame = robot_->count() == count;
  for (int k = 0; isSame && k < count; ++k) {
    const auto& [id, name] = robots[static_cast<std::size_t>(k)];
    isSame = robot_->itemData(k) == id && robot_->itemText(k) == QString::fromStdString(name);
  }
  if (!isSame) {
    robot_->clear();
    for (const auto& [id, name] : robots) {
      robot_->addItem(QString::fromStdString(name), id);
    }
  }
  robot_->setCurrentIndex(robot_->findData(feed_.robot()));
  robot_->setVisible(count > 1);
}

/// In a narrow dock the names get the space: the plot is hidden first, then the sparklines.
void MetricsDock::adaptToWidth() {
  beside_->setHidden(width() < kMinPlotWidth);
  table_->tree().setColumnHidden(MetricsTable::SparklineColumn, width() < kMinSparklineWidth);
}

void MetricsDock::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  adaptToWidth();
}

void MetricsDock::setTheme(const Theme& theme) {
  table_->setTheme(theme);
  plot_->setTheme(theme);
}

void MetricsDock::showSelectedPeople() {
  std::vector<MeasuredPerson> people;
  for (const EntityId id : document_.selection()) {
    const sim2d::Human* human = document_.human(id);
    if (human != nullptr && people.size() < kMostPeople) {
      people.push_back({human->id, QString::fromStdString(human->name)});
    }
  }
  table_->setPeople(std::move(people));
}

void MetricsDock::showSnapshot() {
  fillChooser();
  table_->showValues();
  if (table_->currentKey() != keyToShow()) {
    table_->setCurrentKey(keyToShow());
  }
  showPlot();
}

/// The plot shows a metric that the search leaves visible.
void MetricsDock::followFilter() {
  table_->setCurrentKey(keyToShow());
  showPlot();
}

/// The choice of the user. Before the user chooses, and while the search hides the choice, the
/// first row with a curve, which depends only on the measured metrics, not on timing.
std::string MetricsDock::keyToShow() const {
  const bool isSearching = !table_->search().text().isEmpty();
  const bool isHeading = chosen_.empty() && !isSearching;  // The row of a group.
  if (hasChosen_ && (isHeading || table_->isVisible(chosen_))) {
    return chosen_;
  }
  return isSearching ? table_->firstVisible() : firstWithCurve();
}

std::string MetricsDock::firstWithCurve() const {
  const MetricSnapshot& snapshot = feed_.snapshot();
  std::string first;
  for (const metrics::MetricResult& result : snapshot.results) {
    if (!table_->isVisible(result.info.key)) {
      continue;
    }
    const app::MetricTimeSeries* curve = curveOf(snapshot, result.info.key);
    if (curve != nullptr && hasCurve(*curve)) {
      return result.info.key;
    }
    first = first.empty() ? result.info.key : first;
  }
  return first;
}

void MetricsDock::showPlot() {
  shown_ = table_->currentKey().empty() ? shown_ : table_->currentKey();
  const metrics::MetricResult* result = metrics::findResult(feed_.snapshot().results, shown_);
  const metrics::MetricEntry* known = metrics::standardRegistry().find(shown_);
  const metrics::MetricInfo info = result != nullptr  ? result->info
                                   : known != nullptr ? known->info
                                                      : metrics::MetricInfo();
  plot_->show(coreText(info.name), QString::fromStdString(info.unit),
              {{curveOf(feed_.snapshot(), shown_)}});
  const QString why = result == nullptr ? QString() : reasonWithoutValue(*result);
  noValue_->setText(why);
  QWidget* const without = why.isEmpty() ? static_cast<QWidget*>(plot_) : noValue_;
  runner_.recording() == nullptr ? beside_->setCurrentIndex(0) : beside_->setCurrentWidget(without);
}

/// Why there is neither a value nor a curve; empty: there is one.
QString MetricsDock::reasonWithoutValue(const metrics::MetricResult& result) const {
  const app::MetricTimeSeries* curve = curveOf(feed_.snapshot(), result.info.key);
  const bool isDrawn = curve != nullptr && std::any_of(curve->values.begin(), curve->values.end(),
                                                       [](double y) { return std::isfinite(y); });
  if (isDrawn || result.value.value || result.value.why.empty()) {
    return {};
  }
  const QString name = coreText(result.info.name);
  return result.info.needs.robot && feed_.robots().empty()
             ? tr("%1 needs a robot: press B, then click its start and its goal.").arg(name)
             : tr("%1 has no value: %2").arg(name, QString::fromStdString(result.value.why));
}

void addMetricsDock(PanelRegistry& to) {
  to.add(closedBottomPanel(60, QObject::tr("Metrics")), [](PanelContext& context) {
    auto* panel = new MetricsDock(context.document, context.feed, context.runner, context.theme());
    QObject::connect(&context, &PanelContext::themeChanged, panel, &MetricsDock::setTheme);
    QObject::connect(&panel->table(), &MetricsTable::saved, &context, &PanelContext::problemsFound);
    connectExport(panel->plot(), context);
    return panel;
  });
}

}  // namespace editor

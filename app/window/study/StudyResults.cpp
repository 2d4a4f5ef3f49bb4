#include "app/window/study/StudyResults.h"

#include <algorithm>
#include <cmath>

#include "app/window/study/StudyTable.h"
#include "editor/look/Form.h"
#include "editor/look/TableExport.h"
#include "editor/panels/RowDelegate.h"
#include "metrics/MetricRegistry.h"

namespace app {

namespace {

constexpr int kCompareMs = 500;
constexpr int kFirstMetric = 2;  // column, after option and runs
enum Page { NothingPage, ComparisonPage, RunsPage };

/// The scale of a column: of a rate from 0 to 1, otherwise all its intervals.
std::pair<double, double> scaleOf(const StudyMetric& metric,
                                  const std::vector<report::Estimate>& estimates) {
  if (metric.isRate) {
    return {0.0, 1.0};
  }
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const report::Estimate& estimate : estimates) {
    for (const double end : {estimate.mean, estimate.interval.low, estimate.interval.high}) {
      low = std::isnan(end) ? low : std::min(low, end);
      high = std::isnan(end) ? high : std::max(high, end);
    }
  }
  return {low, high};
}

}  // namespace

StudyResults::StudyResults(QWidget* parent) : QWidget(parent) {
  tabs_->addTab(tr("Comparison"));
  tabs_->addTab(tr("Runs"));
  tabs_->setDrawBase(false);
  tabs_->setExpanding(false);
  auto* strip = new QWidget(this);  // always visible: the tables do not move when rows arrive
  strip->setAutoFillBackground(true);
  strip->setBackgroundRole(QPalette::Window);
  editor::configuredLayout(new QHBoxLayout(strip), {}, 0, {tabs_})->addStretch();
  pages_->addWidget(
      editor::emptyState(tr("Choose scenarios and planners on the left, then press Start.\nFor "
                            "each seed, all planners run with the same people."),
                         this));
  pages_->addWidget(makeComparison());
  makeRuns();
  editor::configuredLayout(new QVBoxLayout(this), {}, 0, {strip})->addWidget(pages_, 1);
  compareSoon_.setSingleShot(true);
  compareSoon_.setInterval(kCompareMs);
  connect(&compareSoon_, &QTimer::timeout, this, &StudyResults::compare);
  connect(tabs_, &QTabBar::currentChanged, this, &StudyResults::showPage);
  showPage();
}

QWidget* StudyResults::makeComparison() {
  styleStudyTable(*comparison_, tr("Comparison"));
  comparison_->setSelectionMode(QAbstractItemView::NoSelection);
  auto* page = new QWidget(this);
  auto* meaning = editor::secondaryLabel(
      tr("Mean of the finished runs [95 % confidence interval]. Bars: the same intervals, on one "
         "scale per column. Rates: Wilson; other metrics: bootstrap (BCa). n: runs that have a "
         "value, if not all have one. Success: the robot reached its goal in time, without contact "
         "with "
         "people or obstacles."),
      page);
  meaning->setObjectName(QStringLiteral("study_brackets"));
  meaning->setWordWrap(true);
  meaning->setContentsMargins(12, 4, 12, 6);
  auto* rows = editor::configuredLayout(new QVBoxLayout(page), {}, 0);
  rows->addWidget(comparison_, 1);
  rows->addWidget(meaning);
  return page;
}

void StudyResults::makeRuns() {
  sorted_.setSourceModel(&runs_);
  sorted_.setSortRole(Qt::UserRole);
  runTable_->setModel(&sorted_);
  editor::styleTable(*runTable_, tr("Runs"));
  editor::makeTableSavable(*runTable_, tr("Runs of the study"));
  styleStudyHead(*runTable_->horizontalHeader());
  runTable_->setTextElideMode(Qt::ElideMiddle);
  runTable_->setWordWrap(false);
  runTable_->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  runTable_->setSortingEnabled(true);
  runTable_->sortByColumn(0, Qt::AscendingOrder);
  runTable_->setToolTip(tr("Double-click a run to play it"));
  pages_->addWidget(runTable_);
  connect(runTable_, &QTableView::activated, this, [this](const QModelIndex& at) {
    const auto row = static_cast<std::size_t>(sorted_.mapToSource(at).row());
    if (row < runs_.rows().size()) {  // false for an invalid index
      Q_EMIT playRequested(runs_.rows()[row].run);
    }
  });
}

void StudyResults::showPage() {
  const bool hasRows = !runs_.rows().empty();
  const Page chosen = tabs_->currentIndex() == 0 ? ComparisonPage : RunsPage;
  pages_->setCurrentIndex(hasRows ? chosen : NothingPage);
}

void StudyResults::begin(const QStringList& paths, const QString& compared) {
  compared_ = compared;
  runs_.begin(paths);
  resetColumns(*runTable_);
  fillHead();
  showPage();
}

void StudyResults::add(const std::vector<StudyRow>& rows) {
  const bool wasEmpty = runs_.rows().empty();
  for (const StudyRow& row : rows) {
    runs_.add(row);
  }
  if (wasEmpty) {
    compare();
    showPage();
  } else if (!compareSoon_.isActive()) {
    compareSoon_.start();
  }
}

/// The columns have space for usual values from the start: they do not move when rows arrive.
void StudyResults::fillHead() {
  QStringList titles = {compared_.isEmpty() ? tr("Scenario") : pathTitle(compared_), tr("Runs")};
  for (const StudyMetric& metric : studyMetrics()) {
    titles.append(metric.heading());
  }
  setStudyColumns(*comparison_, titles, {0});
  resetColumns(*comparison_);
  int column = kFirstMetric;
  for (const StudyMetric& metric : studyMetrics()) {
    const metrics::MetricEntry* entry = metrics::standardRegistry().find(metric.key.toStdString());
    comparison_->horizontalHeaderItem(column)->setToolTip(
        metric.heading() + QLatin1Char('\n') + QString::fromStdString(entry->info.formula));
    reserveColumn(*comparison_, column++,
                  QLatin1String(metric.isRate ? "100 % [100, 100]" : "88.88 [88.88, 88.88]"));
  }
  widenColumns(*comparison_);
}

void StudyResults::compare() {
  const auto options = runs_.byOption(compared_);
  comparison_->setRowCount(static_cast<int>(options.size()));
  int row = 0;
  for (const auto& [option, runs] : options) {
    comparison_->setItem(row, 0, studyCell(option, true));
    comparison_->setItem(row++, 1, studyCell(QString::number(runs.size()), false));
  }
  int column = kFirstMetric;
  for (const StudyMetric& metric : studyMetrics()) {
    fillColumn(column++, metric, options);
  }
  widenColumns(*comparison_);
  widenColumns(*runTable_);
}

void StudyResults::fillColumn(
    int column, const StudyMetric& metric,
    const std::vector<std::pair<QString, std::vector<const StudyRow*>>>& options) {
  std::vector<report::Estimate> estimates;
  estimates.reserve(options.size());
  for (const auto& option : options) {
    estimates.push_back(estimateOf(metric, option.second));
  }
  const auto [low, high] = scaleOf(metric, estimates);
  for (std::size_t row = 0; row < estimates.size(); ++row) {
    const report::Estimate& estimate = estimates[row];
    QString text = estimateText(metric, estimate);
    if (!estimate.values.empty() && estimate.values.size() < options[row].second.size()) {
      text += tr(" (n = %1)").arg(estimate.values.size());
    }
    comparison_->setItem(
        static_cast<int>(row), column,
        intervalCell(text.isEmpty() ? tr("–") : text, estimate.mean, estimate.interval, low, high));
  }
}

}  // namespace app

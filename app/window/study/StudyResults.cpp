#include "app/window/study/StudyResults.h"

#include <algorithm>

#include "editor/look/Form.h"
#include "editor/panels/RowDelegate.h"

namespace app {

namespace {

constexpr int kCompareMs = 500;
constexpr int kHeadHeight = 40;
constexpr int kLeastColumn = 48;
constexpr int kMostColumn = 240;
constexpr int kColumnMargin = 32;  // beside a title, including the sort arrow
enum Page { NothingPage, ComparisonPage, RunsPage };

/// Metric titles wrap to two lines.
void styleHead(QHeaderView& head) {
  head.setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter | Qt::Alignment(Qt::TextWordWrap));
  head.setFixedHeight(kHeadHeight);
  head.setMinimumSectionSize(kLeastColumn);
}

/// Fits the columns to their cells, half of their title and its longest word.
void fitColumns(QTableView& table) {
  const QFontMetrics metrics(table.horizontalHeader()->font());
  for (int column = 0; column < table.model()->columnCount(); ++column) {
    const QString title = table.model()->headerData(column, Qt::Horizontal).toString();
    int lines = metrics.horizontalAdvance(title) / 2;
    for (const QString& word : title.split(QLatin1Char(' '))) {
      lines = std::max(lines, metrics.horizontalAdvance(word));
    }
    lines += kColumnMargin;
    const int cells = static_cast<const QAbstractItemView&>(table).sizeHintForColumn(column);
    table.setColumnWidth(
        column, std::clamp(std::max(lines, cells + kColumnMargin / 2), kLeastColumn, kMostColumn));
  }
}

QTableWidgetItem* cellOf(const QString& text, bool isName) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment(int((isName ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter));
  return item;
}

}  // namespace

StudyResults::StudyResults(QWidget* parent)
    : QWidget(parent),
      tabs_(new QTabBar(this)),
      strip_(new QWidget(this)),
      pages_(new QStackedWidget(this)),
      comparison_(new QTableWidget(this)),
      runTable_(new QTableView(this)) {
  tabs_->addTab(tr("Comparison"));
  tabs_->addTab(tr("Runs"));
  tabs_->setDrawBase(false);
  tabs_->setExpanding(false);
  strip_->setAutoFillBackground(true);
  strip_->setBackgroundRole(QPalette::Window);
  editor::configuredLayout(new QHBoxLayout(strip_), {}, 0, {tabs_})->addStretch();
  pages_->addWidget(
      editor::emptyState(tr("Choose scenarios and planners on the left, then press Start.\nFor "
                            "each seed, all planners run with the same people."),
                         this));
  makeComparison();
  makeRuns();
  editor::configuredLayout(new QVBoxLayout(this), {}, 0, {strip_})->addWidget(pages_, 1);
  compareSoon_.setSingleShot(true);
  compareSoon_.setInterval(kCompareMs);
  connect(&compareSoon_, &QTimer::timeout, this, &StudyResults::compare);
  connect(tabs_, &QTabBar::currentChanged, this, &StudyResults::showPage);
  showPage();
}

void StudyResults::makeComparison() {
  editor::styleTable(*comparison_, tr("Comparison"));
  styleHead(*comparison_->horizontalHeader());
  comparison_->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  comparison_->setSelectionMode(QAbstractItemView::NoSelection);
  comparison_->setToolTip(tr("Means with 95 % confidence intervals"));
  pages_->addWidget(comparison_);
}

void StudyResults::makeRuns() {
  sorted_.setSourceModel(&runs_);
  sorted_.setSortRole(Qt::UserRole);
  runTable_->setModel(&sorted_);
  editor::styleTable(*runTable_, tr("Runs"));
  styleHead(*runTable_->horizontalHeader());
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
  strip_->setVisible(hasRows);
}

void StudyResults::begin(const QStringList& paths, const QString& compared) {
  compared_ = compared;
  runs_.begin(paths);
  showPage();
}

void StudyResults::add(const std::vector<StudyRow>& rows) {
  const bool wasEmpty = runs_.rows().empty();
  for (const StudyRow& row : rows) {
    runs_.add(row);
  }
  if (wasEmpty) {
    compare();
    fitColumns(*runTable_);
    showPage();
  } else if (!compareSoon_.isActive()) {
    compareSoon_.start();
  }
}

void StudyResults::compare() {
  const auto options = runs_.byOption(compared_);
  QStringList titles = {compared_.isEmpty() ? tr("Scenario") : pathTitle(compared_), tr("Runs")};
  for (const StudyMetric& metric : studyMetrics()) {
    titles.append(metric.heading());
  }
  comparison_->setColumnCount(titles.size());
  comparison_->setHorizontalHeaderLabels(titles);
  comparison_->horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  comparison_->setRowCount(static_cast<int>(options.size()));
  int row = 0;
  for (const auto& [option, runs] : options) {
    int column = 0;
    comparison_->setItem(row, column++, cellOf(option, true));
    comparison_->setItem(row, column++, cellOf(QString::number(runs.size()), false));
    for (const StudyMetric& metric : studyMetrics()) {
      const QString text = estimateText(metric, runs);
      comparison_->setItem(row, column++, cellOf(text.isEmpty() ? tr("–") : text, false));
    }
    ++row;
  }
  fitColumns(*comparison_);
}

}  // namespace app

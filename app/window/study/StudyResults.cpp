#include "app/window/study/StudyResults.h"

#include <algorithm>
#include <cmath>

#include "editor/look/Form.h"
#include "editor/look/TableExport.h"
#include "editor/panels/RowDelegate.h"

namespace app {

namespace {

constexpr int kCompareMs = 500;
constexpr int kHeadHeight = 40;
constexpr int kIntervalRowHeight = 40;
constexpr int kLeastColumn = 48;
constexpr int kMostColumn = 240;
constexpr int kColumnMargin = 32;  // beside a title, including the sort arrow
constexpr int kFirstInset = 8;     // before the first title
enum Page { NothingPage, ComparisonPage, RunsPage };
enum IntervalPart { Low, Mean, High, ScaleLow, ScaleHigh, IntervalParts };

/// Draws the text of a cell and, below it, its interval on the scale of the column.
class IntervalDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return {QStyledItemDelegate::sizeHint(option, index).width(), kIntervalRowHeight};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    constexpr int kBarRoom = 14;
    const QVariantList parts = index.data(kIntervalRole).toList();
    QStyleOptionViewItem text = option;
    if (parts.size() == IntervalParts) {
      text.rect.setHeight(option.rect.height() - kBarRoom);
      text.displayAlignment = Qt::AlignRight | Qt::AlignBottom;
    }
    QStyledItemDelegate::paint(painter, text, index);
    if (parts.size() == IntervalParts) {
      QRectF room = option.rect;
      room.setTop(room.bottom() - kBarRoom);
      drawInterval(*painter, room.adjusted(kPadding, 0, -kPadding, 0), option.palette, parts);
    }
  }

 private:
  static constexpr double kPadding = 10.0;  // [px], as that of the text

  static void drawInterval(QPainter& painter, const QRectF& room, const QPalette& palette,
                           const QVariantList& parts) {
    const double from = parts[ScaleLow].toDouble();
    const double span = std::max(1e-300, parts[ScaleHigh].toDouble() - from);
    const auto at = [&](int part) {
      const double share = (parts[part].toDouble() - from) / span;
      return QPointF(room.left() + std::clamp(share, 0.0, 1.0) * room.width(), room.center().y());
    };
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette.color(QPalette::Dark), 1.0));
    painter.drawLine(QPointF(room.left(), room.center().y()),
                     QPointF(room.right(), room.center().y()));
    const QColor accent = palette.color(QPalette::Link);
    painter.setPen(QPen(accent, 3.0, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(at(Low), at(High));
    painter.setPen(Qt::NoPen);
    painter.setBrush(accent);
    painter.drawEllipse(at(Mean), 3.5, 3.5);
    painter.restore();
  }
};

/// Metric titles wrap to two lines.
void styleHead(QHeaderView& head) {
  head.setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter | Qt::Alignment(Qt::TextWordWrap));
  head.setFixedHeight(kHeadHeight);
  head.setTextElideMode(Qt::ElideNone);  // two lines
  head.setMinimumSectionSize(kLeastColumn);
}

/// The width for the cells of a column, half of its title and the longest word of it.
int columnWidth(const QTableView& table, int column) {
  const QFontMetrics metrics(table.horizontalHeader()->font());
  const QString title = table.model()->headerData(column, Qt::Horizontal).toString();
  int lines = metrics.horizontalAdvance(title) / 2;
  for (const QString& word : title.split(QLatin1Char(' '))) {
    lines = std::max(lines, metrics.horizontalAdvance(word));
  }
  lines += kColumnMargin + (column == 0 ? kFirstInset : 0);
  const int cells = static_cast<const QAbstractItemView&>(table).sizeHintForColumn(column);
  return std::clamp(std::max(lines, cells + kColumnMargin / 2), kLeastColumn, kMostColumn);
}

/// Columns are only widened while results arrive, so that they do not move back and forth.
void widenColumns(QTableView& table) {
  for (int column = 0; column < table.model()->columnCount(); ++column) {
    const int width = columnWidth(table, column);
    if (width > table.columnWidth(column)) {
      table.setColumnWidth(column, width);
    }
  }
}

void resetColumns(QTableView& table) {
  for (int column = 0; column < table.model()->columnCount(); ++column) {
    table.setColumnWidth(column, kLeastColumn);
  }
}

QTableWidgetItem* cellOf(const QString& text, bool isName) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment(int((isName ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter));
  return item;
}

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
  editor::styleTable(*comparison_, tr("Comparison"));
  editor::makeTableSavable(*comparison_, tr("Comparison"));
  styleHead(*comparison_->horizontalHeader());
  comparison_->setItemDelegate(new IntervalDelegate(comparison_));
  comparison_->verticalHeader()->setDefaultSectionSize(kIntervalRowHeight);
  comparison_->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  comparison_->setSelectionMode(QAbstractItemView::NoSelection);
  auto* page = new QWidget(this);
  auto* meaning = editor::secondaryLabel(
      tr("Mean of the finished runs [95 % confidence interval]. Bars: the same intervals, on one "
         "scale per column. Rates: Wilson; other metrics: bootstrap (BCa)."),
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
  styleHead(*runTable_->horizontalHeader());
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
  resetColumns(*comparison_);
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
    comparison_->setItem(row, 0, cellOf(option, true));
    comparison_->setItem(row++, 1, cellOf(QString::number(runs.size()), false));
  }
  int column = 2;
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
    const QString text = estimateText(metric, estimate);
    QTableWidgetItem* cell = cellOf(text.isEmpty() ? tr("–") : text, false);
    if (estimate.interval.isDefined()) {
      cell->setData(kIntervalRole, QVariantList{estimate.interval.low, estimate.mean,
                                                estimate.interval.high, low, high});
    }
    comparison_->setItem(static_cast<int>(row), column, cell);
  }
}

}  // namespace app

#include "editor/panels/MetricsDock.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QHeaderView>

#include "editor/look/Form.h"
#include "editor/panels/MetricPlot.h"
#include "editor/panels/MetricsModel.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/WholeRows.h"

namespace editor {

namespace {

constexpr int kRowHeight = 24;
constexpr int kCellPadding = 20;

}  // namespace

MetricsDock::MetricsDock(MetricsFeed& feed, SimulationRunner& runner, const Theme& theme,
                         QWidget* parent)
    : QWidget(parent),
      feed_(feed),
      runner_(runner),
      model_(new MetricsModel(feed, this)),
      sparkline_(new SparklineDelegate(*model_, theme, this)),
      stack_(new QStackedLayout(this)),
      table_(new QTableView(this)),
      plot_(new MetricPlot(theme, this)) {
  table_->setModel(model_);
  table_->setItemDelegateForColumn(MetricsModel::CourseColumn, sparkline_);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setShowGrid(false);
  table_->setWordWrap(true);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(kRowHeight);
  table_->viewport()->setAutoFillBackground(false);
  table_->setAccessibleName(tr("Metrics"));
  QHeaderView* header = table_->horizontalHeader();
  header->setSectionResizeMode(QHeaderView::Fixed);
  header->setSectionResizeMode(MetricsModel::NameColumn, QHeaderView::Stretch);
  header->setHighlightSections(false);
  header->setFixedHeight(24);
  table_->setColumnWidth(MetricsModel::NowColumn, 60);
  table_->setColumnWidth(MetricsModel::UnitColumn, 48);
  table_->setColumnWidth(MetricsModel::CourseColumn, 76);
  // Later: columns have their new widths only when all of them are told.
  connect(
      header, &QHeaderView::sectionResized, this,
      [this](int column) {
        if (column == MetricsModel::NameColumn) {
          fitRows();
        }
      },
      Qt::QueuedConnection);
  auto* both = new QSplitter(Qt::Horizontal, this);
  both->addWidget(table_);
  both->addWidget(plot_);
  both->setStretchFactor(0, 3);
  both->setStretchFactor(1, 2);
  both->setSizes({460, 240});
  both->setChildrenCollapsible(true);
  stack_->addWidget(emptyState(tr("Metrics appear when a simulation runs: press Space."), this));
  stack_->addWidget(both);
  connect(&feed_, &MetricsFeed::updated, this, &MetricsDock::takeSnapshot);
  connect(&feed_, &MetricsFeed::cleared, this, &MetricsDock::takeSnapshot);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &MetricsDock::showSelected);
  connect(&runner_, &SimulationRunner::frameShown, this, [this](const FramePtr& frame) {
    if (frame) {
      plot_->setCursor(frame->time);
    }
  });
  setTheme(theme);
}

void MetricsDock::setTheme(const Theme& theme) {
  model_->setTheme(theme);
  sparkline_->setTheme(theme);
  plot_->setTheme(theme);
  table_->viewport()->update();
}

void MetricsDock::takeSnapshot() {
  const std::string kept = selectedKey();
  model_->refresh();
  const bool any = model_->rowCount() > 0;
  if (fittedRows_ != model_->rowCount()) {
    fitRows();
  }
  stack_->setCurrentIndex(any ? 1 : 0);
  if (any && selectedKey().empty()) {
    const int row = model_->rowOf(kept);
    table_->selectRow(row >= 0 ? row : model_->firstWithCurve());
  }
  showSelected();
}

/// Names that are longer than their column go on in further lines.
void MetricsDock::fitRows() {
  fittedRows_ = model_->rowCount();
  fitRowHeights(*table_, MetricsModel::NameColumn, kCellPadding, kRowHeight);
}

std::string MetricsDock::selectedKey() const {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  return rows.isEmpty() ? std::string() : rows.front().data(Qt::UserRole).toString().toStdString();
}

void MetricsDock::showSelected() {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  const int row = rows.isEmpty() ? -1 : rows.front().row();
  plot_->show(model_->resultAt(row), model_->curveAt(row));
}

QString MetricsDock::shownValue(const QString& key) const {
  const int row = model_->rowOf(key.toStdString());
  return row < 0 ? QString()
                 : model_->index(row, MetricsModel::NowColumn).data(Qt::DisplayRole).toString();
}

void MetricsDock::selectMetric(const QString& key) {
  const int row = model_->rowOf(key.toStdString());
  if (row >= 0) {
    table_->selectRow(row);
  }
}

void addMetricsDock(PanelRegistry& to) {
  to.add({60, QObject::tr("Metrics"), Qt::BottomDockWidgetArea}, [](PanelContext& context) {
    auto* panel = new MetricsDock(context.feed, context.runner, context.theme());
    QObject::connect(&context, &PanelContext::themeChanged, panel, &MetricsDock::setTheme);
    return panel;
  });
}

}  // namespace editor

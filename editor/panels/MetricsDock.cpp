#include "editor/panels/MetricsDock.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPainter>
#include <QScopedValueRollback>
#include <QStyledItemDelegate>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_marker.h>
#include <qwt_scale_div.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>

#include "editor/look/Form.h"
#include "editor/panels/MetricsChoice.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/RowDelegate.h"

namespace editor {

namespace {

constexpr int kMinMargin = 12;  // Right margin of a plot [px].
constexpr int kCellPadding = 20;
constexpr int kMinPlotWidth = 520;  // Minimum width for showing the plot [px].
constexpr int kMinSparklineWidth = 340;
constexpr int kPointsShown = 120;
constexpr int kChoiceWidth = 280;

/// Columns of the live table.
enum MetricColumn { NameColumn, NowColumn, UnitColumn, SparklineColumn, MetricColumns };

class SecondsDraw : public QwtScaleDraw {
 public:
  QwtText label(double value) const override { return QwtText(QStringLiteral("%1 s").arg(value)); }
};

/// The finite points of a curve scaled to a rectangle; empty if there are fewer than two.
QPolygonF sparkline(const MetricCurve& curve, const QRectF& place) {
  double low = 0.0;
  double high = 0.0;
  bool any = false;
  for (const double value : curve.values) {
    if (std::isfinite(value)) {
      low = any ? std::min(low, value) : value;
      high = any ? std::max(high, value) : value;
      any = true;
    }
  }
  QPolygonF line;
  if (!any || curve.times.size() < 2) {
    return line;
  }
  const double start = curve.times.front();
  const double span = std::max(curve.times.back() - start, 1e-9);
  const double height = high - low;
  const std::size_t stride = std::max<std::size_t>(1, curve.times.size() / kPointsShown);
  for (std::size_t i = 0; i < curve.times.size(); i += stride) {
    if (std::isfinite(curve.values[i])) {
      const double part = height > 0.0 ? (curve.values[i] - low) / height : 0.0;
      line.push_back({place.left() + (curve.times[i] - start) / span * place.width(),
                      place.bottom() - part * place.height()});
    }
  }
  return line;
}

const MetricCurve* curveOf(const MetricSnapshot& snapshot, const std::string& key) {
  const auto found = snapshot.curves.find(key);
  return found == snapshot.curves.end() ? nullptr : &found->second;
}

bool hasCurve(const MetricCurve& curve) {
  return std::any_of(curve.values.begin(), curve.values.end(),
                     [](double value) { return std::isfinite(value) && value != 0.0; });
}

int alignmentOf(int column) {
  return int{column == NowColumn ? Qt::AlignRight : Qt::AlignLeft} | Qt::AlignVCenter;
}

QString tooltipOf(const metrics::MetricResult& result) {
  const QString why = QString::fromStdString(result.value.why);
  const QString what = QString::fromStdString(result.info.name + "\n" + result.info.formula);
  return why.isEmpty() ? what : QObject::tr("No value: %1").arg(why) + QStringLiteral("\n") + what;
}

}  // namespace

MetricPlot::MetricPlot(const Theme& theme)
    : title_(new QLabel(this)),
      unit_(secondaryLabel({}, this)),
      plot_(new QwtPlot(this)),
      grid_(new QwtPlotGrid),
      curve_(new QwtPlotCurve),
      cursor_(new QwtPlotMarker) {
  title_->setWordWrap(true);
  auto* top = configuredLayout(new QHBoxLayout, {12, 6, 12, 0}, -1);
  top->addWidget(title_, 1);
  top->addWidget(unit_, 0, Qt::AlignTop);
  auto* layout = configuredLayout(new QVBoxLayout(this), {0, 0, 0, 4}, 0);
  layout->addLayout(top);
  layout->addWidget(plot_, 1);
  layOut();
  setTheme(theme);
  setMinimumWidth(180);
}

void MetricPlot::layOut() {
  plot_->setMinimumSize(120, 60);
  plot_->setFrameShape(QFrame::NoFrame);
  static_cast<QwtPlotCanvas*>(plot_->canvas())->setFrameStyle(QFrame::NoFrame);
  plot_->setAxisScaleDraw(QwtPlot::xBottom, new SecondsDraw);
  plot_->setAxisMaxMajor(QwtPlot::xBottom, 5);
  plot_->setAxisMaxMajor(QwtPlot::yLeft, 4);
  plot_->setAxisMaxMinor(QwtPlot::xBottom, 0);
  plot_->setAxisMaxMinor(QwtPlot::yLeft, 0);
  for (const int axis : {int(QwtPlot::xBottom), int(QwtPlot::yLeft)}) {
    plot_->axisScaleDraw(axis)->enableComponent(QwtAbstractScaleDraw::Backbone, false);
    plot_->axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MajorTick, 3);
  }
  grid_->enableX(false);
  grid_->attach(plot_);
  curve_->setRenderHint(QwtPlotItem::RenderAntialiased);
  curve_->attach(plot_);
  cursor_->setLineStyle(QwtPlotMarker::VLine);
  cursor_->attach(plot_);
}

void MetricPlot::setTheme(const Theme& theme) {
  title_->setFont(theme.font(9.5, QFont::DemiBold));
  plot_->setCanvasBackground(theme.color(Role::Panel));
  QPalette colors = plot_->palette();
  colors.setColor(QPalette::Window, theme.color(Role::Panel));
  colors.setColor(QPalette::WindowText, theme.color(Role::FieldEdge));
  colors.setColor(QPalette::Text, theme.color(Role::TextSecondary));
  plot_->setPalette(colors);
  plot_->setAutoFillBackground(true);
  for (const int axis : {int(QwtPlot::xBottom), int(QwtPlot::yLeft)}) {
    plot_->axisWidget(axis)->setPalette(colors);
    plot_->setAxisFont(axis, theme.font(8.0));
  }
  grid_->setPen(theme.color(Role::Line), 1.0);
  curve_->setPen(theme.color(Role::Accent), 1.8);
  cursor_->setLinePen(theme.color(Role::TextSecondary), 1.0, Qt::DashLine);
  plot_->replot();
}

void MetricPlot::show(const metrics::MetricResult* result, const MetricCurve* curve) {
  title_->setText(result != nullptr ? QString::fromStdString(result->info.name) : QString());
  unit_->setText(result != nullptr ? QString::fromStdString(result->info.unit) : QString());
  QVector<QPointF> points;
  if (curve != nullptr) {
    for (std::size_t i = 0; i < curve->times.size(); ++i) {
      if (std::isfinite(curve->values[i])) {
        points.push_back({curve->times[i], curve->values[i]});
      }
    }
  }
  curve_->setSamples(points);
  const bool any = !points.isEmpty();
  const double end = curve != nullptr && !curve->times.empty() ? curve->times.back() : 1.0;
  plot_->setAxisScale(QwtPlot::xBottom, 0.0, std::max(end, 1.0));
  reserveEnd();
  if (any) {
    plot_->setAxisAutoScale(QwtPlot::yLeft);
  } else {
    plot_->setAxisScale(QwtPlot::yLeft, 0.0, 1.0);
  }
  plot_->replot();
}

/// Reserves space for half of the last label beyond the end of the axis.
void MetricPlot::reserveEnd() {
  plot_->updateAxes();
  const QList<double> ticks = plot_->axisScaleDiv(QwtPlot::xBottom).ticks(QwtScaleDiv::MajorTick);
  if (ticks.isEmpty()) {
    return;
  }
  const QString last = plot_->axisScaleDraw(QwtPlot::xBottom)->label(ticks.back()).text();
  const QFontMetrics metrics(plot_->axisFont(QwtPlot::xBottom));
  plot_->setContentsMargins(0, 0, std::max(kMinMargin, metrics.horizontalAdvance(last) / 2 + 4), 0);
}

void MetricPlot::setCursor(double time) {
  cursor_->setXValue(time);
  plot_->replot();
}

/// Draws the curve since the start as a sparkline.
class SparklineDelegate : public QStyledItemDelegate {
 public:
  SparklineDelegate(const MetricsFeed& feed, QObject* parent)
      : QStyledItemDelegate(parent), feed_(feed) {}
  void setTheme(const Theme& theme) { theme_ = theme; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    const std::string key = index.data(Qt::UserRole).toString().toStdString();
    const MetricCurve* curve = curveOf(feed_.snapshot(), key);
    if (curve == nullptr) {
      return;
    }
    const QRectF place = QRectF(option.rect).adjusted(6.0, 6.0, -12.0, -6.0);
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(theme_.color(selected ? Role::Accent : Role::TextSecondary), 1.4,
                         Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->drawPolyline(sparkline(*curve, place));
    painter->restore();
  }

 private:
  const MetricsFeed& feed_;
  Theme theme_;
};

MetricsDock::MetricsDock(MetricsFeed& feed, SimulationRunner& runner, const Theme& theme)
    : feed_(feed),
      sparkline_(new SparklineDelegate(feed, this)),
      parts_(new QSplitter(Qt::Horizontal, this)),
      choose_(new QToolButton(this)),
      stack_(new QStackedLayout),
      table_(new QTableWidget(0, MetricColumns, this)),
      robot_(new QComboBox(this)),
      chooser_(makeChooser()),
      plot_(new MetricPlot(theme)) {
  makeTable();
  auto* both = new QSplitter(Qt::Horizontal, this);
  auto* left = new QWidget(both);
  configuredLayout(new QVBoxLayout(left), {}, 0, {table_});
  both->addWidget(plot_);
  both->setStretchFactor(0, 3);
  both->setStretchFactor(1, 2);
  both->setSizes({460, 240});
  both->setChildrenCollapsible(true);
  stack_->addWidget(emptyState(tr("Metrics appear when a simulation runs: press Space."), this));
  stack_->addWidget(both);
  auto* measured = new QWidget(parts_);
  measured->setLayout(stack_);
  parts_->setChildrenCollapsible(false);
  configuredLayout(new QVBoxLayout(this), {}, 0, {makeTop()})->addWidget(parts_, 1);
  connect(&feed_, &MetricsFeed::updated, this, &MetricsDock::showSnapshot);
  connect(&feed_, &MetricsFeed::cleared, this, &MetricsDock::showSnapshot);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    if (!isSelecting_) {
      chosen_ = selectedKey();
    }
    showSelected();
  });
  connect(&runner, &SimulationRunner::frameShown, this, [this](const FramePtr& frame) {
    if (frame) {
      plot_->setCursor(frame->time);
    }
  });
  setTheme(theme);
}

/// The robot chooser, and the button for the metric selection.
QWidget* MetricsDock::makeTop() {
  auto* top = new QWidget(this);
  choose_->setCheckable(true);
  choose_->setAutoRaise(true);
  choose_->setFixedHeight(kListRowHeight);
  choose_->setToolTip(tr("Choose the metrics to measure"));
  choose_->hide();
  auto* row = configuredLayout(new QHBoxLayout(top), {0, 0, 8, 0}, 0, {chooser_});
  row->addStretch(1);
  row->addWidget(choose_);
  connect(choose_, &QToolButton::toggled, this, [this](bool on) {
    choice_->setVisible(on);
    parts_->setSizes({kChoiceWidth, std::max(kChoiceWidth, width() - kChoiceWidth)});
    adaptToWidth();
  });
  return top;
}

void MetricsDock::setChoice(MetricsChoice& choice) {
  choice_ = &choice;
  choice.hide();
  parts_->insertWidget(0, &choice);
  parts_->setStretchFactor(0, 0);
  parts_->setStretchFactor(1, 1);
  const auto tell = [this](const QString& count) {
    choose_->setText(tr("%1 measured · Choose…").arg(count));
  };
  connect(&choice, &MetricsChoice::countChanged, this, tell);
  tell(choice.count());
  choose_->show();
}

/// The chooser of the robot.
QWidget* MetricsDock::makeChooser() {
  auto* chooser = new QWidget(this);
  robot_->setAccessibleName(tr("Metrics of"));
  robot_->setToolTip(tr("Robot whose metrics are shown"));
  robot_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  robot_->setFocusPolicy(Qt::TabFocus);
  auto* row = configuredLayout(new QHBoxLayout(chooser), {12, 6, 12, 6}, 8,
                               {secondaryLabel(tr("Metrics of"), chooser), robot_});
  row->addStretch(1);
  connect(robot_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
    const std::string chosen = chosen_;  // Keeps the same metric.
    feed_.setRobot(robot_->itemData(index).toInt());
    chosen_ = chosen;
  });
  chooser->hide();
  return chooser;
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
  chooser_->setVisible(count > 1);
}

/// In a narrow dock the names get the space: the plot is hidden first, then the sparklines.
void MetricsDock::adaptToWidth() {
  const int room = width() - (choose_->isChecked() ? kChoiceWidth : 0);
  plot_->setHidden(room < kMinPlotWidth);
  table_->setColumnHidden(SparklineColumn, room < kMinSparklineWidth);
}

void MetricsDock::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  adaptToWidth();
}

void MetricsDock::makeTable() {
  styleTable(*table_, tr("Metrics"));
  table_->setItemDelegateForColumn(SparklineColumn, sparkline_);
  table_->setHorizontalHeaderLabels({tr("Metric"), tr("Now"), tr("Unit"), tr("Since start")});
  for (int column = 0; column < MetricColumns; ++column) {
    table_->horizontalHeaderItem(column)->setTextAlignment(alignmentOf(column));
  }
  QHeaderView* header = table_->horizontalHeader();
  header->setSectionResizeMode(QHeaderView::Fixed);
  header->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
  header->setHighlightSections(false);
  header->setFixedHeight(kListRowHeight);
  table_->setColumnWidth(NowColumn, 60);
  table_->setColumnWidth(UnitColumn, 48);
  table_->setColumnWidth(SparklineColumn, 76);
  // Queued, because all columns have their new widths only after all signals.
  connect(
      header, &QHeaderView::sectionResized, this,
      [this](int column) {
        if (column == NameColumn) {
          fitRows();
        }
      },
      Qt::QueuedConnection);
}

void MetricsDock::setTheme(const Theme& theme) {
  pale_ = theme.color(Role::TextSecondary);
  sparkline_->setTheme(theme);
  plot_->setTheme(theme);
  fillRows();
}

/// Keeps the selection of the user. Before the user selects, the first row with a curve is
/// selected, which depends only on the measured metrics, not on timing.
void MetricsDock::showSnapshot() {
  const QScopedValueRollback<bool> choosing(isSelecting_, true);
  fillChooser();
  fillRows();
  const bool any = table_->rowCount() > 0;
  if (fittedRows_ != table_->rowCount()) {
    fitRows();
  }
  stack_->setCurrentIndex(any ? 1 : 0);
  if (any) {
    const int row = rowOf(chosen_) >= 0 ? rowOf(chosen_) : firstWithCurve();
    if (rowOf(selectedKey()) != row) {
      table_->selectRow(row);
    }
  } else {
    chosen_.clear();
  }
  showSelected();
}

/// Keeps the rows if only values change.
void MetricsDock::fillRows() {
  const std::vector<metrics::MetricResult>& results = feed_.shown();
  const int rows = static_cast<int>(results.size());
  if (table_->rowCount() != rows) {
    table_->setRowCount(0);
    table_->setRowCount(rows);
  }
  for (int row = 0; row < rows; ++row) {
    const metrics::MetricResult& result = results[static_cast<std::size_t>(row)];
    const QString tip = tooltipOf(result);
    const QString texts[] = {QString::fromStdString(result.info.name),
                             metricText(result),
                             QString::fromStdString(result.info.unit),
                             {}};
    for (int column = 0; column < MetricColumns; ++column) {
      QTableWidgetItem* item = table_->item(row, column);
      if (item == nullptr) {
        item = new QTableWidgetItem;
        item->setTextAlignment(alignmentOf(column));
        item->setData(Qt::UserRole, QString::fromStdString(result.info.key));
        table_->setItem(row, column, item);
      }
      const bool isDimmed = column == UnitColumn || !result.value.value;
      item->setText(texts[column]);
      item->setToolTip(tip);
      item->setData(Qt::ForegroundRole, isDimmed ? QVariant(pale_) : QVariant());
    }
  }
  table_->viewport()->update();
}

/// Wraps names that are longer than their column.
void MetricsDock::fitRows() {
  fittedRows_ = table_->rowCount();
  fitRowHeights(*table_, NameColumn, kCellPadding);
}

int MetricsDock::rowOf(const std::string& key) const {
  const auto& results = feed_.shown();
  const auto found = std::find_if(results.begin(), results.end(),
                                  [&](const auto& result) { return result.info.key == key; });
  return found == results.end() ? -1 : static_cast<int>(found - results.begin());
}

/// The first row with a curve, else 0.
int MetricsDock::firstWithCurve() const {
  const MetricSnapshot& snapshot = feed_.snapshot();
  const auto found = std::find_if(snapshot.results.begin(), snapshot.results.end(),
                                  [&](const metrics::MetricResult& result) {
                                    const MetricCurve* curve = curveOf(snapshot, result.info.key);
                                    return curve != nullptr && hasCurve(*curve);
                                  });
  return found == snapshot.results.end() ? 0 : static_cast<int>(found - snapshot.results.begin());
}

std::string MetricsDock::selectedKey() const {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  return rows.isEmpty() ? std::string() : rows.front().data(Qt::UserRole).toString().toStdString();
}

void MetricsDock::showSelected() {
  const std::string key = selectedKey();
  const int row = rowOf(key);
  plot_->show(row < 0 ? nullptr : &feed_.shown()[static_cast<std::size_t>(row)],
              curveOf(feed_.snapshot(), key));
}

void addMetricsDock(PanelRegistry& to) {
  to.add(closedBottomPanel(60, QObject::tr("Metrics")), [](PanelContext& context) {
    auto* panel = new MetricsDock(context.feed, context.runner, context.theme());
    auto* choice = new MetricsChoice(context.document, context.feed, context.theme());
    panel->setChoice(*choice);
    QObject::connect(&context, &PanelContext::themeChanged, panel, &MetricsDock::setTheme);
    QObject::connect(&context, &PanelContext::themeChanged, choice, &MetricsChoice::setTheme);
    QObject::connect(choice, &MetricsChoice::saved, &context, &PanelContext::problemsFound);
    return panel;
  });
}

}  // namespace editor

#include "editor/panels/MetricsDock.h"

#include <cmath>

#include "editor/panels/PanelRegistry.h"
#include "editor/panels/RowDelegate.h"

namespace editor {

namespace {

constexpr int kCellPadding = 20;
constexpr int kMinPlotWidth = 520;  // Minimum width for showing the plot [px].
constexpr int kMinSparklineWidth = 340;
constexpr int kPointsShown = 120;
constexpr int kChoiceWidth = 280;

/// Columns of the live table.
enum MetricColumn { MetricNameColumn, NowColumn, UnitColumn, SparklineColumn, MetricColumns };

/// The finite points of a curve scaled to a rectangle; empty if there are fewer than two.
QPolygonF sparkline(const app::MetricTimeSeries& curve, const QRectF& place) {
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

const app::MetricTimeSeries* curveOf(const MetricSnapshot& snapshot, const std::string& key) {
  const auto found = snapshot.curves.find(key);
  return found == snapshot.curves.end() ? nullptr : &found->second;
}

bool hasCurve(const app::MetricTimeSeries& curve) {
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
    const app::MetricTimeSeries* curve = curveOf(feed_.snapshot(), key);
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
      table_(new QTableWidget(0, MetricColumns, this)),
      chooser_(makeChooser()),
      plot_(new MetricPlot(theme, true)) {
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
  header->setSectionResizeMode(MetricNameColumn, QHeaderView::Stretch);
  header->setHighlightSections(false);
  header->setFixedHeight(kListRowHeight);
  table_->setColumnWidth(NowColumn, 60);
  table_->setColumnWidth(UnitColumn, 48);
  table_->setColumnWidth(SparklineColumn, 76);
  // Queued, because all columns have their new widths only after all signals.
  connect(
      header, &QHeaderView::sectionResized, this,
      [this](int column) {
        if (column == MetricNameColumn) {
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
  fitRowHeights(*table_, MetricNameColumn, kCellPadding);
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
  const auto found = std::find_if(
      snapshot.results.begin(), snapshot.results.end(), [&](const metrics::MetricResult& result) {
        const app::MetricTimeSeries* curve = curveOf(snapshot, result.info.key);
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
  const metrics::MetricInfo info =
      row < 0 ? metrics::MetricInfo() : feed_.shown()[static_cast<std::size_t>(row)].info;
  plot_->show(QString::fromStdString(info.name), QString::fromStdString(info.unit),
              {{curveOf(feed_.snapshot(), key)}});
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

#include "editor/panels/MetricsDock.h"

#include <algorithm>
#include <cmath>

#include <QAbstractTableModel>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPainter>
#include <QScopedValueRollback>
#include <QStyledItemDelegate>

#include "editor/look/Form.h"
#include "editor/panels/MetricPlot.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/RowDelegate.h"

namespace editor {

namespace {

constexpr int kCellPadding = 20;
constexpr int kPointsShown = 120;

/// The finite points of a curve on a rectangle; nothing for less than two.
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

}  // namespace

/// Rows of the live table: metric, now, unit, course. Rows stay when values change.
class MetricsModel : public QAbstractTableModel {
 public:
  enum Column { NameColumn, NowColumn, UnitColumn, CourseColumn, ColumnCount };
  MetricsModel(const MetricsFeed& feed, QObject* parent)
      : QAbstractTableModel(parent), feed_(feed) {}

  void setTheme(const Theme& theme) { pale_ = theme.color(Role::TextSecondary); }

  void refresh() {
    const int wanted = static_cast<int>(feed_.snapshot().results.size());
    if (wanted != rows_) {
      beginResetModel();
      rows_ = wanted;
      endResetModel();
    } else if (rows_ > 0) {
      Q_EMIT dataChanged(index(0, NameColumn), index(rows_ - 1, CourseColumn));
    }
  }

  int rowOf(const std::string& key) const {  // -1 = none
    const auto& results = feed_.snapshot().results;
    const auto found = std::find_if(results.begin(), results.end(),
                                    [&](const auto& result) { return result.info.key == key; });
    return found == results.end() ? -1 : static_cast<int>(found - results.begin());
  }

  const metrics::MetricResult* resultAt(int row) const {
    const auto& results = feed_.snapshot().results;
    return row >= 0 && row < static_cast<int>(results.size())
               ? &results[static_cast<std::size_t>(row)]
               : nullptr;
  }

  const MetricCurve* curveAt(int row) const {
    const metrics::MetricResult* result = resultAt(row);
    const auto& curves = feed_.snapshot().curves;
    const auto found = result == nullptr ? curves.end() : curves.find(result->info.key);
    return found == curves.end() ? nullptr : &found->second;
  }

  /// The first row that has something to plot, else 0.
  int firstWithCurve() const {
    for (int row = 0; row < rows_; ++row) {
      const MetricCurve* curve = curveAt(row);
      if (curve != nullptr &&
          std::any_of(curve->values.begin(), curve->values.end(),
                      [](double value) { return std::isfinite(value) && value != 0.0; })) {
        return row;
      }
    }
    return 0;
  }

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : rows_;
  }
  int columnCount(const QModelIndex& = {}) const override { return ColumnCount; }

  QVariant data(const QModelIndex& index, int role) const override {
    const metrics::MetricResult* result = resultAt(index.row());
    if (result == nullptr) {
      return {};
    }
    const int column = index.column();
    switch (role) {
      case Qt::DisplayRole:
        return column == NameColumn   ? QString::fromStdString(result->info.name)
               : column == NowColumn  ? metricText(*result)
               : column == UnitColumn ? QString::fromStdString(result->info.unit)
                                      : QVariant();
      case Qt::ToolTipRole:
        return tooltip(*result);
      case Qt::UserRole:
        return QString::fromStdString(result->info.key);
      case Qt::ForegroundRole:
        return column == UnitColumn || !result->value.value ? pale_ : QVariant();
      case Qt::TextAlignmentRole:
        return alignment(column);
      default:
        return {};
    }
  }

  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    static const char* const kTitles[] = {QT_TR_NOOP("Metric"), QT_TR_NOOP("Now"),
                                          QT_TR_NOOP("Unit"), QT_TR_NOOP("Since start")};
    if (orientation != Qt::Horizontal) {
      return {};
    }
    return role == Qt::TextAlignmentRole ? alignment(section)
           : role == Qt::DisplayRole     ? tr(kTitles[section])
                                         : QVariant();
  }

 private:
  static QVariant alignment(int column) {
    return static_cast<int>((column == NowColumn ? Qt::AlignRight : Qt::AlignLeft) |
                            Qt::AlignVCenter);
  }
  static QString tooltip(const metrics::MetricResult& result) {
    const QString why = QString::fromStdString(result.value.why);
    const QString what = QString::fromStdString(result.info.name + "\n" + result.info.formula);
    return why.isEmpty() ? what : tr("No value: %1").arg(why) + QStringLiteral("\n") + what;
  }

  const MetricsFeed& feed_;
  int rows_ = 0;
  QColor pale_;
};

/// The course since the start as a small line without axes.
class SparklineDelegate : public QStyledItemDelegate {
 public:
  SparklineDelegate(const MetricsModel& model, const Theme& theme, QObject* parent)
      : QStyledItemDelegate(parent), model_(model), theme_(theme) {}
  void setTheme(const Theme& theme) { theme_ = theme; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    const MetricCurve* curve = model_.curveAt(index.row());
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
  const MetricsModel& model_;
  Theme theme_;
};

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
  styleTable(*table_, *model_, tr("Metrics"));
  table_->setItemDelegateForColumn(MetricsModel::CourseColumn, sparkline_);
  QHeaderView* header = table_->horizontalHeader();
  header->setSectionResizeMode(QHeaderView::Fixed);
  header->setSectionResizeMode(MetricsModel::NameColumn, QHeaderView::Stretch);
  header->setHighlightSections(false);
  header->setFixedHeight(kListRowHeight);
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
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    if (!isChoosing_) {
      chosen_ = selectedKey();
    }
    showSelected();
  });
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

/// What the user chose stays selected; before that it is the first of the list that has a course,
/// which depends on what is measured alone, not on when it was told.
void MetricsDock::takeSnapshot() {
  const QScopedValueRollback<bool> choosing(isChoosing_, true);
  model_->refresh();
  const bool any = model_->rowCount() > 0;
  if (fittedRows_ != model_->rowCount()) {
    fitRows();
  }
  stack_->setCurrentIndex(any ? 1 : 0);
  if (any) {
    const int row = model_->rowOf(chosen_) >= 0 ? model_->rowOf(chosen_) : model_->firstWithCurve();
    if (model_->rowOf(selectedKey()) != row) {
      table_->selectRow(row);
    }
  } else {
    chosen_.clear();
  }
  showSelected();
}

/// Names that are longer than their column go on in further lines.
void MetricsDock::fitRows() {
  fittedRows_ = model_->rowCount();
  fitRowHeights(*table_, MetricsModel::NameColumn, kCellPadding);
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

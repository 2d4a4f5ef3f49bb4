#include "editor/panels/MetricsModel.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

namespace editor {

namespace {

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

void MetricsModel::setTheme(const Theme& theme) {
  pale_ = theme.color(Role::TextSecondary);
}

void MetricsModel::refresh() {
  const int wanted = static_cast<int>(feed_.snapshot().results.size());
  if (wanted != rows_) {
    beginResetModel();
    rows_ = wanted;
    endResetModel();
  } else if (rows_ > 0) {
    Q_EMIT dataChanged(index(0, NameColumn), index(rows_ - 1, CourseColumn));
  }
}

int MetricsModel::rowOf(const std::string& key) const {
  const auto& results = feed_.snapshot().results;
  const auto found = std::find_if(results.begin(), results.end(),
                                  [&](const auto& result) { return result.info.key == key; });
  return found == results.end() ? -1 : static_cast<int>(found - results.begin());
}

const metrics::MetricResult* MetricsModel::resultAt(int row) const {
  const auto& results = feed_.snapshot().results;
  return row >= 0 && row < static_cast<int>(results.size())
             ? &results[static_cast<std::size_t>(row)]
             : nullptr;
}

const MetricCurve* MetricsModel::curveAt(int row) const {
  const metrics::MetricResult* result = resultAt(row);
  if (result == nullptr) {
    return nullptr;
  }
  const auto found = feed_.snapshot().curves.find(result->info.key);
  return found == feed_.snapshot().curves.end() ? nullptr : &found->second;
}

int MetricsModel::firstWithCurve() const {
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

int MetricsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : rows_;
}

QString MetricsModel::tooltip(const metrics::MetricResult& result) const {
  const QString why = QString::fromStdString(result.value.why);
  const QString what = QString::fromStdString(result.info.name + "\n" + result.info.formula);
  return why.isEmpty() ? what : tr("No value: %1").arg(why) + QStringLiteral("\n") + what;
}

QVariant MetricsModel::data(const QModelIndex& index, int role) const {
  const metrics::MetricResult* result = resultAt(index.row());
  if (result == nullptr) {
    return {};
  }
  switch (role) {
    case Qt::DisplayRole:
      switch (index.column()) {
        case NameColumn:
          return QString::fromStdString(result->info.name);
        case NowColumn:
          return metricText(*result);
        case UnitColumn:
          return QString::fromStdString(result->info.unit);
        default:
          return {};
      }
    case Qt::ToolTipRole:
      return tooltip(*result);
    case Qt::UserRole:
      return QString::fromStdString(result->info.key);
    case Qt::ForegroundRole:
      return index.column() == UnitColumn || !result->value.value ? pale_ : QVariant();
    case Qt::TextAlignmentRole:
      return static_cast<int>((index.column() == NowColumn ? Qt::AlignRight : Qt::AlignLeft) |
                              Qt::AlignVCenter);
    default:
      return {};
  }
}

QVariant MetricsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) {
    return {};
  }
  if (role == Qt::TextAlignmentRole) {
    return static_cast<int>((section == NowColumn ? Qt::AlignRight : Qt::AlignLeft) |
                            Qt::AlignVCenter);
  }
  static const char* const kTitles[] = {QT_TR_NOOP("Metric"), QT_TR_NOOP("Now"), QT_TR_NOOP("Unit"),
                                        QT_TR_NOOP("Since start")};
  return role == Qt::DisplayRole ? tr(kTitles[section]) : QVariant();
}

void SparklineDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const {
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

}  // namespace editor

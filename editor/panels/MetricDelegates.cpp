#include "editor/panels/MetricDelegates.h"

#include <algorithm>
#include <cmath>

#include "editor/look/TableExport.h"
#include "editor/panels/RowDelegate.h"

namespace editor {

namespace {

constexpr int kPointsShown = 120;

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

}  // namespace

const app::MetricTimeSeries* curveOf(const MetricSnapshot& snapshot, const std::string& key) {
  const auto found = snapshot.curves.find(key);
  return found == snapshot.curves.end() ? nullptr : &found->second;
}

QSize MetricNameDelegate::sizeHint(const QStyleOptionViewItem& option,
                                   const QModelIndex& index) const {
  int height = kListRowHeight;
  if (index.column() == 0 && index.parent().isValid()) {
    const QRect letters = option.fontMetrics.boundingRect(
        QRect(0, 0, room(index), 1000), Qt::TextWordWrap, index.data(Qt::DisplayRole).toString());
    height = std::max(height, letters.height() + kListRowPadding);
  }
  return {QStyledItemDelegate::sizeHint(option, index).width(), height};
}

/// Width available for a name [px].
int MetricNameDelegate::room(const QModelIndex& index) const {
  int level = 1;
  for (QModelIndex each = index.parent(); each.isValid(); each = each.parent()) {
    ++level;
  }
  QStyleOptionViewItem row;
  initStyleOption(&row, index);
  row.widget = &tree_;
  row.text = QString(200, QLatin1Char('m'));  // Long enough to fill the available width.
  row.rect = QRect(0, 0, tree_.columnWidth(0) - level * tree_.indentation(), kListRowHeight);
  const QStyle& style = *tree_.style();
  const int margin = style.pixelMetric(QStyle::PM_FocusFrameHMargin, &row, &tree_) + 1;
  return style.subElementRect(QStyle::SE_ItemViewItemText, &row, &tree_).width() - 2 * margin;
}

void SparklineDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const {
  QStyledItemDelegate::paint(painter, option, index);
  const std::string key = index.siblingAtColumn(0).data(kSavedKeyRole).toString().toStdString();
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

}  // namespace editor

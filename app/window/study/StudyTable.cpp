#include "app/window/study/StudyTable.h"

#include <algorithm>
#include <cmath>

#include "editor/look/TableExport.h"
#include "editor/panels/RowDelegate.h"

namespace app {

namespace {

constexpr int kHeadHeight = 40;
constexpr int kLeastColumn = 48;
constexpr int kMostColumn = 240;
constexpr int kColumnMargin = 32;                      // beside a title, including the sort arrow
constexpr int kFirstInset = 8;                         // before the first title
constexpr double kCellPadding = 10.0;                  // [px], as that of the text
constexpr int kBarColumn = 220;                        // least width of a column with bars [px]
constexpr double kLeastHeat = 0.12, kHeatRange = 0.5;  // opacity
enum IntervalPart { Low, Mean, High, ScaleLow, ScaleHigh, IntervalParts };
enum BarPart { BarValue, BarLow, BarHigh, BarScale, BarDark, BarParts };

void drawInterval(QPainter& painter, const QRectF& room, const QPalette& palette,
                  const QVariantList& parts) {
  const double from = parts[ScaleLow].toDouble();
  const double span = std::max(1e-300, parts[ScaleHigh].toDouble() - from);
  const auto at = [&](int part) {
    const double share = (parts[part].toDouble() - from) / span;
    return QPointF(room.left() + std::clamp(share, 0.0, 1.0) * room.width(), room.center().y());
  };
  painter.setPen(QPen(palette.color(QPalette::Dark), 1.0));
  painter.drawLine(QPointF(room.left(), room.center().y()),
                   QPointF(room.right(), room.center().y()));
  for (int mark = IntervalParts; mark < parts.size(); ++mark) {
    const double x = at(mark).x();
    const bool isFirst = mark == IntervalParts;
    painter.setPen(QPen(palette.color(QPalette::Text), 1.0, isFirst ? Qt::SolidLine : Qt::DotLine));
    painter.drawLine(QPointF(x, room.top() + 1.0), QPointF(x, room.bottom() - 1.0));
  }
  const QColor& accent = palette.color(QPalette::Link);
  painter.setPen(QPen(accent, 3.0, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(at(Low), at(High));
  painter.setPen(Qt::NoPen);
  painter.setBrush(accent);
  painter.drawEllipse(at(Mean), 3.5, 3.5);
}

void drawBar(QPainter& painter, const QRectF& room, const QPalette& palette,
             const QVariantList& parts) {
  const double scale = std::max(1e-300, parts[BarScale].toDouble());
  const auto at = [&](int part) {
    return room.left() + std::clamp(parts[part].toDouble() / scale, 0.0, 1.0) * room.width();
  };
  const auto bar = [&](double end, double opacity) {
    QColor color = palette.color(QPalette::Link);
    color.setAlphaF(opacity);
    painter.fillRect(QRectF(room.left(), room.top(), end - room.left(), room.height()), color);
  };
  bar(at(BarValue), 0.45);
  bar(std::min(at(BarValue), at(BarDark)), 0.4);
  if (!std::isnan(parts[BarLow].toDouble()) && !std::isnan(parts[BarHigh].toDouble())) {
    painter.setPen(QPen(palette.color(QPalette::Text), 1.5));
    const double y = room.center().y();
    painter.drawLine(QPointF(at(BarLow), y), QPointF(at(BarHigh), y));
  }
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

}  // namespace

QSize IntervalDelegate::sizeHint(const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const {
  const int width = QStyledItemDelegate::sizeHint(option, index).width();
  return {index.data(kBarRole).isValid() ? std::max(width, kBarColumn) : width, kRowHeight};
}

void IntervalDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const {
  constexpr int kBarRoom = 14;
  constexpr double kBarHeight = 12.0;
  const QVariantList interval = index.data(kIntervalRole).toList();
  const QVariantList bar = index.data(kBarRole).toList();
  QStyleOptionViewItem text = option;
  if (index.data(kHeatRole).isValid()) {
    QColor heat = option.palette.color(QPalette::Link);
    heat.setAlphaF(kLeastHeat + kHeatRange * index.data(kHeatRole).toDouble());
    painter->fillRect(option.rect, heat);
  }
  if (interval.size() >= IntervalParts) {
    text.rect.setHeight(option.rect.height() - kBarRoom);
    text.displayAlignment = Qt::AlignRight | Qt::AlignBottom;
  }
  QStyledItemDelegate::paint(painter, text, index);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  if (interval.size() >= IntervalParts) {
    QRectF room = option.rect;
    room.setTop(room.bottom() - kBarRoom);
    drawInterval(*painter, room.adjusted(kCellPadding, 0, -kCellPadding, 0), option.palette,
                 interval);
  } else if (bar.size() == BarParts) {
    const int words = option.fontMetrics.horizontalAdvance(index.data().toString());
    QRectF room = QRectF(option.rect).adjusted(kCellPadding, 0, -2.0 * kCellPadding - words, 0);
    room = QRectF(room.left(), room.center().y() - kBarHeight / 2.0, std::max(0.0, room.width()),
                  kBarHeight);
    drawBar(*painter, room, option.palette, bar);
  }
  painter->restore();
}

void styleStudyTable(QTableWidget& table, const QString& name) {
  editor::styleTable(table, name);
  editor::makeTableSavable(table, name);
  styleStudyHead(*table.horizontalHeader());
  table.setItemDelegate(new IntervalDelegate(&table));
  table.verticalHeader()->setDefaultSectionSize(IntervalDelegate::kRowHeight);
  table.setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
}

void styleStudyHead(QHeaderView& head) {
  head.setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter | Qt::Alignment(Qt::TextWordWrap));
  head.setFixedHeight(kHeadHeight);
  head.setTextElideMode(Qt::ElideNone);  // two lines
  head.setMinimumSectionSize(kLeastColumn);
}

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

void reserveColumn(QTableView& table, int column, const QString& text) {
  const int width =
      table.fontMetrics().horizontalAdvance(text) + qRound(3.0 * kCellPadding) + kColumnMargin / 2;
  table.setColumnWidth(column, std::clamp(width, table.columnWidth(column), kMostColumn));
}

QTableWidgetItem* studyCell(const QString& text, bool isText) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment(int((isText ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter));
  return item;
}

QTableWidgetItem* intervalCell(const QString& text, double mean,
                               const statistics::Interval& interval, double low, double high,
                               const std::vector<double>& marks) {
  QTableWidgetItem* cell = studyCell(text, false);
  if (interval.isDefined()) {
    QVariantList parts = {interval.low, mean, interval.high, low, high};
    for (const double mark : marks) {
      parts.append(mark);
    }
    cell->setData(kIntervalRole, parts);
  }
  return cell;
}

void setStudyColumns(QTableWidget& table, const QStringList& titles, const QList<int>& texts) {
  table.setColumnCount(titles.size());
  table.setHorizontalHeaderLabels(titles);
  for (const int column : texts) {
    table.horizontalHeaderItem(column)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  }
}

QTableWidget* studyList(const QString& name, const QStringList& titles, const QList<int>& texts) {
  auto* table = new QTableWidget;
  styleStudyTable(*table, name);
  table->verticalHeader()->setDefaultSectionSize(editor::kListRowHeight);
  setStudyColumns(*table, titles, texts);
  return table;
}

}  // namespace app

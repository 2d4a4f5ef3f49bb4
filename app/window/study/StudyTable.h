#pragma once

#include <vector>

#include <QtWidgets>

#include "metrics/statistics/Summary.h"

/// Tables of studies: cells with intervals and bars, and columns with titles on two lines.
namespace app {

/// Item data of a cell with an interval: low, mean, high and the ends of its scale, then places of
/// vertical marks, as a list of numbers. The interval is drawn below the text.
constexpr int kIntervalRole = Qt::UserRole + 1;
/// Item data of a cell with a bar: value, low, high, the end of its scale (which begins at 0) and
/// the darker part of the bar, as a list of numbers. The bar is drawn left of the text, the
/// interval as a line on it.
constexpr int kBarRole = Qt::UserRole + 2;

/// Item data of a cell of a heat map: a number from 0 to 1, drawn as the strength of the
/// background.
constexpr int kHeatRole = Qt::UserRole + 3;

/// Draws cells with kIntervalRole, kBarRole or kHeatRole.
class IntervalDelegate : public QStyledItemDelegate {
 public:
  static constexpr int kRowHeight = 40;  // [px]

  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
};

/// A read-only table with intervals. `name`: for screen readers and saved tables.
void styleStudyTable(QTableWidget& table, const QString& name);
/// Titles wrap to two lines.
void styleStudyHead(QHeaderView& head);

/// Columns are only widened while results arrive, so that they do not move back and forth.
void widenColumns(QTableView& table);
void resetColumns(QTableView& table);
void reserveColumn(QTableView& table, int column, const QString& text);  // for a cell with it

QTableWidgetItem* studyCell(const QString& text, bool isText);
/// A text with its interval below, on a scale from `low` to `high`; `marks`: places of vertical
/// lines on it. Without an interval only the text.
QTableWidgetItem* intervalCell(const QString& text, double mean,
                               const statistics::Interval& interval, double low, double high,
                               const std::vector<double>& marks = {});

/// Sets the titles of the columns; `texts`: columns with text, which is left-aligned.
void setStudyColumns(QTableWidget& table, const QStringList& titles, const QList<int>& texts);

/// A table without intervals below the texts, and therefore with low rows.
QTableWidget* studyList(const QString& name, const QStringList& titles, const QList<int>& texts);

}  // namespace app

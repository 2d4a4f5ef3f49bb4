#pragma once

#include <QtWidgets>

namespace editor {

/// Data role of the secondary text of a row.
constexpr int kSideTextRole = Qt::UserRole + 101;
/// Row height of lists, trees and tables [px].
constexpr int kListRowHeight = 24;
constexpr int kListRowPadding = 6;  // Padding of multi-line text.

/// Draws the name, semibold when selected, and a secondary text at the right end.
class RowDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 protected:
  virtual QString sideText(const QModelIndex& index) const {
    return index.data(kSideTextRole).toString();
  }
  /// Free space at the right end [px].
  virtual int rightMargin(const QStyleOptionViewItem&, const QModelIndex&) const { return 12; }
  virtual bool isHeading(const QModelIndex&) const { return false; }
  /// Rows that are switched off are drawn in the secondary colour.
  virtual bool isDimmed(const QModelIndex&) const { return false; }
};

/// Contains a list and limits its height to whole rows, so that the last one is not clipped. All
/// rows have the same height.
class WholeRows : public QWidget {
 public:
  explicit WholeRows(QAbstractItemView& list, QWidget* parent = nullptr);
  QSize sizeHint() const override { return list_.sizeHint(); }
  QSize minimumSizeHint() const override { return list_.minimumSizeHint(); }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QAbstractItemView& list_;
};

/// Style of a frameless list, tree or table that is never wider than its panel.
void styleList(QAbstractItemView& list, const QString& name);
/// Style of a read-only table with single row selection.
void styleTable(QTableView& table, const QString& name);
/// Sets row heights to the wrapped text in a column. `margin`: width of cell padding and icon.
void fitRowHeights(QTableView& table, int column, int margin);

}  // namespace editor

#pragma once

#include <QStyledItemDelegate>
#include <QTableView>

namespace editor {

/// Data role of the secondary text of a row.
constexpr int kSideTextRole = Qt::UserRole + 101;
/// Of lists, trees and tables [px].
constexpr int kListRowHeight = 24;
constexpr int kListRowPadding = 6;  // of a text of several lines

/// The name, semibold when selected, and a secondary text at the right end.
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
  /// Pixels at the right end that stay free [px].
  virtual int rightMargin(const QStyleOptionViewItem&, const QModelIndex&) const { return 12; }
  virtual bool isHeading(const QModelIndex&) const { return false; }
  /// What is switched off is written in the secondary colour.
  virtual bool isPale(const QModelIndex&) const { return false; }
};

/// Holds a list and gives it as much of its height as whole rows need, so that the last one is
/// never cut. The rows of the list have one height.
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

/// A list, tree or table that lies on its panel without a frame and is never wider than it.
void styleList(QAbstractItemView& list, const QString& name);
/// A table of whole rows to look at, of which one can be selected.
void styleTable(QTableView& table, const QString& name);
/// Rows of a table get as many lines as the text in this column needs. `margin` is what cell and
/// icon take of the width.
void fitRowHeights(QTableView& table, int column, int margin);

}  // namespace editor

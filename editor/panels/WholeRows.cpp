#include "editor/panels/WholeRows.h"

#include <algorithm>

namespace editor {

namespace {

constexpr int kRowPadding = 6;
constexpr int kFarBelow = 10000;

int widthOf(const QTableView& table, int row, int column) {
  int width = 0;
  for (int i = 0; i < table.columnSpan(row, column); ++i) {
    width += table.columnWidth(column + i);
  }
  return width;
}

}  // namespace

WholeRows::WholeRows(QAbstractItemView& list, int rowHeight, QWidget* parent)
    : QWidget(parent), list_(list), rowHeight_(rowHeight) {
  list_.setParent(this);
  setFocusProxy(&list_);
}

QSize WholeRows::sizeHint() const {
  return list_.sizeHint();
}

QSize WholeRows::minimumSizeHint() const {
  return list_.minimumSizeHint();
}

void WholeRows::resizeEvent(QResizeEvent*) {
  const int whole = height() - height() % rowHeight_;
  list_.setGeometry(0, 0, width(), std::max(whole, rowHeight_));
}

void fitRowHeights(QTableView& table, int column, int margin, int leastHeight) {
  const QAbstractItemModel& model = *table.model();
  const QFontMetrics metrics(table.font());
  for (int row = 0; row < model.rowCount(); ++row) {
    const int room = std::max(1, widthOf(table, row, column) - margin);
    const QString text = model.index(row, column).data().toString();
    int height = leastHeight;
    if (metrics.horizontalAdvance(text) > room) {
      const QRect lines(0, 0, room, kFarBelow);
      height = std::max(height,
                        metrics.boundingRect(lines, Qt::TextWordWrap, text).height() + kRowPadding);
    }
    if (table.rowHeight(row) != height) {
      table.setRowHeight(row, height);
    }
  }
}

}  // namespace editor

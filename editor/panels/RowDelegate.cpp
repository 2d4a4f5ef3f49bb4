#include "editor/panels/RowDelegate.h"

#include <algorithm>

namespace editor {

namespace {

constexpr int kTextGap = 8;
constexpr int kFarBelow = 10000;

int widthOf(const QTableView& table, int row, int column) {
  int width = 0;
  for (int i = 0; i < table.columnSpan(row, column); ++i) {
    width += table.columnWidth(column + i);
  }
  return width;
}

}  // namespace

QSize RowDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  return {QStyledItemDelegate::sizeHint(option, index).width(), kListRowHeight};
}

void RowDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const {
  QStyleOptionViewItem row = option;
  initStyleOption(&row, index);
  if (isHeading(index) || option.state.testFlag(QStyle::State_Selected)) {
    row.font.setWeight(QFont::DemiBold);
    row.fontMetrics = QFontMetrics(row.font);
  }
  const QColor pale = option.palette.color(QPalette::PlaceholderText);
  if (isDimmed(index)) {
    row.palette.setColor(QPalette::Text, pale);
    row.palette.setColor(QPalette::HighlightedText, pale);
  }
  const int margin = rightMargin(option, index);
  const int icon = row.icon.isNull() ? 0 : 24;
  const int room = option.rect.width() - margin - kTextGap - icon;
  const int nameWidth = std::min(row.fontMetrics.horizontalAdvance(row.text), room);
  const QString side = option.fontMetrics.elidedText(
      sideText(index), Qt::ElideMiddle, std::max(room - nameWidth - kTextGap, room / 3));
  const int sideWidth = option.fontMetrics.horizontalAdvance(side);
  row.text = row.fontMetrics.elidedText(row.text, Qt::ElideMiddle,
                                        std::max(room - sideWidth - kTextGap, kTextGap));
  const QStyle* style = option.widget != nullptr ? option.widget->style() : nullptr;
  if (style != nullptr) {
    style->drawControl(QStyle::CE_ItemViewItem, &row, painter, option.widget);
  }
  painter->save();
  painter->setFont(option.font);
  painter->setPen(pale);
  painter->drawText(option.rect.adjusted(0, 0, -margin, 0), Qt::AlignRight | Qt::AlignVCenter,
                    side);
  painter->restore();
}

WholeRows::WholeRows(QAbstractItemView& list, QWidget* parent) : QWidget(parent), list_(list) {
  list_.setParent(this);
  setFocusProxy(&list_);
}

void WholeRows::resizeEvent(QResizeEvent*) {
  const int whole = height() - height() % kListRowHeight;
  list_.setGeometry(0, 0, width(), std::max(whole, kListRowHeight));
}

void styleList(QAbstractItemView& list, const QString& name) {
  list.setFrameShape(QFrame::NoFrame);
  list.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list.setTextElideMode(Qt::ElideMiddle);  // The ends of names and paths tell them apart.
  list.viewport()->setAutoFillBackground(false);
  list.setAccessibleName(name);
}

void styleTable(QTableView& table, const QString& name) {
  styleList(table, name);
  table.setShowGrid(false);
  table.setTabKeyNavigation(false);  // Tab leaves the table.
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.horizontalHeader()->setTextElideMode(Qt::ElideMiddle);
  table.horizontalHeader()->setHighlightSections(false);  // Titles keep their width.
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(kListRowHeight);
}

void fitRowHeights(QTableView& table, int column, int margin) {
  const QAbstractItemModel& model = *table.model();
  const QFontMetrics metrics(table.font());
  for (int row = 0; row < model.rowCount(); ++row) {
    const int room = std::max(1, widthOf(table, row, column) - margin);
    const QString text = model.index(row, column).data().toString();
    int height = kListRowHeight;
    if (metrics.horizontalAdvance(text) > room) {
      const QRect lines(0, 0, room, kFarBelow);
      height = std::max(
          height, metrics.boundingRect(lines, Qt::TextWordWrap, text).height() + kListRowPadding);
    }
    if (table.rowHeight(row) != height) {
      table.setRowHeight(row, height);
    }
  }
}

}  // namespace editor

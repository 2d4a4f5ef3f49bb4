#include "editor/panels/RowDelegate.h"

#include <algorithm>

#include <QPainter>

namespace editor {

namespace {

constexpr int kRowHeight = 24;
constexpr int kGap = 8;

}  // namespace

RowDelegate::RowDelegate(const Theme& theme, QObject* parent)
    : QStyledItemDelegate(parent), theme_(theme) {}

QString RowDelegate::sideText(const QModelIndex& index) const {
  return index.data(kSideTextRole).toString();
}

QSize RowDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  return {QStyledItemDelegate::sizeHint(option, index).width(), kRowHeight};
}

void RowDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const {
  QStyleOptionViewItem row = option;
  initStyleOption(&row, index);
  if (isHeading(index) || option.state.testFlag(QStyle::State_Selected)) {
    row.font.setWeight(QFont::DemiBold);
    row.fontMetrics = QFontMetrics(row.font);
  }
  if (isPale(index)) {
    row.palette.setColor(QPalette::Text, theme_.color(Role::TextSecondary));
    row.palette.setColor(QPalette::HighlightedText, theme_.color(Role::TextSecondary));
  }
  const int margin = rightMargin(option, index);
  const int icon = row.icon.isNull() ? 0 : 24;
  const int room = option.rect.width() - margin - kGap - icon;
  const int nameWidth = std::min(row.fontMetrics.horizontalAdvance(row.text), room);
  const QString side = option.fontMetrics.elidedText(sideText(index), Qt::ElideRight,
                                                     std::max(room - nameWidth - kGap, room / 3));
  const int sideWidth = option.fontMetrics.horizontalAdvance(side);
  row.text =
      row.fontMetrics.elidedText(row.text, Qt::ElideRight, std::max(room - sideWidth - kGap, kGap));
  const QStyle* style = option.widget != nullptr ? option.widget->style() : nullptr;
  if (style != nullptr) {
    style->drawControl(QStyle::CE_ItemViewItem, &row, painter, option.widget);
  }
  painter->save();
  painter->setFont(option.font);
  painter->setPen(theme_.color(Role::TextSecondary));
  painter->drawText(option.rect.adjusted(0, 0, -margin, 0), Qt::AlignRight | Qt::AlignVCenter,
                    side);
  painter->restore();
}

}  // namespace editor

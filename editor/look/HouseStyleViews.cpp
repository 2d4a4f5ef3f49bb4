#include <algorithm>

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QListView>
#include <QPainter>
#include <QStyleOption>
#include <QTableView>
#include <QTreeView>

#include "editor/look/HouseStyle.h"

namespace editor {

namespace {

constexpr double kRowRadius = 4.0;
constexpr double kFocusRingPx = 1.5;

bool isUnderMouse(const QStyleOption& option) {
  return option.state.testFlag(QStyle::State_Enabled) &&
         option.state.testFlag(QStyle::State_MouseOver);
}

}  // namespace

bool endsTableRow(const QStyleOption* option, const QWidget* widget) {
  const auto* table = qobject_cast<const QTableView*>(widget);
  const auto* item = qstyleoption_cast<const QStyleOptionViewItem*>(option);
  if (table == nullptr || item == nullptr || !item->index.isValid()) {
    return false;
  }
  const int column = item->index.column();
  return column + table->columnSpan(item->index.row(), column) ==
         item->index.model()->columnCount();
}

/// Marks keep their colour in selected rows.
QPixmap HouseStyle::generatedIconPixmap(QIcon::Mode mode, const QPixmap& pixmap,
                                        const QStyleOption* option) const {
  return mode == QIcon::Selected ? pixmap : QProxyStyle::generatedIconPixmap(mode, pixmap, option);
}

QRect HouseStyle::subElementRect(SubElement element, const QStyleOption* option,
                                 const QWidget* widget) const {
  QRect rect = QProxyStyle::subElementRect(element, option, widget);
  switch (element) {
    case SE_LineEditContents: {
      const bool alone =
          widget == nullptr || qobject_cast<QAbstractSpinBox*>(widget->parentWidget()) == nullptr;
      return alone ? rect.adjusted(4, 0, -2, 0) : rect;
    }
    case SE_ItemViewItemText:
      rect.adjust(0, 0, endsTableRow(option, widget) ? -kTableInset : 0, 0);
      [[fallthrough]];
    case SE_ItemViewItemDecoration:
      if (const auto* item = qstyleoption_cast<const QStyleOptionViewItem*>(option);
          item != nullptr && item->index.column() == 0) {
        const int inset = qobject_cast<const QTableView*>(widget) != nullptr  ? kTableInset
                          : qobject_cast<const QListView*>(widget) != nullptr ? kListInset
                                                                              : 0;
        return element == SE_ItemViewItemText ? rect.adjusted(inset, 0, 0, 0)
                                              : rect.translated(inset, 0);
      }
      return rect;
    default:
      return rect;
  }
}

bool HouseStyle::drawFrame(PrimitiveElement element, const QStyleOption& option, QPainter& painter,
                           const QWidget* widget) const {
  if (element == PE_FrameFocusRect) {
    if (qobject_cast<const QAbstractItemView*>(widget) == nullptr) {  // rows are tinted instead
      drawFocusRing(painter, option, QRectF(option.rect));
    }
    return true;
  }
  const bool isTip = element == PE_PanelTipLabel;  // else a list or a text
  painter.setPen(theme_.color(Role::FieldEdge));
  painter.setBrush(isTip ? QBrush(theme_.color(Role::Panel)) : option.palette.base());
  painter.setRenderHint(QPainter::Antialiasing);  // whole at 1.25 pixels per point, too
  painter.drawRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5));
  return true;
}

void HouseStyle::drawFocusRing(QPainter& painter, const QStyleOption& option,
                               const QRectF& rect) const {
  if (!option.state.testFlag(State_HasFocus) && option.type != QStyleOption::SO_FocusRect) {
    return;
  }
  if (option.state.testFlag(State_KeyboardFocusChange)) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme_.color(Role::Accent), kFocusRingPx));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(rect.adjusted(kFocusRingPx, kFocusRingPx, -kFocusRingPx, -kFocusRingPx),
                            kRowRadius, kRowRadius);
  }
}

void HouseStyle::drawTab(QPainter& painter, const QStyleOption& option) const {
  painter.fillRect(option.rect, theme_.color(Role::Window));
  const QRect bottom(option.rect.left(), option.rect.bottom(), option.rect.width(), 1);
  painter.fillRect(bottom, theme_.color(Role::Line));
  if (option.state.testFlag(State_Selected)) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme_.color(Role::Accent));
    painter.drawRoundedRect(
        QRectF(option.rect.left() + 10, option.rect.bottom() - 1.5, option.rect.width() - 20, 2.5),
        1.2, 1.2);
  } else if (isUnderMouse(option)) {
    painter.fillRect(option.rect.adjusted(0, 0, 0, -1), theme_.color(Role::RowHover));
  }
}

void HouseStyle::drawRow(QPainter& painter, const QStyleOption& option,
                         const QWidget* widget) const {
  const auto* item = qstyleoption_cast<const QStyleOptionViewItem*>(&option);
  const bool selected = option.state.testFlag(State_Selected);
  if (item == nullptr || (!selected && !isUnderMouse(option))) {
    return;
  }
  // One band over all columns, rounded only at its ends. Tables do not say where a cell is.
  using Place = QStyleOptionViewItem::ViewItemPosition;
  bool first = item->viewItemPosition != Place::Middle && item->viewItemPosition != Place::End;
  bool last = item->viewItemPosition != Place::Middle && item->viewItemPosition != Place::Beginning;
  if (qobject_cast<const QTableView*>(widget) != nullptr && item->index.isValid()) {
    first = item->index.column() == 0;
    last = endsTableRow(&option, widget);
  }
  QRectF band(option.rect);
  const bool leaf = item->index.isValid() && !item->index.model()->hasChildren(item->index);
  if (first && leaf && qobject_cast<const QTreeView*>(widget) != nullptr) {
    band.setLeft(0.0);  // under the empty place of the branch as well
  }
  painter.setClipRect(band);
  band.adjust(first ? 4.0 : -8.0, 0.0, last ? -4.0 : 8.0, 0.0);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme_.color(selected ? Role::RowSelected : Role::RowHover));
  painter.drawRoundedRect(band, kRowRadius, kRowRadius);
}

void HouseStyle::drawScrollBar(QPainter& painter, const QStyleOptionComplex& option,
                               const QWidget* widget) const {
  const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(&option);
  if (bar == nullptr || bar->minimum == bar->maximum) {
    return;
  }
  QRectF handle = subControlRect(CC_ScrollBar, bar, SC_ScrollBarSlider, widget);
  const double inset = 2.5;
  handle.adjust(inset, inset, -inset, -inset);
  const double radius = std::min(handle.width(), handle.height()) / 2.0;
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme_.color(isUnderMouse(option) ? Role::ObstacleEdge : Role::FieldEdge));
  painter.drawRoundedRect(handle, radius, radius);
}

}  // namespace editor

#include <algorithm>

#include "editor/look/AppStyle.h"
#include "editor/look/FigurePainter.h"

// Drawing functions of AppStyle and the geometry of sub-controls.
namespace editor {

namespace {

constexpr double kRowRadius = 4.0;
constexpr double kFocusRingPx = 1.5;
constexpr double kFieldRadius = 4.0;
constexpr double kButtonRadius = 6.0;
constexpr int kStepWidth = 18;

QRectF onPixels(const QRect& rect) {
  return QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5);
}

bool isEnabled(const QStyleOption& option) {
  return option.state.testFlag(QStyle::State_Enabled);
}

bool isHovered(const QStyleOption& option) {
  return isEnabled(option) && option.state.testFlag(QStyle::State_MouseOver);
}

/// A rounded rectangle.
void drawBox(QPainter& painter, const QRectF& rect, double radius, const QBrush& fill,
             const QPen& edge = QPen(Qt::NoPen)) {
  painter.setRenderHint(QPainter::Antialiasing);
  setPenAndBrush(painter, edge, fill);
  painter.drawRoundedRect(rect, radius, radius);
}

/// Inset of the first column of a list or table [px].
int firstColumnInset(const QWidget* widget) {
  if (qobject_cast<const QTableView*>(widget) != nullptr) {
    return kTableInset;
  }
  return qobject_cast<const QListView*>(widget) != nullptr ? kListInset : 0;
}

}  // namespace

void AppStyle::drawFieldFrame(QPainter& painter, const QStyleOption& option,
                              const QWidget* widget) const {
  const bool invalid = widget != nullptr && widget->property(kInvalidProperty).toBool();
  const bool focused = option.state.testFlag(State_HasFocus) && isEnabled(option);
  const Role edge = invalid             ? Role::Error
                    : focused           ? Role::Accent
                    : isHovered(option) ? Role::ObstacleEdge
                                        : Role::FieldEdge;
  if (isInPlaceEditor(widget)) {  // also hides the row at the rounded corners
    painter.fillRect(option.rect, theme_.color(Role::Field));
  }
  drawBox(painter, onPixels(option.rect), kFieldRadius,
          theme_.color(isEnabled(option) ? Role::Field : Role::Window),
          QPen(theme_.color(edge), focused || invalid ? 1.5 : 1.0));
}

void AppStyle::drawChevron(QPainter& painter, const QRectF& rect, int quarterTurns,
                           bool enabled) const {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(rect.center());
  painter.rotate(90.0 * quarterTurns);
  const QColor color = withAlpha(theme_.color(Role::TextSecondary), enabled ? 1.0 : 0.4);
  painter.setPen(QPen(color, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(QPolygonF({{-3.2, -1.6}, {0.0, 1.6}, {3.2, -1.6}}));
  painter.restore();
}

void AppStyle::drawIndicator(QPainter& painter, const QStyleOption& option, bool isRadio) const {
  const bool filled = !option.state.testFlag(State_Off);
  QColor fill = theme_.color(filled ? Role::Accent : Role::Field);
  QColor edge = theme_.color(filled || isHovered(option) ? Role::Accent : Role::ObstacleEdge);
  if (!isEnabled(option)) {
    fill.setAlphaF(0.4);
    edge.setAlphaF(0.4);
  }
  const QColor mark = theme_.color(Role::Field);
  if (isRadio) {
    const QPointF middle = QRectF(option.rect).center();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(edge, 1.4));  // A round edge appears paler than a straight one.
    painter.setBrush(fill);
    painter.drawEllipse(middle, 6.4, 6.4);
    if (filled) {
      setPenAndBrush(painter, Qt::NoPen, mark);
      painter.drawEllipse(middle, 2.5, 2.5);
    }
    return;
  }
  QRect square(0, 0, 14, 14);
  square.moveCenter(option.rect.center());
  drawBox(painter, onPixels(square), 3.0, fill, QPen(edge, 1.0));
  painter.setPen(QPen(mark, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.translate(square.topLeft());
  if (option.state.testFlag(State_On)) {
    painter.drawPolyline(QPolygonF({{3.6, 7.2}, {6.0, 9.8}, {10.6, 4.6}}));
  } else if (option.state.testFlag(State_NoChange)) {
    painter.drawLine(QPointF(4.0, 7.0), QPointF(10.0, 7.0));
  }
}

void AppStyle::drawButton(QPainter& painter, const QStyleOption& option) const {
  const auto* button = qstyleoption_cast<const QStyleOptionButton*>(&option);
  const bool isDefault = button != nullptr && isEnabled(option) &&
                         button->features.testFlag(QStyleOptionButton::DefaultButton);
  const bool down = option.state & (State_Sunken | State_On);
  const Role fill = down || isDefault   ? Role::RowSelected
                    : isHovered(option) ? Role::RowHover
                                        : Role::Field;
  drawBox(painter, onPixels(option.rect), kFieldRadius, theme_.color(fill),
          QPen(theme_.color(isDefault || down ? Role::Accent : Role::FieldEdge), 1.0));
  drawFocusRing(painter, option, QRectF(option.rect).adjusted(-1.0, -1.0, 1.0, 1.0));
}

void AppStyle::drawComboLabel(QPainter& painter, const QStyleOptionComboBox& combo,
                              const QWidget* widget) const {
  if (combo.editable) {
    return;
  }
  QRect text = subControlRect(CC_ComboBox, &combo, SC_ComboBoxEditField, widget);
  if (!combo.currentIcon.isNull()) {
    const QRect place(text.left(), text.center().y() - 7, 16, 16);
    combo.currentIcon.paint(&painter, place, Qt::AlignCenter,
                            isEnabled(combo) ? QIcon::Normal : QIcon::Disabled);
    text.setLeft(place.right() + 6);
  }
  drawItemText(&painter, text, Qt::AlignVCenter | Qt::AlignLeft | Qt::TextSingleLine, combo.palette,
               isEnabled(combo),
               combo.fontMetrics.elidedText(combo.currentText, Qt::ElideRight, text.width()),
               QPalette::Text);
}

QRect AppStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option,
                               SubControl sub, const QWidget* widget) const {
  const QRect rect = option->rect;
  if (control == CC_SpinBox) {
    const auto* spin = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
    const bool steps = spin == nullptr || spin->buttonSymbols != QAbstractSpinBox::NoButtons;
    const int width = steps ? kStepWidth : 4;
    const int half = rect.height() / 2;
    switch (sub) {
      case SC_SpinBoxUp:
        return steps ? QRect(rect.right() - width + 1, rect.top(), width, half) : QRect();
      case SC_SpinBoxDown:
        return steps
                   ? QRect(rect.right() - width + 1, rect.top() + half, width, rect.height() - half)
                   : QRect();
      case SC_SpinBoxEditField:
        return rect.adjusted(4, 1, -width, -1);
      default:
        return rect;
    }
  }
  if (control == CC_ComboBox) {
    switch (sub) {
      case SC_ComboBoxEditField:
        return rect.adjusted(8, 1, -22, -1);
      case SC_ComboBoxArrow:
        return {rect.right() - 21, rect.top(), 20, rect.height()};
      default:
        break;
    }
  }
  return QProxyStyle::subControlRect(control, option, sub, widget);
}

void AppStyle::drawSpinBox(QPainter& painter, const QStyleOptionSpinBox& spin,
                           const QWidget* widget) const {
  if (spin.frame || isInPlaceEditor(widget)) {
    drawFieldFrame(painter, spin, widget);
  }
  if (spin.buttonSymbols == QAbstractSpinBox::NoButtons) {
    return;
  }
  const QRectF up = subControlRect(CC_SpinBox, &spin, SC_SpinBoxUp, widget);
  const QRectF down = subControlRect(CC_SpinBox, &spin, SC_SpinBoxDown, widget);
  const bool enabled = isEnabled(spin);
  drawChevron(painter, up.translated(-1.0, 1.0), 2,
              enabled && spin.stepEnabled.testFlag(QAbstractSpinBox::StepUpEnabled));
  drawChevron(painter, down.translated(-1.0, -1.0), 0,
              enabled && spin.stepEnabled.testFlag(QAbstractSpinBox::StepDownEnabled));
}

void AppStyle::drawSlider(QPainter& painter, const QStyleOptionSlider& slider,
                          const QWidget* widget) const {
  const QRectF handle = subControlRect(CC_Slider, &slider, SC_SliderHandle, widget);
  const double y = slider.rect.center().y() + 0.5;
  const double alpha = isEnabled(slider) ? 1.0 : 0.4;
  const double left = slider.rect.left() + 1.0;
  const double right = slider.rect.right();
  painter.setPen(QPen(theme_.color(Role::Line, alpha), 3.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(left, y), QPointF(right, y));
  if (!slider.subControls.testFlag(SC_SliderHandle)) {  // of several values
    return;
  }
  painter.setPen(QPen(theme_.color(Role::Accent, alpha), 3.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(left, y), QPointF(handle.center().x(), y));
  setPenAndBrush(painter, QPen(theme_.color(Role::Accent, alpha), 2.0),
                 theme_.color(isHovered(slider) ? Role::RowSelected : Role::Field));
  painter.drawEllipse(QPointF(handle.center().x(), y), 5.5, 5.5);
  drawFocusRing(painter, slider, QRectF(slider.rect));
}

void AppStyle::drawToolButton(QPainter& painter, const QStyleOptionToolButton& button,
                              const QWidget* widget) const {
  const bool link = widget != nullptr && widget->property(kLinkProperty).toBool();
  const bool isChecked = button.state & State_On;
  const bool on = isChecked || button.state & State_Sunken;
  if (link ? isChecked : on || isHovered(button)) {
    drawBox(painter, link ? onPixels(button.rect) : QRectF(button.rect), kButtonRadius,
            theme_.color(on ? Role::RowSelected : Role::RowHover),
            link ? QPen(theme_.color(Role::Accent), 1.0) : QPen(Qt::NoPen));
  }
  drawFocusRing(painter, button, QRectF(button.rect));
  if (widget != nullptr && widget->objectName() == QLatin1String("qt_toolbar_ext_button")) {
    constexpr double kApart = 2.5;  // From the centre to each chevron [px].
    for (const double x : {-kApart, kApart}) {
      drawChevron(painter, QRectF(button.rect).translated(x, 0.0), 3, true);
    }
    return;  // Qt's icon is black in every theme.
  }
  QStyleOptionToolButton label = button;
  label.state &= ~(State_Sunken | State_Raised);
  if (link) {
    QFont font = button.font;
    font.setUnderline(isHovered(button));
    painter.setFont(font);
    painter.setPen(isEnabled(button) ? theme_.color(isChecked ? Role::Text : Role::AccentText)
                                     : theme_.palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(button.rect, Qt::AlignCenter, button.text);
    return;
  }
  if (button.features.testFlag(QStyleOptionToolButton::HasMenu) &&
      button.toolButtonStyle != Qt::ToolButtonIconOnly) {
    label.rect.setRight(label.rect.right() - 16);
    drawChevron(painter,
                QRectF(button.rect.right() - 18, button.rect.top(), 14, button.rect.height()), 0,
                isEnabled(button));
  }
  if (button.features.testFlag(QStyleOptionToolButton::MenuButtonPopup)) {
    const QRect arrow = subControlRect(CC_ToolButton, &button, SC_ToolButtonMenu, widget);
    label.rect.setRight(arrow.left());
    drawChevron(painter, QRectF(arrow).adjusted(-2.0, 1.0, -2.0, 1.0), 0, isEnabled(button));
  }
  drawControl(CE_ToolButtonLabel, &label, &painter, widget);
}

/// A flat bar: its ground, or the filled part, which is a third of it if the end is unknown.
void AppStyle::drawProgress(QPainter& painter, const QStyleOptionProgressBar& bar,
                            bool isFilled) const {
  constexpr double kUnknown = 1.0 / 3.0;
  const int span = bar.maximum - bar.minimum;
  const double share = !isFilled ? 1.0
                       : span <= 0
                           ? kUnknown
                           : std::clamp(double(bar.progress - bar.minimum) / span, 0.0, 1.0);
  QRectF place(bar.rect);
  place.setWidth(share * place.width());
  const double radius = 0.5 * std::min(place.height(), place.width());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme_.color(isFilled ? Role::Accent : Role::Line));
  painter.drawRoundedRect(place, radius, radius);
}

bool isInPlaceEditor(const QWidget* widget) {
  const QWidget* const parent = widget == nullptr ? nullptr : widget->parentWidget();
  const auto* const view =
      parent == nullptr ? nullptr : qobject_cast<const QAbstractItemView*>(parent->parentWidget());
  return view != nullptr && view->viewport() == parent;
}

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

bool endsTreeRow(const QStyleOption& cell, const QWidget* widget) {
  const auto* item = qstyleoption_cast<const QStyleOptionViewItem*>(&cell);
  return item != nullptr && qobject_cast<const QTreeView*>(widget) != nullptr &&
         item->index.column() > 0 && (item->displayAlignment & Qt::AlignRight) &&
         item->index.column() + 1 == item->index.model()->columnCount();
}

bool endsTreeRow(const QStyleOptionHeader& heading, const QWidget* header) {
  const auto* view = qobject_cast<const QHeaderView*>(header);
  return view != nullptr && qobject_cast<const QTreeView*>(view->parentWidget()) != nullptr &&
         heading.section > 0 && heading.section + 1 == view->count() &&
         (heading.textAlignment & Qt::AlignRight);
}

bool followsNumbers(const QStyleOption& cell) {
  const auto* item = qstyleoption_cast<const QStyleOptionViewItem*>(&cell);
  if (item == nullptr || item->index.column() < 1 || item->displayAlignment & Qt::AlignRight) {
    return false;
  }
  const QModelIndex before = item->index.sibling(item->index.row(), item->index.column() - 1);
  return (before.data(Qt::TextAlignmentRole).toInt() & Qt::AlignRight) != 0;
}

bool followsNumbers(const QStyleOptionHeader& heading, const QWidget* header) {
  const auto* view = qobject_cast<const QHeaderView*>(header);
  if (view == nullptr || view->model() == nullptr || heading.section < 1 ||
      heading.orientation != Qt::Horizontal || heading.textAlignment & Qt::AlignRight) {
    return false;
  }
  const QVariant own =
      view->model()->headerData(heading.section - 1, Qt::Horizontal, Qt::TextAlignmentRole);
  const int before = own.isValid() ? own.toInt() : int(view->defaultAlignment());
  return (before & Qt::AlignRight) != 0;
}

/// Keeps the colours of marks in selected rows.
QPixmap AppStyle::generatedIconPixmap(QIcon::Mode mode, const QPixmap& pixmap,
                                      const QStyleOption* option) const {
  return mode == QIcon::Selected ? pixmap : QProxyStyle::generatedIconPixmap(mode, pixmap, option);
}

QRect AppStyle::subElementRect(SubElement element, const QStyleOption* option,
                               const QWidget* widget) const {
  QRect rect = QProxyStyle::subElementRect(element, option, widget);
  switch (element) {
    case SE_LineEditContents: {
      const bool alone =
          widget == nullptr || qobject_cast<QAbstractSpinBox*>(widget->parentWidget()) == nullptr;
      return alone ? rect.adjusted(4, 0, -2, 0) : rect;
    }
    case SE_ItemViewItemText:
      rect.adjust(
          option != nullptr && followsNumbers(*option) ? kColumnGap : 0, 0,
          endsTableRow(option, widget) || (option != nullptr && endsTreeRow(*option, widget))
              ? -kTableInset
              : 0,
          0);
      [[fallthrough]];
    case SE_ItemViewItemDecoration:
      if (const auto* item = qstyleoption_cast<const QStyleOptionViewItem*>(option);
          item != nullptr && item->index.column() == 0) {
        const int inset = firstColumnInset(widget);
        return element == SE_ItemViewItemText ? rect.adjusted(inset, 0, 0, 0)
                                              : rect.translated(inset, 0);
      }
      return rect;
    default:
      return rect;
  }
}

void AppStyle::drawFrame(PrimitiveElement element, const QStyleOption& option, QPainter& painter,
                         const QWidget* widget) const {
  if (element == PE_FrameFocusRect) {
    if (qobject_cast<const QAbstractItemView*>(widget) == nullptr) {  // Rows are tinted instead.
      drawFocusRing(painter, option, QRectF(option.rect));
    }
    return;
  }
  const bool isTip = element == PE_PanelTipLabel;  // Otherwise a list or a text.
  setPenAndBrush(painter, theme_.color(Role::FieldEdge),
                 isTip ? QBrush(theme_.color(Role::Panel)) : option.palette.base());
  painter.setRenderHint(QPainter::Antialiasing);  // Draws complete edges at a pixel ratio of 1.25.
  painter.drawRect(onPixels(option.rect));
}

void AppStyle::drawFocusRing(QPainter& painter, const QStyleOption& option,
                             const QRectF& rect) const {
  if (!option.state.testFlag(State_HasFocus) && option.type != QStyleOption::SO_FocusRect) {
    return;
  }
  if (option.state.testFlag(State_KeyboardFocusChange)) {
    drawBox(painter, rect.adjusted(kFocusRingPx, kFocusRingPx, -kFocusRingPx, -kFocusRingPx),
            kRowRadius, Qt::NoBrush, QPen(theme_.color(Role::Accent), kFocusRingPx));
  }
}

void AppStyle::drawTab(QPainter& painter, const QStyleOption& option) const {
  painter.fillRect(option.rect, theme_.color(Role::Window));
  const QRect bottom(option.rect.left(), option.rect.bottom(), option.rect.width(), 1);
  painter.fillRect(bottom, theme_.color(Role::Line));
  if (option.state.testFlag(State_Selected)) {
    drawBox(
        painter,
        QRectF(option.rect.left() + 10, option.rect.bottom() - 1.5, option.rect.width() - 20, 2.5),
        1.2, theme_.color(Role::Accent));
  } else if (isHovered(option)) {
    painter.fillRect(option.rect.adjusted(0, 0, 0, -1), theme_.color(Role::RowHover));
  }
  drawFocusRing(painter, option, QRectF(option.rect).adjusted(3.0, 3.0, -3.0, -4.0));
}

void AppStyle::drawRow(QPainter& painter, const QStyleOption& option, const QWidget* widget) const {
  const auto* item = qstyleoption_cast<const QStyleOptionViewItem*>(&option);
  const bool selected = option.state.testFlag(State_Selected);
  if (item == nullptr || (!selected && !isHovered(option))) {
    return;
  }
  // Draws one band over all columns, rounded at its ends only. The option of a table does not
  // contain the position of a cell in its row.
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
    band.setLeft(0.0);  // The band includes the indentation of the branch.
  }
  painter.setClipRect(band);
  band.adjust(first ? 4.0 : -8.0, 0.0, last ? -4.0 : 8.0, 0.0);
  drawBox(painter, band, kRowRadius, theme_.color(selected ? Role::RowSelected : Role::RowHover));
}

void AppStyle::drawScrollBar(QPainter& painter, const QStyleOptionSlider& bar,
                             const QWidget* widget) const {
  if (bar.minimum == bar.maximum) {
    return;
  }
  QRectF handle = subControlRect(CC_ScrollBar, &bar, SC_ScrollBarSlider, widget);
  const double inset = 2.5;
  handle.adjust(inset, inset, -inset, -inset);
  const double radius = std::min(handle.width(), handle.height()) / 2.0;
  drawBox(painter, handle, radius,
          theme_.color(isHovered(bar) ? Role::ObstacleEdge : Role::FieldEdge));
}

}  // namespace editor

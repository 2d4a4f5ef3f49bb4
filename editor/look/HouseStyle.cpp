#include "editor/look/HouseStyle.h"

#include <algorithm>

#include <QAbstractScrollArea>
#include <QListView>
#include <QPainter>
#include <QStyleOption>
#include <QStyleOptionComboBox>
#include <QToolBar>

namespace editor {

namespace {

constexpr int kFieldHeight = 24;
constexpr int kRowHeight = 24;
constexpr int kTabHeight = 32;
constexpr int kToolButton = 32;
constexpr int kComboFrame = 34;  // what stands around the text of a combo box

void drawRadioButton(QPainter& painter, const QStyleOption& option, const Theme& theme) {
  const bool enabled = option.state.testFlag(QStyle::State_Enabled);
  const bool hovered = enabled && option.state.testFlag(QStyle::State_MouseOver);
  const bool chosen = option.state.testFlag(QStyle::State_On);
  QColor fill = theme.color(chosen ? Role::Accent : Role::Field);
  QColor edge = theme.color(chosen || hovered ? Role::Accent : Role::ObstacleEdge);
  if (!enabled) {
    fill.setAlphaF(0.4);
    edge.setAlphaF(0.4);
  }
  const QPointF middle = QRectF(option.rect).center();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(edge, 1.4));  // a round edge is paler than a straight one
  painter.setBrush(fill);
  painter.drawEllipse(middle, 6.4, 6.4);
  if (chosen) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.color(Role::Field));
    painter.drawEllipse(middle, 2.5, 2.5);
  }
}

}  // namespace

HouseStyle::HouseStyle(const Theme& theme) : QProxyStyle(QStringLiteral("Fusion")), theme_(theme) {}

int HouseStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                            const QWidget* widget) const {
  switch (metric) {
    case PM_DefaultFrameWidth:  // of a list: on screens of 1.25 pixels per point what is in it
                                // would cover parts of a line right beside it
      return qobject_cast<const QAbstractScrollArea*>(widget) != nullptr
                 ? 2
                 : QProxyStyle::pixelMetric(metric, option, widget);
    case PM_ToolBarIconSize:
    case PM_MessageBoxIconSize:
      return 24;
    case PM_SmallIconSize:
    case PM_ListViewIconSize:
    case PM_ButtonIconSize:
      return 16;
    case PM_ToolBarItemSpacing:
      return 2;
    case PM_ToolBarSeparatorExtent:
      return 15;
    case PM_ToolBarItemMargin:
    case PM_ToolBarFrameWidth:
    case PM_DockWidgetFrameWidth:
    case PM_DockWidgetTitleMargin:
      return 0;
    case PM_DockWidgetSeparatorExtent:
    case PM_SplitterWidth:
      return 1;
    case PM_TabBarTabHSpace:
      return 24;
    case PM_TabBarBaseOverlap:
    case PM_TabBarTabShiftVertical:
    case PM_TabBarTabShiftHorizontal:
      return 0;
    case PM_TreeViewIndentation:
      return 16;
    case PM_ScrollBarExtent:
      return 10;
    case PM_SliderThickness:
    case PM_SliderControlThickness:
      return 16;
    case PM_SliderLength:
      return 14;
    case PM_IndicatorWidth:
    case PM_IndicatorHeight:
      return 16;
    case PM_MenuBarPanelWidth:
    case PM_MenuBarVMargin:
    case PM_MenuBarHMargin:
      return 0;
    default:
      return QProxyStyle::pixelMetric(metric, option, widget);
  }
}

int HouseStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                          QStyleHintReturn* returned) const {
  switch (hint) {
    case SH_ItemView_ShowDecorationSelected:
      return 1;
    case SH_Slider_AbsoluteSetButtons:
      return Qt::LeftButton;  // a click on the groove goes there
    case SH_UnderlineShortcut:
    case SH_EtchDisabledText:
    case SH_DitherDisabledText:
    case SH_ScrollBar_Transient:
    case SH_DialogButtonBox_ButtonsHaveIcons:  // they are not of our set
      return 0;
    case SH_TabBar_Alignment:
      return Qt::AlignLeft;
    case SH_TabBar_ElideMode:
      return Qt::ElideRight;
    case SH_ToolTip_WakeUpDelay:
      return 500;
    default:
      return QProxyStyle::styleHint(hint, option, widget, returned);
  }
}

QSize HouseStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                                   const QWidget* widget) const {
  const auto* row = qstyleoption_cast<const QStyleOptionViewItem*>(option);
  if (row != nullptr && qobject_cast<const QListView*>(widget) != nullptr) {
    QStyleOptionViewItem narrower = *row;  // its words wrap in what the inset leaves
    narrower.rect.setWidth(std::max(0, row->rect.width() - kListInset));
    return QProxyStyle::sizeFromContents(type, &narrower, size, widget)
        .expandedTo(QSize(0, kRowHeight));
  }
  QSize result = QProxyStyle::sizeFromContents(type, option, size, widget);
  switch (type) {
    case CT_ComboBox:
      result.setWidth(size.width() + kComboFrame);
      result.setHeight(kFieldHeight);
      break;
    case CT_LineEdit:
    case CT_SpinBox:
      result.setHeight(kFieldHeight);
      break;
    case CT_PushButton:
      result.setHeight(28);
      result.rwidth() += 8;
      break;
    case CT_TabBarTab:
      result.setHeight(kTabHeight);
      break;
    case CT_ItemViewItem:
      result.setHeight(std::max(result.height(), kRowHeight));
      result.rwidth() += endsTableRow(option, widget) ? kTableInset : 0;
      break;
    case CT_ToolButton:
      if (widget != nullptr && widget->property(kLinkProperty).toBool()) {
        result.setWidth(size.width() + 2);
      } else if (widget != nullptr && qobject_cast<QToolBar*>(widget->parentWidget()) != nullptr) {
        result = result.expandedTo(QSize(kToolButton, kToolButton));
        result.setHeight(kToolButton);
      }
      break;
    case CT_MenuItem:
      if (const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
          item != nullptr && item->menuItemType != QStyleOptionMenuItem::Separator) {
        result.setHeight(std::max(result.height(), 26));
        result.rwidth() += 12;
      }
      break;
    case CT_MenuBarItem:
      result.setHeight(28);
      break;
    default:
      break;
  }
  return result;
}

bool HouseStyle::drawSimple(PrimitiveElement element, const QStyleOption& option, QPainter& painter,
                            const QWidget* widget) const {
  switch (element) {
    case PE_PanelLineEdit:
    case PE_FrameLineEdit:
      if (const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(&option);
          frame != nullptr && frame->lineWidth > 0) {
        drawFieldFrame(painter, option, widget);
      }
      return true;
    case PE_Frame:
    case PE_PanelTipLabel:
    case PE_FrameFocusRect:
      return drawFrame(element, option, painter, widget);
    case PE_IndicatorRadioButton:
      drawRadioButton(painter, option, theme_);
      return true;
    case PE_IndicatorCheckBox:
    case PE_IndicatorItemViewItemCheck:
      drawCheckBox(painter, option);
      return true;
    case PE_PanelItemViewItem:
      drawRow(painter, option, widget);
      return true;
    case PE_FrameTabBarBase:  // the line under the tabs goes on to the end of the bar
      painter.fillRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1,
                       theme_.color(Role::Line));
      return true;
    case PE_PanelItemViewRow:
    case PE_PanelMenuBar:
    case PE_FrameStatusBarItem:
    case PE_IndicatorToolBarHandle:
    case PE_FrameDockWidget:
      return true;  // nothing is drawn
    case PE_PanelButtonCommand:
      drawButton(painter, option);
      return true;
    case PE_IndicatorBranch:
      if (option.state.testFlag(State_Children)) {
        drawChevron(painter, QRectF(option.rect), option.state.testFlag(State_Open) ? 0 : 3, true);
      }
      return true;
    case PE_IndicatorArrowDown:
    case PE_IndicatorArrowRight:
      drawChevron(painter, QRectF(option.rect), element == PE_IndicatorArrowDown ? 0 : 3, true);
      return true;
    case PE_IndicatorToolBarSeparator: {
      const int x = option.rect.center().x();
      const int y = option.rect.center().y();
      painter.fillRect(QRect(x, y - 10, 1, 20), theme_.color(Role::Line));
      return true;
    }
    case PE_IndicatorDockWidgetResizeHandle:
      painter.fillRect(option.rect, theme_.color(Role::Line));
      return true;
    default:
      return false;
  }
}

void HouseStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                               QPainter* painter, const QWidget* widget) const {
  painter->save();
  const bool drawn = drawSimple(element, *option, *painter, widget);
  painter->restore();
  if (!drawn) {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
  }
}

void HouseStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                             const QWidget* widget) const {
  painter->save();
  bool drawn = true;
  switch (element) {
    case CE_TabBarTabShape:
      drawTab(*painter, *option);
      break;
    case CE_ComboBoxLabel:
      drawComboLabel(*painter, *option, widget);
      break;
    case CE_ToolBar:
      painter->fillRect(option->rect, theme_.color(Role::Window));
      break;
    case CE_MenuBarEmptyArea:
      painter->fillRect(option->rect, theme_.color(Role::Window));
      break;
    case CE_HeaderSection:
    case CE_HeaderEmptyArea:
      painter->fillRect(option->rect, theme_.color(Role::Panel));
      painter->fillRect(QRect(option->rect.left(), option->rect.bottom(), option->rect.width(), 1),
                        theme_.color(Role::Line));
      break;
    case CE_HeaderLabel: {
      const auto* header = qstyleoption_cast<const QStyleOptionHeader*>(option);
      drawn = header != nullptr && header->section == 0;
      if (drawn) {  // in line with the cells below
        QStyleOptionHeader label = *header;
        label.rect.adjust(kTableInset, 0, 0, 0);
        QProxyStyle::drawControl(element, &label, painter, widget);
      }
      break;
    }
    case CE_Splitter:
      painter->fillRect(option->rect, theme_.color(Role::Line));
      break;
    case CE_MenuBarItem:
      if (const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option)) {
        painter->fillRect(option->rect, theme_.color(Role::Window));
        if (option->state.testFlag(State_Selected)) {
          painter->setRenderHint(QPainter::Antialiasing);
          painter->setPen(Qt::NoPen);
          painter->setBrush(theme_.color(Role::RowSelected));
          painter->drawRoundedRect(QRectF(option->rect).adjusted(1, 2, -1, -2), 4, 4);
        }
        drawItemText(painter, option->rect,
                     Qt::AlignCenter | Qt::TextHideMnemonic | Qt::TextSingleLine, item->palette,
                     option->state.testFlag(State_Enabled), item->text, QPalette::WindowText);
      }
      break;
    default:
      drawn = false;
  }
  painter->restore();
  if (!drawn) {
    QProxyStyle::drawControl(element, option, painter, widget);
  }
}

void HouseStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                    QPainter* painter, const QWidget* widget) const {
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  bool drawn = true;
  switch (control) {
    case CC_SpinBox:
      drawSpinBox(*painter, *option, widget);
      break;
    case CC_ComboBox:
      drawComboBox(*painter, *option, widget);
      break;
    case CC_Slider:
      drawSlider(*painter, *option, widget);
      break;
    case CC_ToolButton:
      drawToolButton(*painter, *option, widget);
      break;
    case CC_ScrollBar:
      drawScrollBar(*painter, *option, widget);
      break;
    default:
      drawn = false;
  }
  painter->restore();
  if (!drawn) {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
  }
}

}  // namespace editor

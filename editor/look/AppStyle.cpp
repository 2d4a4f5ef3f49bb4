#include "editor/look/AppStyle.h"

#include <algorithm>
#include <map>

#include "editor/look/FigurePainter.h"
#include "editor/look/FocusFrames.h"
#include "editor/look/Icons.h"
#include "editor/look/WrappedToolTips.h"

namespace editor {

namespace {

constexpr int kFieldHeight = 24;
constexpr int kRowHeight = 24;
constexpr int kTabHeight = 32;
constexpr int kToolButton = 32;
constexpr int kFocusFrameWidth = 2;
constexpr int kHeadingGap = 8;   // Between the headings of a table [px].
constexpr int kComboFrame = 34;  // Space around the text of a combo box.

/// Mirrored horizontally.
QIcon mirrored(const QIcon& icon) {
  constexpr int kSize = 48;
  QIcon result;
  for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Disabled}) {
    const QPixmap pixmap = icon.pixmap(QSize(kSize, kSize), mode);
    result.addPixmap(pixmap.transformed(QTransform().scale(-1.0, 1.0)), mode);
  }
  return result;
}

}  // namespace

QString withReservedDigits(const QString& text) {
  static const QRegularExpression kCount(QStringLiteral("  \\d{1,3}$"));
  QString reserved = text;
  return reserved.replace(kCount, QStringLiteral("  888"));
}

void applyTheme(const Theme& theme) {
  if (auto* style = qobject_cast<AppStyle*>(QApplication::style())) {
    style->setTheme(theme);
  } else {
    QApplication::setStyle(new AppStyle(theme));
    // The application owns its style: NOLINTNEXTLINE(clang-analyzer-cplusplus.NewDeleteLeaks)
    qApp->installEventFilter(new WrappedToolTips(qApp));
    // NOLINTNEXTLINE(clang-analyzer-cplusplus.NewDeleteLeaks)
    qApp->installEventFilter(new FocusFrames(qApp));
  }
  // The application owns its style: NOLINTNEXTLINE(clang-analyzer-cplusplus.NewDeleteLeaks)
  QApplication::setFont(theme.font());
  QApplication::setPalette(theme.palette());
  for (const char* field : {"QLineEdit", "QTextEdit", "QPlainTextEdit"}) {
    QApplication::setPalette(theme.textPalette(), field);
  }
}

AppStyle::AppStyle(const Theme& theme) : QProxyStyle(QStringLiteral("Fusion")), theme_(theme) {}

int AppStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                          const QWidget* widget) const {
  static const std::map<PixelMetric, int> kOwn = {{PM_ToolBarIconSize, 24},
                                                  {PM_MessageBoxIconSize, 24},
                                                  {PM_SmallIconSize, 16},
                                                  {PM_ListViewIconSize, 16},
                                                  {PM_ButtonIconSize, 16},
                                                  {PM_ToolBarItemSpacing, 2},
                                                  {PM_ToolBarSeparatorExtent, 15},
                                                  {PM_ToolBarItemMargin, 0},
                                                  {PM_ToolBarFrameWidth, 0},
                                                  {PM_DockWidgetFrameWidth, 0},
                                                  {PM_DockWidgetTitleMargin, 0},
                                                  {PM_DockWidgetSeparatorExtent, 1},
                                                  {PM_SplitterWidth, 1},
                                                  {PM_TabBarTabHSpace, 24},
                                                  {PM_TabBarBaseOverlap, 0},
                                                  {PM_TabBarTabShiftVertical, 0},
                                                  {PM_TabBarTabShiftHorizontal, 0},
                                                  {PM_TreeViewIndentation, 16},
                                                  {PM_ScrollBarExtent, 10},
                                                  {PM_SliderThickness, 16},
                                                  {PM_SliderControlThickness, 16},
                                                  {PM_SliderLength, 14},
                                                  {PM_IndicatorWidth, 16},
                                                  {PM_IndicatorHeight, 16},
                                                  {PM_FocusFrameHMargin, 0},
                                                  {PM_FocusFrameVMargin, 0},
                                                  {PM_MenuBarPanelWidth, 0},
                                                  {PM_MenuBarVMargin, 0},
                                                  {PM_MenuBarHMargin, 0}};
  if (const auto own = kOwn.find(metric); own != kOwn.end()) {
    return own->second;
  }
  // At a pixel ratio of 1.25 the contents of a list would partly cover a one-pixel frame.
  const bool isListFrame =
      metric == PM_DefaultFrameWidth && qobject_cast<const QAbstractScrollArea*>(widget) != nullptr;
  return isListFrame ? 2 : QProxyStyle::pixelMetric(metric, option, widget);
}

int AppStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                        QStyleHintReturn* returned) const {
  static const std::map<StyleHint, int> kOwn = {
      {SH_ItemView_ShowDecorationSelected, 1},
      {SH_Slider_AbsoluteSetButtons, Qt::LeftButton},  // A click on the groove jumps there.
      {SH_UnderlineShortcut, 0},
      {SH_EtchDisabledText, 0},
      {SH_DitherDisabledText, 0},
      {SH_ScrollBar_Transient, 0},
      {SH_FocusFrame_AboveWidget, 1},
      {SH_DialogButtonBox_ButtonsHaveIcons, 0},  // The platform icons are not part of the icon set.
      {SH_TabBar_Alignment, Qt::AlignLeft},
      {SH_TabBar_ElideMode, Qt::ElideRight},
      {SH_ToolTip_WakeUpDelay, 500}};
  if (auto* mask = qstyleoption_cast<QStyleHintReturnMask*>(returned);
      hint == SH_FocusFrame_Mask && mask != nullptr && option != nullptr) {
    const int width = kFocusFrameWidth;
    mask->region = QRegion(option->rect) - option->rect.adjusted(width, width, -width, -width);
    return 1;
  }
  const auto own = kOwn.find(hint);
  return own != kOwn.end() ? own->second : QProxyStyle::styleHint(hint, option, widget, returned);
}

QSize AppStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                                 const QWidget* widget) const {
  const auto* row = qstyleoption_cast<const QStyleOptionViewItem*>(option);
  if (row != nullptr && qobject_cast<const QListView*>(widget) != nullptr) {
    QStyleOptionViewItem narrower = *row;  // The text wraps within the inset.
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
      if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option)) {
        result.rwidth() += tab->fontMetrics.horizontalAdvance(withReservedDigits(tab->text)) -
                           tab->fontMetrics.horizontalAdvance(tab->text);
      }
      break;
    case CT_ItemViewItem:
      result.setHeight(std::max(result.height(), kRowHeight));
      result.rwidth() +=
          (endsTableRow(option, widget) || endsTreeRow(*option, widget) ? kTableInset : 0) +
          (followsNumbers(*option) ? kColumnGap : 0);
      break;
    case CT_ToolButton:
      if (widget != nullptr && widget->property(kLinkProperty).toBool()) {
        constexpr int kCheckedInset = 5;  // [px]
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        const bool isCheckable = button != nullptr && button->isCheckable();
        result.setWidth(size.width() + 2 + (isCheckable ? 2 * kCheckedInset : 0));
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

/// Replaces the standard icons of message boxes and file dialogs by those of the icon set.
QIcon AppStyle::standardIcon(StandardPixmap which, const QStyleOption* option,
                             const QWidget* widget) const {
  static const std::map<StandardPixmap, std::pair<const char*, Role>> kOwn = {
      {SP_MessageBoxQuestion, {"info", Role::Accent}},
      {SP_MessageBoxInformation, {"info", Role::Accent}},
      {SP_MessageBoxWarning, {"warning", Role::WarningMark}},
      {SP_MessageBoxCritical, {"error", Role::Error}},
      {SP_DirIcon, {"file-open", Role::TextSecondary}},
      {SP_DirClosedIcon, {"file-open", Role::TextSecondary}},
      {SP_DirOpenIcon, {"file-open", Role::TextSecondary}},
      {SP_DirHomeIcon, {"file-open", Role::TextSecondary}},
      {SP_FileIcon, {"file", Role::TextSecondary}},
      {SP_FileDialogNewFolder, {"add", Role::Text}},
      {SP_FileDialogToParent, {"chevron-up", Role::Text}},
      {SP_ArrowForward, {"chevron-right", Role::Text}},
      {SP_ArrowBack, {"chevron-right", Role::Text}}};
  const auto own = kOwn.find(which);
  if (own == kOwn.end()) {
    return QProxyStyle::standardIcon(which, option, widget);
  }
  const auto& [name, color] = own->second;
  const QIcon icon = tintedIcon(QString::fromLatin1(name), theme_.color(color));
  return which == SP_ArrowBack ? mirrored(icon) : icon;
}

bool AppStyle::drawSimple(PrimitiveElement element, const QStyleOption& option, QPainter& painter,
                          const QWidget* widget) const {
  switch (element) {
    case PE_PanelLineEdit:
    case PE_FrameLineEdit:
      if (const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(&option);
          frame != nullptr && (frame->lineWidth > 0 || isInPlaceEditor(widget))) {
        drawFieldFrame(painter, option, widget);
      }
      return true;
    case PE_Frame:
    case PE_PanelTipLabel:
    case PE_FrameFocusRect:
      drawFrame(element, option, painter, widget);
      return true;
    case PE_IndicatorRadioButton:
    case PE_IndicatorCheckBox:
    case PE_IndicatorItemViewItemCheck:
      drawIndicator(painter, option, element == PE_IndicatorRadioButton);
      return true;
    case PE_PanelItemViewItem:
      drawRow(painter, option, widget);
      return true;
    case PE_FrameTabBarBase:  // Extends the line under the tabs to the end of the bar.
      painter.fillRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1,
                       theme_.color(Role::Line));
      return true;
    case PE_PanelScrollAreaCorner:
      painter.fillRect(option.rect, theme_.color(Role::Panel));
      return true;
    case PE_PanelItemViewRow:
    case PE_PanelMenuBar:
    case PE_FrameStatusBarItem:
    case PE_IndicatorToolBarHandle:
    case PE_FrameDockWidget:
      return true;  // Nothing is drawn.
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

void AppStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                             QPainter* painter, const QWidget* widget) const {
  painter->save();
  const bool drawn = drawSimple(element, *option, *painter, widget);
  painter->restore();
  if (!drawn) {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
  }
}

/// Draws the label of a heading aligned with the cells below. False: it is not drawn, since it has
/// its usual place.
bool AppStyle::drawHeading(QPainter& painter, const QStyleOption& option,
                           const QWidget* widget) const {
  const auto* header = qstyleoption_cast<const QStyleOptionHeader*>(&option);
  if (header == nullptr) {
    return false;
  }
  const bool isFirst = header->section == 0;
  const bool isAfterNumbers = followsNumbers(*header, widget);
  const bool isLast = endsTreeRow(*header, widget);
  if (!isFirst && !isAfterNumbers && !isLast) {
    return false;
  }
  QStyleOptionHeader label = *header;
  const int inset = isAfterNumbers ? kColumnGap : isFirst ? kTableInset : 0;
  label.rect.adjust(inset, 0, isLast ? -kTableInset : 0, 0);
  if ((int(header->textAlignment) & Qt::TextWordWrap) == 0) {
    label.text =
        label.fontMetrics.elidedText(label.text, Qt::ElideMiddle, label.rect.width() - kHeadingGap);
  }
  QProxyStyle::drawControl(CE_HeaderLabel, &label, &painter, widget);
  return true;
}

/// Draws the title of a menu in the menu bar.
void AppStyle::drawMenuTitle(QPainter& painter, const QStyleOptionMenuItem& item) const {
  painter.fillRect(item.rect, theme_.color(Role::Window));
  if (item.state.testFlag(State_Selected)) {
    painter.setRenderHint(QPainter::Antialiasing);
    setPenAndBrush(painter, Qt::NoPen, theme_.color(Role::RowSelected));
    painter.drawRoundedRect(QRectF(item.rect).adjusted(1, 2, -1, -2), 4, 4);
  }
  drawItemText(&painter, item.rect, Qt::AlignCenter | Qt::TextHideMnemonic | Qt::TextSingleLine,
               item.palette, item.state.testFlag(State_Enabled), item.text, QPalette::WindowText);
}

void AppStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                           const QWidget* widget) const {
  painter->save();
  bool drawn = true;
  switch (element) {
    case CE_TabBarTabShape:
      drawTab(*painter, *option);
      break;
    case CE_TabBarTabLabel:
      if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option)) {
        QStyleOptionTab label = *tab;
        label.state &= ~State_HasFocus;  // The tab has a ring.
        QProxyStyle::drawControl(element, &label, painter, widget);
      }
      break;
    case CE_ComboBoxLabel:
      if (const auto* combo = qstyleoption_cast<const QStyleOptionComboBox*>(option)) {
        drawComboLabel(*painter, *combo, widget);
      }
      break;
    case CE_ToolBar:
    case CE_MenuBarEmptyArea:
      painter->fillRect(option->rect, theme_.color(Role::Window));
      break;
    case CE_HeaderSection:
    case CE_HeaderEmptyArea:
      painter->fillRect(option->rect, theme_.color(Role::Panel));
      painter->fillRect(QRect(option->rect.left(), option->rect.bottom(), option->rect.width(), 1),
                        theme_.color(Role::Line));
      break;
    case CE_HeaderLabel:
      drawn = drawHeading(*painter, *option, widget);
      break;
    case CE_ProgressBarGroove:
    case CE_ProgressBarContents:
      if (const auto* bar = qstyleoption_cast<const QStyleOptionProgressBar*>(option)) {
        drawProgress(*painter, *bar, element == CE_ProgressBarContents);
      }
      break;
    case CE_FocusFrame:  // Masked: only its edge is visible.
      painter->fillRect(option->rect, theme_.color(Role::Accent));
      break;
    case CE_Splitter:
      painter->fillRect(option->rect, theme_.color(Role::Line));
      break;
    case CE_MenuBarItem:
      if (const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option)) {
        drawMenuTitle(*painter, *item);
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

void AppStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                  QPainter* painter, const QWidget* widget) const {
  const auto* spin = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
  const auto* combo = qstyleoption_cast<const QStyleOptionComboBox*>(option);
  const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
  const auto* button = qstyleoption_cast<const QStyleOptionToolButton*>(option);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  bool drawn = true;
  if (control == CC_SpinBox && spin != nullptr) {
    drawSpinBox(*painter, *spin, widget);
  } else if (control == CC_ComboBox && combo != nullptr) {
    drawFieldFrame(*painter, *combo, widget);
    drawChevron(*painter, subControlRect(control, combo, SC_ComboBoxArrow, widget), 0,
                combo->state.testFlag(State_Enabled));
  } else if (control == CC_Slider && slider != nullptr) {
    drawSlider(*painter, *slider, widget);
  } else if (control == CC_ScrollBar && slider != nullptr) {
    drawScrollBar(*painter, *slider, widget);
  } else if (control == CC_ToolButton && button != nullptr) {
    drawToolButton(*painter, *button, widget);
  } else {
    drawn = false;
  }
  painter->restore();
  if (!drawn) {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
  }
}

}  // namespace editor

#pragma once

#include "editor/look/Theme.h"

namespace editor {

/// A proxy of the Fusion style with custom fields, buttons, rows, tabs and sliders in the colours
/// of a theme. The application owns the instance. Call `setTheme` and repaint to change the
/// colours.
class AppStyle : public QProxyStyle {
  Q_OBJECT
 public:
  explicit AppStyle(const Theme& theme);
  void setTheme(const Theme& theme) { theme_ = theme; }

  int pixelMetric(PixelMetric metric, const QStyleOption* option,
                  const QWidget* widget) const override;
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* returned) const override;
  QPixmap generatedIconPixmap(QIcon::Mode mode, const QPixmap& pixmap,
                              const QStyleOption* option) const override;
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                         const QWidget* widget) const override;
  QIcon standardIcon(StandardPixmap which, const QStyleOption* option,
                     const QWidget* widget) const override;
  QRect subElementRect(SubElement element, const QStyleOption* option,
                       const QWidget* widget) const override;
  QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl sub,
                       const QWidget* widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                          QPainter* painter, const QWidget* widget) const override;

 private:
  void drawFieldFrame(QPainter& painter, const QStyleOption& option, const QWidget* widget) const;
  /// Draws a ring around the focused widget during keyboard navigation.
  void drawFocusRing(QPainter& painter, const QStyleOption& option, const QRectF& rect) const;
  void drawFrame(PrimitiveElement element, const QStyleOption& option, QPainter& painter,
                 const QWidget* widget) const;
  void drawChevron(QPainter& painter, const QRectF& rect, int quarterTurns, bool enabled) const;
  void drawIndicator(QPainter& painter, const QStyleOption& option, bool isRadio) const;
  void drawButton(QPainter& painter, const QStyleOption& option) const;
  void drawTab(QPainter& painter, const QStyleOption& option) const;
  bool drawHeading(QPainter& painter, const QStyleOption& option, const QWidget* widget) const;
  void drawMenuTitle(QPainter& painter, const QStyleOptionMenuItem& item) const;
  void drawRow(QPainter& painter, const QStyleOption& option, const QWidget* widget) const;
  bool drawSimple(PrimitiveElement element, const QStyleOption& option, QPainter& painter,
                  const QWidget* widget) const;
  void drawComboLabel(QPainter& painter, const QStyleOptionComboBox& combo,
                      const QWidget* widget) const;
  void drawSpinBox(QPainter& painter, const QStyleOptionSpinBox& spin, const QWidget* widget) const;
  void drawSlider(QPainter& painter, const QStyleOptionSlider& slider, const QWidget* widget) const;
  void drawToolButton(QPainter& painter, const QStyleOptionToolButton& button,
                      const QWidget* widget) const;
  void drawProgress(QPainter& painter, const QStyleOptionProgressBar& bar, bool isFilled) const;
  void drawScrollBar(QPainter& painter, const QStyleOptionSlider& bar, const QWidget* widget) const;

  Theme theme_;
};

/// Sets the style, palette and font of the application from the theme.
void applyTheme(const Theme& theme);

constexpr int kTableInset = 8;  // Padding before the first and after the last table column [px].
constexpr int kListInset = 6;   // Horizontal padding of list rows [px].
/// Returns true if an item is the last one in a table row.
bool endsTableRow(const QStyleOption* option, const QWidget* widget);
/// Whether the cell has right-aligned text in the last of several columns of a tree.
bool endsTreeRow(const QStyleOption& cell, const QWidget* widget);
/// The same for a heading of a tree.
bool endsTreeRow(const QStyleOptionHeader& heading, const QWidget* header);
constexpr int kColumnGap =
    8;  // Between right-aligned numbers and the text of the next column [px].
/// Whether the cell has left-aligned text beside a column of right-aligned cells.
bool followsNumbers(const QStyleOption& cell);
/// The same for a heading of a table or tree.
bool followsNumbers(const QStyleOptionHeader& heading, const QWidget* header);
/// The text with a count at its end, "Events  7", padded to three digits, so that the width of its
/// tab or button does not change while the count grows. Other texts are unchanged.
QString withReservedDigits(const QString& text);
/// Returns true for the editor of an item in a list, tree or table, which covers the item.
bool isInPlaceEditor(const QWidget* widget);
/// A field with this property set to true is drawn with an error border.
constexpr const char* kInvalidProperty = "hunavInvalid";
/// A tool button with this property draws its text as a link.
constexpr const char* kLinkProperty = "hunavLink";

}  // namespace editor

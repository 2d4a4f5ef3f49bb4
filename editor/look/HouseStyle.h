#pragma once

#include <QProxyStyle>
#include <QStyleOption>

#include "editor/look/Theme.h"

namespace editor {

/// Fusion with our fields, buttons, rows, tabs and sliders, in the colours of a theme. The
/// application owns one; `setTheme` and a repaint change it at once.
class HouseStyle : public QProxyStyle {
  Q_OBJECT
 public:
  explicit HouseStyle(const Theme& theme);
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
  /// Around what has the focus, while the keyboard is used.
  void drawFocusRing(QPainter& painter, const QStyleOption& option, const QRectF& rect) const;
  void drawFrame(PrimitiveElement element, const QStyleOption& option, QPainter& painter,
                 const QWidget* widget) const;
  void drawChevron(QPainter& painter, const QRectF& rect, int quarterTurns, bool enabled) const;
  void drawIndicator(QPainter& painter, const QStyleOption& option, bool isRadio) const;
  void drawButton(QPainter& painter, const QStyleOption& option) const;
  void drawTab(QPainter& painter, const QStyleOption& option) const;
  void drawRow(QPainter& painter, const QStyleOption& option, const QWidget* widget) const;
  bool drawSimple(PrimitiveElement element, const QStyleOption& option, QPainter& painter,
                  const QWidget* widget) const;
  void drawComboLabel(QPainter& painter, const QStyleOptionComboBox& combo,
                      const QWidget* widget) const;
  void drawSpinBox(QPainter& painter, const QStyleOptionSpinBox& spin, const QWidget* widget) const;
  void drawSlider(QPainter& painter, const QStyleOptionSlider& slider, const QWidget* widget) const;
  void drawToolButton(QPainter& painter, const QStyleOptionToolButton& button,
                      const QWidget* widget) const;
  void drawScrollBar(QPainter& painter, const QStyleOptionSlider& bar, const QWidget* widget) const;

  Theme theme_;
};

/// Gives the application style, palette and font of the theme.
void dressApplication(const Theme& theme);

constexpr int kTableInset = 8;  // before the first column of tables and after the last [px]
constexpr int kListInset = 6;   // of the rows of lists [px]
/// Whether an item of a view is the last of its row in a table.
bool endsTableRow(const QStyleOption* option, const QWidget* widget);
/// A field with this property set to true is drawn with the edge of an error.
constexpr const char* kInvalidProperty = "hunavInvalid";
/// A tool button with this property draws its words as a link.
constexpr const char* kLinkProperty = "hunavLink";

}  // namespace editor

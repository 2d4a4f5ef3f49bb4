#pragma once

#include <functional>
#include <map>
#include <new>
#include <tuple>

#include "editor/look/Theme.h"
#include "sim2d/nav/Body.h"
#include "sim2d/scenario/Scenario.h"

namespace editor {

/// An image to paint on. Throws std::bad_alloc if the allocation fails, where Qt returns a null
/// image that crashes a painter. Thread: any.
inline QImage blankImage(const QSize& size, QImage::Format format) {
  QImage image(size, format);
  if (image.isNull() && !size.isEmpty()) {
    throw std::bad_alloc();
  }
  return image;
}

/// Sets pen and brush.
inline void setPenAndBrush(QPainter& painter, const QPen& pen, const QBrush& fill = Qt::NoBrush) {
  painter.setPen(pen);
  painter.setBrush(fill);
}

/// Draws an unfilled ring.
inline void paintRing(QPainter& painter, const QPen& pen, double radius,
                      const QPointF& centre = {}) {
  setPenAndBrush(painter, pen);
  painter.drawEllipse(centre, radius, radius);
}

/// The appearance of a person drawn from above.
struct PersonFigure {
  Look look = Look::Regular;
  sim2d::PersonKind kind = sim2d::PersonKind::Adult;
  double radiusPx = 18.0;   // Radius of the body.
  double headingDeg = 0.0;  // Counter-clockwise from the right.
  double stride = 0.0;      // Foot position in a step, -1 … 1; 0 = standing.
};

struct RobotFigure {
  double radiusPx = 18.0;
  double headingDeg = 0.0;
  std::vector<QPointF> footprintPx;  // Robot frame, y up; empty = disc.
  sim2d::Kinematics kinematics = sim2d::Kinematics::Differential;  // Determines the wheels.
};

/// An icon for each of the pixel ratios. `draw` paints around the origin; one unit = one pixel.
QIcon drawnIcon(int sizePx, const std::function<void(QPainter&)>& draw,
                const std::vector<int>& ratios = {1, 2, 3});

/// The outline of a text that begins at `baseline`. The result depends only on the arguments, not
/// on what was drawn before.
QPainterPath textOutline(const QPointF& baseline, const QFont& font, const QString& text);

constexpr double kHaloPx = 3.5;  // Width of the line around a text.
/// Draws text with a halo, so that it is legible on the map.
void paintHaloText(QPainter& painter, const QPointF& baseline, const QFont& font,
                   const QString& text, const QColor& halo, const QColor& color);

/// Draws figures identically on the canvas, in lists, thumbnails and reports. Figures are centred
/// at the painter's origin; one unit = one pixel, y down.
class FigurePainter {
 public:
  explicit FigurePainter(const Theme& theme) : theme_(theme) {}

  void person(QPainter& painter, const PersonFigure& figure) const;
  void robot(QPainter& painter, const RobotFigure& figure) const;
  void mark(QPainter& painter, Look look, const QPointF& centre, double sizePx) const;
  /// A pin with its tip at the origin, 18 x 26 px at scale 1.
  void pin(QPainter& painter, const QString& text, bool selected, double scale = 1.0) const;
  /// A small chevron on a route, pointing along `headingDeg`.
  void arrowHead(QPainter& painter, const QPointF& tip, double headingDeg, double sizePx) const;

  /// Icons for lists and legends, sharp at every pixel ratio.
  QIcon markIcon(Look look, int sizePx = 16) const;
  QIcon personIcon(Look look, int sizePx = 24) const;
  QIcon goalIcon(const QString& text, int sizePx = 24) const;
  QIcon robotIcon(int sizePx = 24) const;

 private:
  void accessories(QPainter& painter, const PersonFigure& figure) const;
  void wheels(QPainter& painter, const RobotFigure& figure, const QRectF& box) const;
  const Theme& theme_;
};

/// Cached pictures of people: one sheet per appearance, kind and size with 64 headings and 3 step
/// phases. A picture is rendered on first use; a new zoom requires new sheets (`clear`).
class SpriteAtlas {
 public:
  void clear() { sheets_.clear(); }
  /// Draws figures centred at their points (painter in pixels). Figures too large for sheets are
  /// painted directly.
  void draw(QPainter& painter, const Theme& theme,
            const std::vector<std::pair<QPointF, PersonFigure>>& figures);

 private:
  using Key = std::tuple<Look, sim2d::PersonKind, int>;  // Radius in quarters of a pixel.
  struct Sheet {
    QPixmap pixmap;
    std::vector<bool> painted;
    int cell = 0;  // Side length [device pixels].
    std::vector<QPainter::PixmapFragment> fragments;
  };
  Sheet& sheetFor(const PersonFigure& figure, double ratio);
  static void add(Sheet& sheet, const Theme& theme, const QPointF& at, const PersonFigure& figure,
                  double ratio);

  std::map<Key, Sheet> sheets_;
};

/// A colour-free sign for the kind of an area: an arrow out of a gate (source) or into one (sink),
/// a clock (waiting), a running figure (exit). Strokes around the origin, 16 units wide.
QPainterPath areaGlyph(sim2d::AreaKind kind);
/// Draws the sign at `sizePx`, with a rim in the background colour.
void paintAreaGlyph(QPainter& painter, sim2d::AreaKind kind, const QPointF& centre, double sizePx,
                    const Theme& theme);
/// The sign as a list icon.
QIcon areaIcon(sim2d::AreaKind kind, const Theme& theme, int sizePx = 16);

}  // namespace editor

#pragma once

#include <QGraphicsView>
#include <QPixmap>
#include <QTimer>
#include <QVariantAnimation>

#include "editor/canvas/MapScene.h"

namespace editor {

/// The line on top of the canvas: green while running, amber when paused, blue in the past.
enum class CanvasState { Editing, Running, Paused, Past };

class LegendStrip;

/// A picture of what rests on a crowded canvas, kept while something is dragged or the view moves,
/// so that only little has to be painted anew for each frame.
class RestingPicture {
 public:
  /// Where and how a view looks at the scene.
  struct Window {
    QTransform fromScene;
    QSize size;          // [px]
    double ratio = 1.0;  // device pixels per pixel
  };
  /// Whether it shows what `window` shows now; `exactly`: at the same place and scale too,
  /// otherwise the window lies inside of it and the scales differ little.
  bool fits(const MapScene& scene, const Window& window, bool exactly) const;
  /// Takes the picture, `margin` pixels larger than the window on each side.
  void take(MapScene& scene, const Window& window, int margin);
  void draw(QPainter& painter, const Window& window) const;  // painter in window pixels
  void clear() { *this = {}; }

 private:
  QPixmap pixmap_;
  QTransform fromScene_;          // to pixels of the picture
  int margin_ = 0;                // [px]
  int revision_ = -1;             // of the scene
  std::vector<EntityId> moving_;  // what is not in it
};

/// The window on the map: wheel zooms at the cursor, middle button or Space and drag pan, fit is
/// animated. Rulers, scale bar and state line are drawn over the scene.
class MapView : public QGraphicsView {
  Q_OBJECT
 public:
  explicit MapView(MapScene& scene, QWidget* parent = nullptr);

  void fitAll(bool animated = true);
  void centerOnEntity(EntityId id);
  void zoomBy(double factor, const QPointF& viewportPoint);
  void zoomBy(double factor) { zoomBy(factor, viewport()->rect().center()); }
  void zoomIn() { zoomBy(1.25); }
  void zoomOut() { zoomBy(1.0 / 1.25); }
  void setPixelsPerMetre(double value) { zoomBy(value / pixelsPerMetre()); }
  double pixelsPerMetre() const { return transform().m11(); }
  Vec2 worldAt(const QPoint& viewportPoint) const { return toWorld(mapToScene(viewportPoint)); }
  QPoint viewportFrom(const Vec2& world) const { return mapFromScene(toScene(world)); }
  void setCanvasState(CanvasState state);
  void setHandPan(bool on);  // the left button pans as well
  MapScene& mapScene() const { return scene_; }

 Q_SIGNALS:
  void cursorMoved(const base::Vec2& world);  // [m]
  void zoomChanged(double pixelsPerMetre);
  void spaceTapped();  // pressed and let go without a drag: play or pause

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void drawBackground(QPainter* painter, const QRectF& rect) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct ViewPlace {
    QPointF centre;       // scene
    double scale = 50.0;  // [px/m]
  };
  void moveTo(const ViewPlace& place, bool animated);
  void applyView(const QPointF& centre, double pixelsPerMetre);
  void followMap();
  void updateCursor();
  QColor stateColor() const;
  void placeLegend();
  void glide();
  bool startsPan(const QMouseEvent& event) const;

  MapScene& scene_;
  LegendStrip* legend_ = nullptr;
  QVariantAnimation fitAnimation_;
  ViewPlace animationFrom_, animationTo_;
  RestingPicture picture_;
  QRectF ground_;  // of the map that was fitted in
  int legendCorner_ = 0;
  QTimer settle_;  // runs while the view moves; then all is painted sharply again
  CanvasState state_ = CanvasState::Editing;
  QPoint panFrom_;
  bool panning_ = false;
  bool spaceHeld_ = false;
  bool spaceUsed_ = false;  // for a pan since it went down
  bool handPan_ = false;
  bool fitted_ = true;  // follows the size of the window until the user zooms or pans
};

}  // namespace editor

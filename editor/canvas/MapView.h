#pragma once

#include "editor/canvas/MapScene.h"

namespace editor {

/// State line at the top of the canvas: green while running, amber when paused, blue in the past.
enum class CanvasState { Editing, Running, Paused, Past };

class LegendStrip;

/// A cached picture of the resting part of a crowded canvas. It is used while something is dragged
/// or the view moves, so that each frame paints only little.
class CanvasCache {
 public:
  /// The transform and size of a view.
  struct Window {
    QTransform fromScene;
    QSize size;          // [px]
    double ratio = 1.0;  // Device pixels per pixel.
  };
  /// Returns true if the picture can be used for `window`. `exactly`: position and scale must be
  /// equal; otherwise the window must lie inside the picture with a similar scale.
  bool fits(const MapScene& scene, const Window& window, bool exactly) const;
  /// Renders the picture, `margin` pixels larger than the window on each side.
  void take(MapScene& scene, const Window& window, int margin);
  void draw(QPainter& painter, const Window& window) const;  // Painter in window pixels.
  void clear() { *this = {}; }

 private:
  QPixmap pixmap_;
  QTransform fromScene_;          // To pixels of the picture.
  int margin_ = 0;                // [px]
  int revision_ = -1;             // Revision of the scene.
  std::vector<EntityId> moving_;  // Entities that are not in the picture.
};

/// The map view: the wheel zooms at the cursor, the middle button or Space and drag pan, fitting is
/// animated. It draws rulers, scale bar and state line over the scene.
class MapView : public QGraphicsView {
  Q_OBJECT
 public:
  explicit MapView(MapScene& scene, QWidget* parent = nullptr);

  void fitAll(bool animated = true);
  /// Sets the height at the top that other widgets cover [px]. The next fit leaves it out; the view
  /// does not move immediately.
  void setCoveredTop(int height) {
    coveredTop_ = height;
    placeLegend();
  }
  void centerOnEntity(EntityId id);
  void zoomBy(double factor, const QPointF& viewportPoint);
  void zoomBy(double factor) { zoomBy(factor, viewport()->rect().center()); }
  void zoomIn() { zoomBy(1.25); }
  void zoomOut() { zoomBy(1.0 / 1.25); }
  /// Whether fitting moves the map gradually.
  void setAnimated(bool animated) { isAnimated_ = animated; }
  void setPixelsPerMetre(double value) { zoomBy(value / pixelsPerMetre()); }
  double pixelsPerMetre() const { return transform().m11(); }
  Vec2 worldAt(const QPoint& viewportPoint) const { return toWorld(mapToScene(viewportPoint)); }
  QPoint viewportFrom(const Vec2& world) const { return mapFromScene(toScene(world)); }
  /// The scene point at the centre of the viewport, to a fraction of a pixel.
  QPointF sceneCentre() const {
    return viewportTransform().inverted().map(QRectF(viewport()->rect()).center());
  }
  void setCanvasState(CanvasState state) {
    state_ = state;
    placeLegend();
    viewport()->update();
  }
  /// The colour of the line at the top while runs are side by side; invalid: that of the state.
  void setRunColor(const QColor& color) {
    runColor_ = color;
    viewport()->update();
  }
  /// The legend has only signs and values, for a view beside another one with the whole legend.
  void setLegendBrief(bool brief);
  /// The left button pans as well.
  void setLeftButtonPan(bool on) {
    leftButtonPans_ = on;
    updateCursor();
  }
  MapScene& mapScene() const { return scene_; }
  /// The mouse position on the map [m]; none while the mouse is elsewhere.
  std::optional<Vec2> pointer() const {
    return pointer_ ? std::optional<Vec2>(worldAt(*pointer_)) : std::nullopt;
  }

 Q_SIGNALS:
  void cursorMoved(const base::Vec2& world);  // [m]
  void zoomChanged(double pixelsPerMetre);
  void spaceTapped();  // Space was pressed and released without a drag: play or pause.

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override {
    spaceHeld_ = false;  // Another widget receives its release.
    QGraphicsView::focusOutEvent(event);
  }
  void leaveEvent(QEvent* event) override {
    scene_.setHovered({});  // The mouse has left the canvas.
    pointer_.reset();
    QGraphicsView::leaveEvent(event);
  }
  void drawBackground(QPainter* painter, const QRectF& rect) override {
    // Larger: the antialiased edge of a partial repaint would mix with the pixels before it.
    const double margin = 2.0 / pixelsPerMetre();
    painter->fillRect(rect.adjusted(-margin, -margin, margin, margin), scene_.groundColor());
  }
  void drawForeground(QPainter* painter, const QRectF& rect) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct ViewCentre {
    QPointF centre;       // Scene coordinates.
    double scale = 50.0;  // [px/m]
  };
  void moveTo(const ViewCentre& place, bool animated);
  void applyView(const QPointF& centre, double pixelsPerMetre);
  void fitNewMap();
  void updateCursor();
  QColor stateColor() const;
  void placeLegend();
  int freeLegendCorner() const;
  /// Called while the view moves: crowded scenes use the cached picture meanwhile.
  void restartSettleTimer() { settleTimer_.start(); }
  bool startsPan(const QMouseEvent& event) const;

  MapScene& scene_;
  LegendStrip* legend_ = nullptr;
  QVariantAnimation fitAnimation_;
  ViewCentre animationFrom_, animationTo_;
  CanvasCache picture_;
  QRectF ground_;  // Area of the map fitted last.
  int legendCorner_ = 0;
  QTimer settleTimer_;  // Runs while the view moves; afterwards everything is painted sharply.
  CanvasState state_ = CanvasState::Editing;
  QColor runColor_;
  QPoint panFrom_;
  std::optional<QPoint> pointer_;  // In the viewport [px].
  bool panning_ = false;
  bool spaceHeld_ = false;
  bool spaceUsed_ = false;  // Space was used for a pan since it was pressed.
  bool leftButtonPans_ = false;
  bool isAnimated_ = true;
  int coveredTop_ = 0;
  bool fitted_ = true;  // The zoom follows the window size until the user zooms or pans.
};

}  // namespace editor

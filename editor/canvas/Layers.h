#pragma once

#include <tuple>

#include "editor/canvas/EntityItem.h"
#include "editor/canvas/RouteModel.h"
#include "editor/canvas/Tool.h"

namespace editor {

/// Base of layers that cover the whole visible scene.
class FullLayer : public CanvasItem {
 public:
  explicit FullLayer(const MapScene& scene) : CanvasItem(scene) {
    setFlag(QGraphicsItem::ItemUsesExtendedStyleOption);
  }
  QRectF boundingRect() const override { return mapScene().extent(); }
};

/// The map in the colours of the theme: cells with sharp edges when zoomed in, averaged copies when
/// zoomed out so that thin walls stay visible. Large maps are painted in tiles with a bounded
/// cache.
class MapItem : public CanvasItem {
 public:
  explicit MapItem(const MapScene& scene) : CanvasItem(scene) {
    setFlag(QGraphicsItem::ItemUsesExtendedStyleOption);
  }
  void refresh();  // Call it after a change of the map or the colours.
  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

  qint64 bytes() const;  // Memory of the tiles.

 private:
  struct Tile {
    QPixmap picture;
    int seen = 0;  // Number of the paint event that used it last.
  };
  const QPixmap& tile(int side, const QRect& pixels);
  void evictTiles();

  QRectF bounds_;
  QTransform sceneFromPixel_;
  std::map<std::tuple<int, int, int>, Tile> tiles_;  // By cells per pixel, left and top pixel.
  int paints_ = 0;
};

/// An image with one pixel per cell; also for thumbnails.
QImage mapImage(const sim2d::OccupancyGrid& grid, const Theme& theme);

/// A rectangle for each label (sizes and centres in pixels): below, above, beside or diagonal to
/// its centre; a null rectangle if there is no space. Labels do not overlap each other or `taken`
/// and stay within `window`. Near its edge they are shifted along it while they still touch the
/// area around their centre.
std::vector<QRectF> layoutLabels(const std::vector<Label>& labels, const std::vector<QRectF>& taken,
                                 const QRectF& window);
/// The `Label::side` of a label that has been placed there, or left out (null).
int sideOf(const Label& label, const QRectF& place, const QRectF& window);

/// Fine lines every metre, stronger ones every five metres; they fade out when they become too
/// dense.
class GridItem : public FullLayer {
 public:
  using FullLayer::FullLayer;
  QRectF boundingRect() const override { return mapScene().groundRect(); }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
};

/// Labels with halos, placed where there is space; labels with low priority are left out. Each
/// label is rendered once and cached.
class LabelLayer : public FullLayer {
 public:
  using FullLayer::FullLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  struct Picture {
    QSizeF size;     // Size of the label [px].
    QPixmap pixmap;  // Includes a margin for the halo.
  };
  /// Text, detail line, mark, dark theme, pixel ratio in hundredths.
  using Key = std::tuple<QString, QString, int, bool, int>;
  const Picture& pictureOf(const Label& label, double ratio);
  std::map<Key, Picture> pictures_;
  std::map<QString, int> sides_;  // Of the labels of bodies during a run, by text.
};

/// The minimum spanning tree of points as pairs of indices.
std::vector<std::pair<std::size_t, std::size_t>> minimumSpanningTree(
    const std::vector<Vec2>& points);

/// Draws groups: a ring in the group colour around each member, and dashed lines between
/// neighbours. People of a preview or a run have rings at their shown positions.
class GroupLayer : public FullLayer {
 public:
  using FullLayer::FullLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  bool isPartOf(const std::vector<EntityId>& people) const;
  void paintGroup(QPainter& painter, const QColor& color,
                  const std::vector<EntityId>& people) const;
};

/// Opacity of the routes of unselected people, by the number of routes in view: 1 for a few,
/// decreasing, never 0.
double routeOpacity(std::size_t inSight);

/// Draws all routes beneath the figures: up to the first goal for all people, and the full route
/// for selected people.
class RouteLayer : public FullLayer {
 public:
  using FullLayer::FullLayer;
  void routesChanged();
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  struct Style {
    QColor color;
    double widthPx = 1.8;
    Qt::PenStyle dashes = Qt::SolidLine;
    double arrowSpacing = 1.5;  // [m]
  };
  /// A leg prepared for painting.
  struct Line {
    std::vector<Vec2> points;
    QPainterPath path;                              // Scene coordinates.
    QRectF bounds;                                  // Bounding box of the path.
    double gap = 0.0;                               // Distance between arrow heads [m].
    std::vector<std::pair<QPointF, double>> heads;  // Tips, and angles in degrees.
  };
  Line& lineOf(EntityId id, std::size_t index, const RouteLeg& leg);
  static void placeHeads(Line& line, double spacing, double pixelsPerMetre);
  std::size_t countVisibleRoutes(const QRectF& shown);
  void paintRoute(QPainter& painter, EntityId id, bool whole, const Style& style);
  void paintLeg(QPainter& painter, const Line& line, bool isReachable, const Style& style) const;
  void paintPeople(QPainter& painter, bool selected);
  void paintRobots(QPainter& painter);

  QRectF exposed_;                // Exposed area of the current paint event.
  double opacity_ = 1.0;          // Opacity of the routes of unselected people.
  double selectedOpacity_ = 1.0;  // Opacity of the routes of selected people.
  bool showsFullRoutes_ = true;   // Selected people show the full route, else up to the first goal.
  std::map<EntityId, std::vector<Line>> lines_;
};

/// A polyline with rounded corners that deviates at most `softness` [m] from them.
QPainterPath roundedPath(const std::vector<Vec2>& points, double softness);
/// Draws chevrons along a path every `spacing` [m], starting at half of it.
void paintArrowHeads(QPainter& painter, const QPainterPath& scenePath, double spacing,
                     double sizePx, const Theme& theme);

/// Draws the frames and handles of selected entities.
class SelectionLayer : public FullLayer {
 public:
  using FullLayer::FullLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  /// The handle at a point (16 px wide) and its entity.
  std::pair<EntityId, Handle> handleAt(const Vec2& world) const;
  std::vector<QRectF> labelObstacles() const;  // Handles in scene coordinates.

 private:
  std::vector<Handle> handlesFor(const Entity& entity) const;
  std::vector<std::pair<EntityId, Handle>> handles() const;
  void paintFrame(QPainter& painter, const Entity& entity,
                  const std::vector<Handle>& handles) const;
  void paintHandle(QPainter& painter, const Entity& entity, const Handle& handle) const;
};

/// Draws the marks of the current tool.
class ToolLayer : public FullLayer {
 public:
  using FullLayer::FullLayer;
  ToolMarks& marks() { return marks_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paintOutline(QPainter& painter) const;
  void paintLines(QPainter& painter) const;
  void paintArrows(QPainter& painter) const;
  void paintGuides(QPainter& painter) const;
  void paintGap(QPainter& painter, const AlignmentGap& gap) const;
  void paintTag(QPainter& painter) const;

  ToolMarks marks_;
};

QSizeF labelSize(const Theme& theme, const Label& label);

}  // namespace editor

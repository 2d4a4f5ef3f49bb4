#pragma once

#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <QPainterPath>
#include <QPixmap>

#include "editor/canvas/EntityItem.h"
#include "editor/canvas/RouteModel.h"
#include "editor/canvas/Tool.h"

namespace editor {

/// Covers all that the scene shows: for layers whose extent is that of the window.
class FullLayer : public CanvasItem {
 public:
  explicit FullLayer(const MapScene& scene) : CanvasItem(scene) {
    setFlag(QGraphicsItem::ItemUsesExtendedStyleOption);
  }
  QRectF boundingRect() const override { return mapScene().extent(); }
};

/// The map in the colours of the theme: cells with sharp edges when near, smaller copies of it when
/// far so that thin walls stay visible. Large maps are painted in tiles, of which few are kept.
class MapItem : public CanvasItem {
 public:
  explicit MapItem(const MapScene& scene) : CanvasItem(scene) {
    setFlag(QGraphicsItem::ItemUsesExtendedStyleOption);
  }
  void refresh();  // another map, or other colours
  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

  qint64 bytes() const;  // of its pictures

 private:
  struct Tile {
    QPixmap picture;
    int seen = 0;  // in which paint
  };
  const QPixmap& tile(int side, const QRect& pixels);
  void forgetTiles();

  QRectF bounds_;
  QTransform sceneFromPixel_;
  std::map<std::tuple<int, int, int>, Tile> tiles_;  // by cells per pixel, left and top pixel
  int paints_ = 0;
};

/// An image with one pixel per cell; also for thumbnails.
QImage mapImage(const sim2d::OccupancyGrid& grid, const Theme& theme);

/// A rectangle for each label (sizes and centres in pixels), below, above, beside or askew of its
/// centre; a null rectangle where there is no room. Labels keep off each other and off `taken`, and
/// stay wholly within `window`: near its edge they move along it, as long as they stay beside their
/// centre.
std::vector<QRectF> layoutLabels(const std::vector<Label>& labels, const std::vector<QRectF>& taken,
                                 const QRectF& window);

/// Fine lines every metre, stronger ones every five; they fade when they get too dense.
class GridItem : public FullLayer {
 public:
  using FullLayer::FullLayer;
  QRectF boundingRect() const override { return mapScene().groundRect(); }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
};

/// Names with halos, placed where there is room; the less important ones are left out. Each is
/// painted once and kept as a picture.
class LabelLayer : public FullLayer {
 public:
  using FullLayer::FullLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  struct Picture {
    QSizeF size;     // of the label [px]
    QPixmap pixmap;  // with a margin for the halo
  };
  /// Text, second line, mark, dark, hundredths of the ratio.
  using Key = std::tuple<QString, QString, int, bool, int>;
  const Picture& pictureOf(const Label& label, double ratio);
  std::map<Key, Picture> pictures_;
};

/// The shortest lines that join all points: pairs of their numbers.
std::vector<std::pair<std::size_t, std::size_t>> shortestLinks(const std::vector<Vec2>& points);

/// Who walks together: a ring in the colour of the group around each of its people, and dashed
/// lines from one to the next. People of a preview and of a run stand where they are shown.
class GroupLayer : public FullLayer {
 public:
  using FullLayer::FullLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  bool isPartOf(const std::vector<EntityId>& people) const;
  void paintGroup(QPainter& painter, const QColor& color,
                  const std::vector<EntityId>& people) const;
};

/// How strong the ways of those are who are not selected, where so many are in sight: 1 for a few,
/// less the more there are, never nothing.
double routeStrength(std::size_t inSight);

/// All routes beneath the figures: of everybody the way to the first goal, of the selected ones the
/// whole round.
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
  /// A leg ready to be painted.
  struct Line {
    std::vector<Vec2> points;
    QPainterPath path;                              // scene
    QRectF bounds;                                  // of the path
    double gap = 0.0;                               // between arrow heads [m]
    std::vector<std::pair<QPointF, double>> heads;  // tips, degrees
  };
  Line& lineOf(EntityId id, std::size_t index, const RouteLeg& leg);
  static void placeHeads(Line& line, double spacing, double pixelsPerMetre);
  std::size_t countInSight(const QRectF& shown);
  void paintRoute(QPainter& painter, EntityId id, bool whole, const Style& style);
  void paintLeg(QPainter& painter, const Line& line, bool isReachable, const Style& style) const;
  void paintPeople(QPainter& painter, bool selected);
  void paintRobots(QPainter& painter);

  QRectF exposed_;               // of the current painting
  double strength_ = 1.0;        // of the ways of those who are not selected
  double chosenStrength_ = 1.0;  // and of those who are
  bool showsRounds_ = true;      // of those who are selected; else the way to the first goal
  std::map<EntityId, std::vector<Line>> lines_;
};

/// A line with soft corners that stays within `softness` [m] of them.
QPainterPath softPath(const std::vector<Vec2>& points, double softness);
/// Chevrons along a path every `spacing` [m], the first one after half of it.
void paintArrowHeads(QPainter& painter, const QPainterPath& scenePath, double spacing,
                     double sizePx, const Theme& theme);

/// Frames and handles of what is selected.
class SelectionLayer : public FullLayer {
 public:
  using FullLayer::FullLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  /// The handle under a point (16 px wide), of which entity.
  std::pair<EntityId, Handle> handleAt(const Vec2& world) const;
  std::vector<QRectF> solidParts() const;  // handles, scene

 private:
  std::vector<Handle> handlesFor(const Entity& entity) const;
  std::vector<std::pair<EntityId, Handle>> handles() const;
  void paintFrame(QPainter& painter, const Entity& entity,
                  const std::vector<Handle>& handles) const;
  void paintHandle(QPainter& painter, const Entity& entity, const Handle& handle) const;
};

/// Paints what the current tool shows.
class ToolLayer : public FullLayer {
 public:
  using FullLayer::FullLayer;
  ToolMarks& marks() { return marks_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paintOutline(QPainter& painter) const;
  void paintLines(QPainter& painter) const;
  void paintArrows(QPainter& painter) const;
  void paintTag(QPainter& painter) const;

  ToolMarks marks_;
};

QSizeF labelSize(const Theme& theme, const Label& label);

}  // namespace editor

#pragma once

#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <QGraphicsItem>
#include <QPixmap>

#include "editor/canvas/EntityItem.h"
#include "editor/canvas/MapScene.h"
#include "editor/document/Geometry.h"

namespace editor {

/// Covers all that the scene shows: for layers whose extent is that of the window.
class FullLayer : public QGraphicsItem {
 public:
  explicit FullLayer(const MapScene& scene) : scene_(scene) {
    setFlag(QGraphicsItem::ItemUsesExtendedStyleOption);
  }
  QRectF boundingRect() const override { return bounds_; }
  void setBounds(const QRectF& sceneBounds);

 protected:
  const MapScene& mapScene() const { return scene_; }
  const Theme& theme() const { return scene_.theme(); }

 private:
  const MapScene& scene_;
  QRectF bounds_;
};

/// A text that wants to stand at something round, pixels.
struct LabelWish {
  QPointF centre;
  double clearance = 18.0;  // from the centre to the edge of the label
  QSizeF size;
  int priority = 0;       // higher ones choose first
  bool isAbove = false;   // would rather stand above than below
  bool isNeeded = false;  // where there is no room: on what is taken, off other labels alone
};

/// A rectangle for each wish, below, above, beside or askew of its centre; a null rectangle where
/// there is no room. Labels keep off each other and off `taken`, and stay wholly within `window`:
/// near its edge they move along it, as long as they stay beside their centre.
std::vector<QRectF> layoutLabels(const std::vector<LabelWish>& wishes,
                                 const std::vector<QRectF>& taken, const QRectF& window);

/// Fine lines every metre, stronger ones every five; they fade when they get too dense.
class GridItem : public FullLayer {
 public:
  using FullLayer::FullLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paintLines(QPainter& painter, const QRectF& area, double step, double alpha) const;
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
  using Key = std::tuple<QString, int, bool, int>;  // text, mark, dark, hundredths of the ratio
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
  struct Member {
    Vec2 at = Vec2::Zero();
    double radius = 0.35;  // [m]
  };
  bool isPartOf(const std::vector<EntityId>& people) const;
  std::vector<Member> membersOf(const std::vector<EntityId>& people) const;
};

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

/// A line of the current tool.
struct ToolLine {
  std::vector<Vec2> points;  // world
  bool isClosed = false;     // then slightly filled
  bool isBad = false;        // cannot become anything: in the colour of errors
  bool hasCorners = true;    // small squares at its points
};
/// Somebody or something that a tool would make: a disc.
struct ToolDot {
  Vec2 at = Vec2::Zero();
  double radius = 0.3;  // [m]
  QColor color;
  std::optional<double> heading;  // a nose
};

/// What the current tool shows while a gesture lasts.
class ToolLayer : public FullLayer {
 public:
  using FullLayer::FullLayer;
  void setRubberBand(const Vec2& corner, const Vec2& opposite);
  void setLine(std::vector<Vec2> points) { show(marks_.line, std::move(points)); }  // arrow heads
  void setOutline(ToolLine line) { show(marks_.outline, std::move(line)); }
  void setStroke(std::vector<Vec2> points, double width) {  // a line as wide as that [m]
    marks_.strokeWidth = width;
    show(marks_.stroke, std::move(points));
  }
  void setDots(std::vector<ToolDot> dots) { show(marks_.dots, std::move(dots)); }
  void setArrow(const Vec2& from, const Vec2& to) { show(marks_.arrow, std::pair(from, to)); }
  /// A small dark box beside a point.
  void setTag(const Vec2& at, const QString& text) { show(marks_.tag, std::pair(at, text)); }
  /// The point of another entity that holds.
  void setSnapMark(const std::optional<Vec2>& at) { show(marks_.snapMark, at); }
  void clear() { show(marks_, Marks()); }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paintOutline(QPainter& painter) const;
  void paintStroke(QPainter& painter) const;
  void paintDots(QPainter& painter) const;
  void paintLine(QPainter& painter) const;
  void paintArrow(QPainter& painter) const;
  void paintTag(QPainter& painter) const;
  void paintSnapMark(QPainter& painter) const;

  struct Marks {
    std::optional<QRectF> band;
    std::vector<Vec2> line;  // dashed
    ToolLine outline;
    std::vector<Vec2> stroke;
    double strokeWidth = 0.1;  // [m]
    std::vector<ToolDot> dots;
    std::optional<std::pair<Vec2, Vec2>> arrow;
    std::optional<std::pair<Vec2, QString>> tag;
    std::optional<Vec2> snapMark;
  };
  template <class Mark, class Value>
  void show(Mark& mark, Value&& value) {
    mark = std::forward<Value>(value);
    update();
  }

  Marks marks_;
};

QSizeF labelSize(const Theme& theme, const Label& label);

}  // namespace editor

#include <algorithm>

#include "editor/canvas/EntityItem.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/SpriteAtlas.h"
#include "editor/document/PersonLook.h"
#include "sim2d/scenario/Defaults.h"

namespace editor {

namespace {

constexpr double kNameZoomPx = 12.0;     // width of a figure from which names are shown
constexpr std::size_t kMostExact = 8;    // selected people that are not drawn from sprites
constexpr std::size_t kMostNamed = 100;  // selected people who are named at any zoom

class PersonItem : public EntityItem {
 public:
  using EntityItem::EntityItem;
  double distanceTo(const Vec2& world) const override {
    const double reach = std::max(radius_, metres(kLeastFigurePx));
    return std::max(0.0, (world - human_.initPose.position).norm() - reach);
  }

  std::vector<Label> labels() const override {
    const double radiusPx = radius_ * mapScene().pixelsPerMetre();
    const bool isChosen = isSelectedEntity();
    const bool isOneOfFew = isChosen && mapScene().document().selection().size() <= kMostNamed;
    const bool isAlways =
        isOneOfFew || (2.0 * radiusPx >= kNameZoomPx && mapScene().options().names);
    if (!isAlways && !isHovered()) {
      return {};
    }
    const bool isNeeded = !isAlways || (isChosen && mapScene().document().selection().size() == 1);
    const double clearance = std::max(radiusPx, kLeastFigurePx) + (isChosen ? 12.0 : 4.0);
    return {{QString::fromStdString(human_.name), look_,
             MapScene::sceneFromWorld(human_.initPose.position), clearance, isChosen ? 3 : 1,
             isChosen, !isAlways, isNeeded}};
  }

  std::vector<QRectF> solidParts() const override {
    const double reach = std::max(radius_, metres(kLeastFigurePx));
    return {around(MapScene::sceneFromWorld(human_.initPose.position), 0.9 * reach)};
  }

  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    if (mapScene().options().proxemics && isSelectedEntity()) {
      paintSpaces(*painter);
    }
    const double radiusPx = std::max(radius_ * pixelsPerMetreOf(*painter), kLeastFigurePx);
    const PixelFrame frame(*painter, MapScene::sceneFromWorld(human_.initPose.position));
    if (isSelectedEntity() || isHovered()) {
      painter->setBrush(Qt::NoBrush);
      painter->setPen(
          QPen(isSelectedEntity() ? theme().line(look_) : theme().color(Role::Accent, 0.6),
               isSelectedEntity() ? 1.0 : 1.5));
      const double ring = isSelectedEntity() ? radiusPx : radiusPx + 2.5;
      painter->drawEllipse(QPointF(), ring, ring);
    }
    PersonFigure figure;
    figure.look = look_;
    figure.kind = human_.ours.kind.value_or(sim2d::PersonKind::Adult);
    figure.radiusPx = radiusPx;
    figure.headingDeg = degrees(human_.initPose.heading);
    if (isSelectedEntity() && mapScene().document().selection().size() <= kMostExact) {
      FigurePainter(theme()).person(*painter, figure);  // its heading to the degree
    } else {
      mapScene().sprites().draw(*painter, theme(), {{QPointF(), figure}});
    }
  }

 protected:
  void take(const Entity& value) override {
    human_ = std::get<sim2d::Human>(value);
    const sim2d::Scenario& scenario = mapScene().document().scenario();
    radius_ = sim2d::resolveHuman(scenario, human_, scenario.desktop.seed.value_or(1)).radius;
    look_ = lookOfPerson(mapScene().document(), human_);
    setOpacity(human_.listed ? 1.0 : 0.4);
  }

  QRectF bounds(double pixelsPerMetre) const override {
    const double spaces = mapScene().options().proxemics ? 3.7 : 0.0;
    const double reach = std::max({1.5 * radius_, (kLeastFigurePx + 5.0) / pixelsPerMetre, spaces});
    return around(MapScene::sceneFromWorld(human_.initPose.position), reach);
  }

 private:
  void paintSpaces(QPainter& painter) const {
    const QPointF centre = MapScene::sceneFromWorld(human_.initPose.position);
    painter.setPen(Qt::NoPen);
    for (const auto& [reach, alpha] : {std::pair(3.6, 0.05), {1.2, 0.10}, {0.45, 0.18}}) {
      QColor color = theme().fill(look_);
      color.setAlphaF(alpha);
      painter.setBrush(color);
      painter.drawEllipse(centre, reach, reach);
    }
  }

  sim2d::Human human_;
  double radius_ = 0.35;  // [m]
  Look look_ = Look::Regular;
};

}  // namespace

std::unique_ptr<EntityItem> makePersonItem(const MapScene& scene, EntityId id) {
  return std::make_unique<PersonItem>(scene, id);
}

}  // namespace editor

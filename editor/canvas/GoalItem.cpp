#include <algorithm>
#include <cmath>

#include "editor/canvas/EntityItem.h"
#include "editor/canvas/PixelFrame.h"

namespace editor {

namespace {

constexpr double kPinWidthPx = 18.0;
constexpr double kPinHeightPx = 27.0;
constexpr double kGoalRingMetres = 0.3;

class GoalItem : public EntityItem {
 public:
  using EntityItem::EntityItem;
  double distanceTo(const Vec2& world) const override {
    const QPointF offset =
        (MapScene::sceneFromWorld(world) - MapScene::sceneFromWorld(goal_.position)) *
        mapScene().pixelsPerMetre();
    const QPointF head(0.0, -17.0);
    const QPointF fromHead = offset - head;
    const double toHead = std::hypot(fromHead.x(), fromHead.y()) - 0.5 * kPinWidthPx;
    const double toTip = std::hypot(offset.x(), offset.y());
    return metres(std::max(0.0, std::min(toHead, toTip)));
  }

  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    const QPointF tip = MapScene::sceneFromWorld(goal_.position);
    const bool isChosen = isSelectedEntity();
    if (isChosen || isHovered()) {
      QPen pen(theme().color(Role::Accent, isChosen ? 1.0 : 0.6), 1.5);
      makeCosmetic(pen, *painter);
      painter->setPen(pen);
      painter->setBrush(theme().color(Role::Accent, 0.08));
      painter->drawEllipse(tip, kGoalRingMetres, kGoalRingMetres);
    }
    const PixelFrame frame(*painter, tip);
    painter->setPen(Qt::NoPen);
    painter->setBrush(theme().color(Role::Text, 0.25));
    painter->drawEllipse(QPointF(0.0, 0.5), 4.0, 1.6);
    FigurePainter(theme()).pin(*painter, QString::number(goal_.id), isChosen);
  }

  std::vector<QRectF> solidParts() const override {
    const QPointF tip = MapScene::sceneFromWorld(goal_.position);
    return {QRectF(tip.x() - metres(0.5 * kPinWidthPx), tip.y() - metres(kPinHeightPx),
                   metres(kPinWidthPx), metres(kPinHeightPx))};
  }

 protected:
  void take(const Entity& value) override { goal_ = std::get<sim2d::GlobalGoal>(value); }

  QRectF bounds(double pixelsPerMetre) const override {
    const QPointF tip = MapScene::sceneFromWorld(goal_.position);
    const double unit = 1.0 / pixelsPerMetre;
    const QRectF pin(tip.x() - 11.0 * unit, tip.y() - 29.0 * unit, 22.0 * unit, 32.0 * unit);
    return pin | around(tip, kGoalRingMetres + 2.0 * unit);
  }

 private:
  sim2d::GlobalGoal goal_;
};

}  // namespace

std::unique_ptr<EntityItem> makeGoalItem(const MapScene& scene, EntityId id) {
  return std::make_unique<GoalItem>(scene, id);
}

}  // namespace editor

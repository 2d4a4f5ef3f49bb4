#pragma once

#include "editor/canvas/Layers.h"
#include "editor/canvas/Overlays.h"

namespace editor {

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

/// Ring, name and number of people of each group, in a corner where nobody stands; none without
/// groups. Gives the corner, which it leaves only when somebody comes there.
int paintGroupLegend(QPainter& painter, const OverlayContext& context);
/// Where that is [px]; empty when there is no legend.
QRectF groupLegendBox(const OverlayContext& context);

}  // namespace editor

#pragma once

#include "editor/canvas/Tool.h"

namespace editor {

constexpr double kSnapReachPx = 8.0;
constexpr double kSnapGrid = 0.5;              // [m]
constexpr double kSnapAngle = base::kPi / 12;  // 15 degrees

/// What a point that is drawn or moved may come to lie on.
struct SnapWish {
  std::optional<Vec2> anchor;     // with Shift: only at multiples of 15 degrees from here
  std::vector<EntityId> without;  // entities whose points do not count
  std::vector<Vec2> more;         // points of the gesture itself
  bool ontoPoints = true;         // false: grid and angles only
  bool ontoWalls = true;          // and the walls of the map
};

struct Snapped {
  Vec2 point = Vec2::Zero();
  bool isOnPoint = false;  // on one of another entity, or on a wall
};

/// In this order: anywhere with Alt, on an angle with Shift, on a point of another entity within 8
/// px, on half metres with Ctrl, on a corner or edge of the map's walls within 8 px, on half metres
/// while the grid holds, else on whole centimetres. Points, walls and grid as the options of the
/// canvas say.
Snapped snapped(const MapScene& scene, const CanvasMouse& mouse, const SnapWish& wish = {});

/// The place on the border of the map's walls nearest to `world`, none beyond `reach` [m]: a corner
/// where there is one within reach, else anywhere on an edge. The steps that cells make along a
/// slanted wall are no corners. Looks only at the cells near by.
std::optional<Vec2> nearestOnWalls(const sim2d::OccupancyGrid& grid, const Vec2& world,
                                   double reach);

/// The points of an entity that others snap to: corners, ends, centres; none of people.
std::vector<Vec2> snapPointsOf(const Entity& entity);
/// The heading in steps, of 15 degrees or others [rad].
double snappedAngle(double heading, double step = kSnapAngle);

}  // namespace editor

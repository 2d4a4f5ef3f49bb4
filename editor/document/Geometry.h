#pragma once

#include <vector>

#include "editor/document/Entity.h"

namespace editor {

/// Extent along the axes [m].
struct Extent {
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();
  Vec2 centre() const { return 0.5 * (low + high); }
};

/// Nothing for no points.
std::optional<Extent> extentOf(const std::vector<Vec2>& points);
/// Of the outline; people and robots by their place alone. Nothing for the settings.
std::optional<Extent> extentOf(const Entity& entity);
/// The corners of an obstacle, area, or a wall's line; null for what has none.
std::vector<Vec2>* cornersOf(Entity& entity);
const std::vector<Vec2>* cornersOf(const Entity& entity);
/// Fewer corners make no shape: 2 for walls, else 3.
std::size_t fewestCorners(const Entity& entity);
/// The edge of an outline within `reach` of a point, by its first corner.
std::optional<std::size_t> edgeNear(const Entity& entity, const Vec2& point, double reach);
bool hasOpenLine(const Entity& entity);  // a wall: its ends are not joined

/// To the micrometre: sums of steps would otherwise be written as 12.629999999999999.
double rounded(double metres);
Vec2 rounded(const Vec2& point);

/// A spot of a selected entity that can be dragged.
struct Handle {
  enum class Kind { None, Turn, Size, Vertex, RobotGoal };
  Kind kind = Kind::None;
  int index = 0;                 // corner or vertex
  Vec2 position = Vec2::Zero();  // world [m]
};

/// Sizes that the canvas knows and the entity does not.
struct HandleSizes {
  double bodyRadius = 0.35;   // of a person [m], as drawn
  double turnDistance = 1.0;  // of the turn handle from the centre [m]
};

std::vector<Handle> handlesOf(const Entity& entity, const HandleSizes& sizes);
/// The entity with the handle pulled to `to`; turns and sizes in steps of 1 degree and 1 cm unless
/// `fine`.
Entity pulled(const Entity& entity, const Handle& handle, const Vec2& to, bool fine);

}  // namespace editor

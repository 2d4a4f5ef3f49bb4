#pragma once

#include <vector>

#include "editor/document/Entity.h"

namespace editor {

/// Axis-aligned bounding box [m].
struct Extent {
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();
  Vec2 centre() const { return 0.5 * (low + high); }
};

/// None if there are no points.
std::optional<Extent> extentOf(const std::vector<Vec2>& points);
/// Bounding box of the outline; for people and robots of the position alone. None for the settings.
std::optional<Extent> extentOf(const Entity& entity);
/// The corners of an obstacle or area, or the points of a wall; null for other entities.
std::vector<Vec2>* cornersOf(Entity& entity);
const std::vector<Vec2>* cornersOf(const Entity& entity);
/// Minimum number of corners of a shape: 2 for walls, else 3.
std::size_t minimumCorners(const Entity& entity);
/// The outline edge within `reach` of a point, as the index of its first corner.
std::optional<std::size_t> outlineEdgeAt(const Entity& entity, const Vec2& point, double reach);
bool isOpenPolyline(const Entity& entity);  // True for a wall, whose ends are not joined.

/// Rounded to micrometres; otherwise sums of steps are written as 12.629999999999999.
double rounded(double metres);
Vec2 rounded(const Vec2& point);

/// A draggable handle of a selected entity.
struct Handle {
  enum class Kind { None, Turn, Size, Vertex, RobotGoal };
  Kind kind = Kind::None;
  int index = 0;                 // Index of the corner or vertex.
  Vec2 position = Vec2::Zero();  // World frame [m].
};

/// Sizes that depend on the canvas, not on the entity.
struct HandleSizes {
  double bodyRadius = 0.35;   // Radius of a person as drawn [m].
  double turnDistance = 1.0;  // Distance of the rotation handle from the centre [m].
};

std::vector<Handle> handlesOf(const Entity& entity, const HandleSizes& sizes);
/// The entity after its handle is dragged to `to`. Angles and sizes are rounded to 1 degree and 1
/// cm unless `fine`.
Entity withHandleMoved(const Entity& entity, const Handle& handle, const Vec2& to, bool fine);

}  // namespace editor

#pragma once

#include <vector>

#include "editor/document/Entity.h"

namespace editor {

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

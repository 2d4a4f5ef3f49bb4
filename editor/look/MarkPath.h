#pragma once

#include <QPainterPath>

#include "editor/look/Theme.h"

namespace editor {

/// Outline of a behaviour's mark, centred at the origin, of equal optical weight. A ring is its
/// outer circle.
QPainterPath markPath(Mark mark, double sizePx);

}  // namespace editor

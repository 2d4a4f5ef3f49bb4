#pragma once

#include <optional>

#include <QPointF>

#include "bt/tree/TreeSpec.h"

namespace editor {

/// Where an editor of trees has left a node, by attributes that the engine ignores: `_x` and `_y`,
/// or `_pos` or `_position` with "x;y" or "x,y" [px, y down]. Nothing: the file does not say.
std::optional<QPointF> placeInFile(const bt::NodeSpec& node);

}  // namespace editor

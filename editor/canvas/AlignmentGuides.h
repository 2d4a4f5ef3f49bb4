#pragma once

#include <array>

#include "editor/document/Entity.h"

namespace editor {

/// The distance between two neighbours along an axis, shown with its length.
struct AlignmentGap {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();  // World frame [m].
};

/// The correction that aligns a dragged bounding box with other bounding boxes, and the guides that
/// explain it. World frame.
struct Alignment {
  Vec2 offset = Vec2::Zero();                // Correction [m]; 0 along axes without alignment.
  std::array<bool, 2> isAligned = {};        // Along x, along y.
  std::vector<std::pair<Vec2, Vec2>> lines;  // Through aligned edges and centres.
  std::vector<AlignmentGap> gaps;  // To the nearest aligned box, or between equally spaced boxes.
};

/// Aligns edges and centres of `moving` with those of `others` within `reach` [m], or makes its
/// distances to its neighbours in the same row or column equal. Along each axis the smallest
/// correction is used. Points are boxes without a size.
Alignment alignmentOf(const Extent& moving, const std::vector<Extent>& others, double reach);

/// The bounding box translated by `delta`.
inline Extent movedBy(const Extent& extent, const Vec2& delta) {
  return {extent.low + delta, extent.high + delta};
}

}  // namespace editor

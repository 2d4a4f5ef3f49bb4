#include "editor/tools/SelectionActions.h"

#include <algorithm>

#include "editor/document/EditCommands.h"
#include "editor/document/Geometry.h"

namespace editor {

void duplicateSelection(ScenarioDocument& document) {
  document.setSelection(pushDuplicate(document, document.selection(), Vec2(0.8, -0.8)));
}

void selectAll(ScenarioDocument& document) {
  std::vector<EntityId> all;
  forEachList(document.scenario(), [&all](EntityKind /*kind*/, const auto& list) {
    for (const auto& value : list) {
      all.push_back(value.key);
    }
  });
  document.setSelection(std::move(all));
}

namespace {

struct Piece {
  Entity value;
  Extent extent;
};

std::vector<Piece> piecesOf(const ScenarioDocument& document) {
  std::vector<Piece> pieces;
  for (Entity& value : valuesOf(document, document.selection())) {
    if (const std::optional<Extent> extent = extentOf(value)) {
      pieces.push_back({std::move(value), *extent});
    }
  }
  return pieces;
}

Extent wholeOf(const std::vector<Piece>& pieces) {
  std::vector<Vec2> corners;
  for (const Piece& piece : pieces) {
    corners.insert(corners.end(), {piece.extent.low, piece.extent.high});
  }
  return *extentOf(corners);
}

/// The corner or middle by which pieces are aligned.
Vec2 placeOf(const Extent& extent, Align how) {
  if (how == Align::CentreX || how == Align::CentreY) {
    return extent.centre();
  }
  return how == Align::Right || how == Align::Top ? extent.high : extent.low;
}

}  // namespace

void alignSelection(ScenarioDocument& document, Align how) {
  const std::vector<Piece> pieces = piecesOf(document);
  if (pieces.size() < 2) {
    return;
  }
  const Extent whole = wholeOf(pieces);
  std::vector<Entity> values;
  for (const Piece& piece : pieces) {
    Vec2 offset = placeOf(whole, how) - placeOf(piece.extent, how);
    offset(how < Align::Top ? 1 : 0) = 0.0;  // along one axis
    values.push_back(moved(piece.value, offset));
  }
  pushEdit(document, std::move(values), QObject::tr("Align"));
}

void distributeSelection(ScenarioDocument& document, Distribute how) {
  std::vector<Piece> pieces = piecesOf(document);
  if (pieces.size() < 3) {
    return;
  }
  const int axis = how == Distribute::Across ? 0 : 1;
  std::stable_sort(pieces.begin(), pieces.end(), [axis](const Piece& a, const Piece& b) {
    return a.extent.centre()(axis) < b.extent.centre()(axis);
  });
  const Extent whole = wholeOf(pieces);
  double room = whole.high(axis) - whole.low(axis);
  for (const Piece& piece : pieces) {
    room -= piece.extent.high(axis) - piece.extent.low(axis);
  }
  const double gap = room / double(pieces.size() - 1);
  std::vector<Entity> values;
  double at = whole.low(axis);
  for (const Piece& piece : pieces) {
    Vec2 offset = Vec2::Zero();
    offset(axis) = at - piece.extent.low(axis);
    at += piece.extent.high(axis) - piece.extent.low(axis) + gap;
    values.push_back(moved(piece.value, offset));
  }
  pushEdit(document, std::move(values), QObject::tr("Distribute"));
}

void rotateSelection(ScenarioDocument& document, double angle) {
  const std::vector<Piece> pieces = piecesOf(document);
  if (pieces.empty()) {
    return;
  }
  const Vec2 centre = wholeOf(pieces).centre();
  std::vector<Entity> values;
  values.reserve(pieces.size());
  for (const Piece& piece : pieces) {
    values.push_back(rotated(piece.value, centre, angle));
  }
  pushEdit(document, std::move(values), QObject::tr("Rotate"));
}

}  // namespace editor

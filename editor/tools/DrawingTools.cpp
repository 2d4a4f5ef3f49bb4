#include "editor/tools/DrawingTools.h"

#include <cmath>

#include "editor/document/EditCommands.h"
#include "sim2d/map/Outlines.h"

namespace editor {

namespace {

constexpr double kSameCorner = 0.01;  // [m]
constexpr double kMinArea = 0.01;     // [m²]

bool isSame(const Vec2& a, const Vec2& b) {
  return (a - b).norm() < kSameCorner;
}

}  // namespace

EntityId previewIdOf(EntityKind kind) {
  return {kind, -1};
}

void addDrawnEntity(ScenarioDocument& document, Entity value) {
  const QString kind = kindName(value);
  setName(value, UniqueNames(document.scenario()).name(nameStem(value)));
  document.setSelection(
      pushAdd(document, std::vector<Entity>{std::move(value)}, QObject::tr("Add %1").arg(kind)));
}

QString CornerDrawingTool::statusText() const {
  if (!problem_.isEmpty()) {
    return tr("%1 · Backspace removes the last corner · Esc cancels").arg(problem_);
  }
  if (corners_.empty()) {
    return idleText();
  }
  return tr(
      "Click the next corner · Enter or double-click finishes · Backspace removes the last corner "
      "· Esc cancels");
}

QString CornerDrawingTool::problemOf(const Corners& corners) const {
  if (corners.size() < 3) {
    return tr("At least three corners are required");
  }
  if (!sim2d::isSimple(corners)) {
    return tr("The edges cross");
  }
  return std::abs(sim2d::signedArea(corners)) < kMinArea ? tr("Too small") : QString();
}

CornerDrawingTool::Corners CornerDrawingTool::draggedCorners(const Vec2& from,
                                                             const Vec2& to) const {
  return {from, Vec2(to.x(), from.y()), to, Vec2(from.x(), to.y())};
}

Vec2 CornerDrawingTool::cursorFor(const CanvasMouse& mouse) const {
  SnapRequest wish;
  if (!corners_.empty()) {
    wish.anchor = corners_.back();
    wish.more = {corners_.front()};
  }
  return snap(mouse, wish);
}

void CornerDrawingTool::addCorner(const Vec2& point) {
  if (corners_.empty() || !isSame(corners_.back(), point)) {
    corners_.push_back(point);
  }
}

void CornerDrawingTool::pressOther(Qt::MouseButton button) {
  if (button == Qt::RightButton) {
    finish(corners_);
  }
}

void CornerDrawingTool::press(const CanvasMouse& mouse) {
  problem_.clear();
  cursor_ = cursorFor(mouse);
  const auto distancePx = [&] {
    return (cursor_ - corners_.front()).norm() * mouse.pixelsPerMetre;
  };
  if (corners_.size() > 2 && distancePx() <= kSnapReachPx) {
    Corners closed = corners_;
    if (!isClosed()) {
      closed.push_back(corners_.front());
    }
    finish(closed);
    return;
  }
  pressed_ = true;
  pressedAt_ = mouse.world;
  addCorner(cursor_);
  show();
}

void CornerDrawingTool::move(const CanvasMouse& mouse) {
  cursor_ = cursorFor(mouse);
  if (!corners_.empty()) {
    show();
  }
}

void CornerDrawingTool::release(const CanvasMouse& mouse) {
  if (!pressed_) {
    return;
  }
  pressed_ = false;
  if (corners_.empty() || !isDrag(pressedAt_, mouse)) {
    return;
  }
  cursor_ = cursorFor(mouse);
  if (corners_.size() == 1) {
    finish(draggedCorners(corners_.front(), cursor_));
  } else {
    addCorner(cursor_);
    show();
  }
}

bool CornerDrawingTool::keyPress(const QKeyEvent& event) {
  if (corners_.empty()) {
    return false;
  }
  if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
    finish(corners_);
    return true;
  }
  if (event.key() == Qt::Key_Backspace) {
    problem_.clear();
    corners_.pop_back();
    corners_.empty() ? cancel() : show();
    return true;
  }
  return false;
}

void CornerDrawingTool::show() {
  Corners shape = corners_;
  if (pressed_ && corners_.size() == 1 && !isSame(cursor_, corners_.front())) {
    shape = draggedCorners(corners_.front(), cursor_);
  } else if (!isSame(cursor_, corners_.back())) {
    shape.push_back(cursor_);
  }
  const bool isReady = problemOf(shape).isEmpty();
  if (isReady) {
    preview(shape);
  } else {
    scene().clearPreview();
    marks().dots.clear();
  }
  const bool isCrossing = isClosed() && shape.size() > 3 && !isReady;
  marks().outline = {shape, isClosed(), isCrossing, true};
  if (!isSame(cursor_, corners_.back())) {
    marks().tag = {cursor_, legText(corners_.back(), cursor_)};
  }
  Q_EMIT statusTextChanged();
}

void CornerDrawingTool::finish(const Corners& corners) {
  if (corners.empty()) {
    return;
  }
  problem_ = problemOf(corners);
  if (problem_.isEmpty()) {
    const Corners drawn(corners.begin(), corners.end());  // cancel() clears corners_.
    cancel();
    make(drawn);
  } else if (corners_.size() < 3) {
    cancel();  // Clicks at a single position have no effect.
  } else {
    Q_EMIT statusTextChanged();
  }
}

void CornerDrawingTool::cancel() {
  corners_.clear();
  problem_.clear();
  pressed_ = false;
  clearMarks();
}

}  // namespace editor

#include "editor/tools/MeasureTool.h"

#include "editor/canvas/Layers.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/Tool.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

QString MeasureTool::statusText() const {
  if (!span_) {
    return tr("Drag from one point to another · Shift: 15° steps");
  }
  const Vec2 way = span_->second - span_->first;
  return tr("Distance %1 m · angle %2 · across %3 m · up %4 m")
      .arg(way.norm(), 0, 'f', 3)
      .arg(headingText(base::headingOf(way)))
      .arg(way.x(), 0, 'f', 3)
      .arg(way.y(), 0, 'f', 3);
}

void MeasureTool::press(const CanvasMouse& mouse) {
  cancel();
  if (mouse.button != Qt::LeftButton) {
    return;
  }
  const Vec2 at = snap(mouse, {});
  span_ = {at, at};
  pressedAt_ = mouse.world;
  pressed_ = true;
}

void MeasureTool::move(const CanvasMouse& mouse) {
  if (!pressed_) {
    snap(mouse, {});
    return;
  }
  SnapWish wish;
  wish.anchor = span_->first;
  span_->second = snap(mouse, wish);
  show();
}

void MeasureTool::release(const CanvasMouse& mouse) {
  if (mouse.button != Qt::LeftButton || !pressed_) {
    return;
  }
  move(mouse);
  pressed_ = false;
  if (!isDrag(pressedAt_, mouse)) {
    cancel();
  }
}

void MeasureTool::show() {
  ToolLine line;
  line.points = {span_->first, span_->second};
  scene().toolLayer().setOutline(std::move(line));
  scene().toolLayer().setTag(span_->second, legText(span_->first, span_->second));
  Q_EMIT statusTextChanged();
}

void MeasureTool::cancel() {
  span_.reset();
  pressed_ = false;
  scene().toolLayer().clear();
  Q_EMIT statusTextChanged();
}

void addMeasureTool(ToolRegistry& to) {
  to.add<MeasureTool>({150, QObject::tr("Measure"), QStringLiteral("tool-measure"), Qt::Key_M});
}

}  // namespace editor

#include "editor/canvas/MapView.h"
#include "editor/tools/ToolRegistry.h"

// Tools that change nothing.

namespace editor {

namespace {

/// Measures distance and angle by a drag; the line stays until the next one.
class MeasureTool : public Tool {
  Q_DECLARE_TR_FUNCTIONS(editor::MeasureTool)
 public:
  using Tool::Tool;

  QString statusText() const override {
    if (!span_) {
      return tr("Drag from one point to another · Shift: 15° steps");
    }
    const Vec2 way = span_->second - span_->first;
    return tr("Distance %1 m · angle %2 · Δx %3 m · Δy %4 m")
        .arg(way.norm(), 0, 'f', 3)
        .arg(headingText(base::headingOf(way)))
        .arg(way.x(), 0, 'f', 3)
        .arg(way.y(), 0, 'f', 3);
  }

  void pressOther(Qt::MouseButton) override { cancel(); }
  void press(const CanvasMouse& mouse) override {
    cancel();
    const Vec2 at = snap(mouse, {});
    span_ = {at, at};
    pressedAt_ = mouse.world;
    pressed_ = true;
  }

  void move(const CanvasMouse& mouse) override {
    if (!pressed_) {
      snap(mouse, {});
      return;
    }
    span_->second = snap(mouse, {span_->first});
    marks().outline.points = {span_->first, span_->second};
    marks().tag = {span_->second, legText(span_->first, span_->second)};
    Q_EMIT statusTextChanged();
  }

  void release(const CanvasMouse& mouse) override {
    if (!pressed_) {
      return;
    }
    move(mouse);
    pressed_ = false;
    if (!isDrag(pressedAt_, mouse)) {
      cancel();
    }
  }

  void cancel() override {
    span_.reset();
    pressed_ = false;
    clearMarks();
  }

 private:
  std::optional<std::pair<Vec2, Vec2>> span_;  // Start and end; none before the first drag.
  Vec2 pressedAt_ = Vec2::Zero();
  bool pressed_ = false;
};

/// The left button pans the map. The views implement it.
class PanTool : public Tool {
  Q_DECLARE_TR_FUNCTIONS(editor::PanTool)
 public:
  using Tool::Tool;

  QString statusText() const override { return tr("Drag to move the map · Wheel zooms"); }
  QCursor cursor() const override { return Qt::OpenHandCursor; }
  void activate() override { setLeftButtonPan(true); }
  void deactivate() override { setLeftButtonPan(false); }
  void press(const CanvasMouse&) override {}
  void move(const CanvasMouse&) override {}
  void release(const CanvasMouse&) override {}
  void cancel() override {}

 private:
  void setLeftButtonPan(bool on) {
    for (QGraphicsView* view : scene().views()) {
      if (auto* mapView = qobject_cast<MapView*>(view)) {
        mapView->setLeftButtonPan(on);
      }
    }
  }
};

}  // namespace

void addViewTool(ToolRegistry& to) {
  to.add<MeasureTool>({150, QObject::tr("Measure"), QStringLiteral("tool-measure"), Qt::Key_M});
  to.add<PanTool>({170, QObject::tr("Pan"), QStringLiteral("tool-pan"), Qt::Key_H});
}

}  // namespace editor

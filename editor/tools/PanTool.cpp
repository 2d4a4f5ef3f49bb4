#include "editor/canvas/MapView.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

namespace {

/// The left button pans the map. The views implement it.
class PanTool : public Tool {
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

void addPanTool(ToolRegistry& to) {
  to.add<PanTool>({170, QObject::tr("Pan"), QStringLiteral("tool-pan"), Qt::Key_H});
}

}  // namespace editor

#include "editor/canvas/MapView.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

namespace {

/// The left button moves the map. The views do the work.
class PanTool : public Tool {
 public:
  using Tool::Tool;

  QString statusText() const override { return tr("Drag to move the map · Wheel zooms"); }
  QCursor cursor() const override { return Qt::OpenHandCursor; }
  void activate() override { setHandPan(true); }
  void deactivate() override { setHandPan(false); }
  void press(const CanvasMouse&) override {}
  void move(const CanvasMouse&) override {}
  void release(const CanvasMouse&) override {}
  void cancel() override {}

 private:
  void setHandPan(bool on) {
    for (QGraphicsView* view : scene().views()) {
      if (auto* mapView = qobject_cast<MapView*>(view)) {
        mapView->setHandPan(on);
      }
    }
  }
};

}  // namespace

void addPanTool(ToolRegistry& to) {
  to.add<PanTool>({170, QObject::tr("Pan"), QStringLiteral("tool-pan"), Qt::Key_H});
}

}  // namespace editor

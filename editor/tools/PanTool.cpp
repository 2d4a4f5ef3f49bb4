#include "editor/tools/PanTool.h"

#include "editor/canvas/MapView.h"

namespace editor {

void PanTool::setHandPan(bool on) {
  for (QGraphicsView* view : scene().views()) {
    if (auto* mapView = qobject_cast<MapView*>(view)) {
      mapView->setHandPan(on);
    }
  }
}

}  // namespace editor

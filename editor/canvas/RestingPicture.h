#pragma once

#include <vector>

#include <QPixmap>
#include <QTransform>

#include "editor/canvas/MapScene.h"

namespace editor {

/// A picture of what rests on a crowded canvas, kept while something is dragged or the view moves,
/// so that only little has to be painted anew for each frame.
class RestingPicture {
 public:
  /// Where and how a view looks at the scene.
  struct Window {
    QTransform fromScene;
    QSize size;          // [px]
    double ratio = 1.0;  // device pixels per pixel
  };
  /// Whether it shows what `window` shows now; `exactly`: at the same place and scale too,
  /// otherwise the window lies inside of it and the scales differ little.
  bool fits(const MapScene& scene, const Window& window, bool exactly) const;
  /// Takes the picture, `margin` pixels larger than the window on each side.
  void take(MapScene& scene, const Window& window, int margin);
  void draw(QPainter& painter, const Window& window) const;  // painter in window pixels
  void clear() { *this = {}; }

 private:
  QPixmap pixmap_;
  QTransform fromScene_;          // to pixels of the picture
  int margin_ = 0;                // [px]
  int revision_ = -1;             // of the scene
  std::vector<EntityId> moving_;  // what is not in it
};

}  // namespace editor

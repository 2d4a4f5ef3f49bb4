#pragma once

#include "editor/canvas/Tool.h"
#include "editor/document/MapEdit.h"

namespace editor {

/// Cells of the map under a brush become wall, free or unknown; one command per stroke. Shift
/// paints free ground, whatever is chosen; 1, 2 and 3 choose, brackets make the brush smaller and
/// larger.
class MapPaintTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  QString statusText() const override;
  void press(const CanvasMouse& mouse) override;
  void move(const CanvasMouse& mouse) override;
  void release(const CanvasMouse& mouse) override;
  void cancel() override;
  bool keyPress(const QKeyEvent& event) override;
  QWidget* makeOptions(QWidget* parent) override;

  MapPaint paint() const { return paint_; }
  void setPaint(MapPaint paint);
  double width() const { return width_; }
  void setWidth(double metres);

 private:
  MapPaint paintFor(const CanvasMouse& mouse) const;
  void show(const Vec2& at);

  MapPaint paint_ = MapPaint::Occupied;
  double width_ = 0.2;               // of the brush [m]
  std::optional<MapStroke> stroke_;  // while a gesture lasts
  std::vector<Vec2> way_;
  MapPaint strokePaint_ = MapPaint::Occupied;
};

}  // namespace editor

#pragma once

#include "editor/canvas/Tool.h"
#include "editor/tools/Crowd.h"

namespace editor {

/// People along a drag, looking where it goes, one every `spacing` metres and up to half of `width`
/// beside it. A click places one. Those without room are left out.
class BrushTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  QString statusText() const override;
  QWidget* makeOptions(QWidget* parent) override;
  void press(const CanvasMouse& mouse) override;
  void move(const CanvasMouse& mouse) override;
  void release(const CanvasMouse& mouse) override;
  void cancel() override;

  void setRecipe(const CrowdRecipe& recipe) { recipe_ = recipe; }
  void setSpacing(double metres) { spacing_ = metres; }
  void setWidth(double metres) { width_ = metres; }

 private:
  void lay(const Vec2& at, double heading);
  void layAlong(const Vec2& world);
  void show();

  CrowdRecipe recipe_;
  double spacing_ = 1.0;              // [m]
  double width_ = 0.0;                // [m]
  std::optional<FreeGround> ground_;  // while a gesture lasts
  std::vector<sim2d::Human> people_;
  Vec2 last_ = Vec2::Zero();  // place on the drag of the last one
  int drawn_ = 0;             // people drawn by the recipe so far
};

}  // namespace editor

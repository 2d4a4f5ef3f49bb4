#pragma once

#include "editor/tools/Crowd.h"
#include "editor/tools/Drawing.h"

namespace editor {

/// People along a drag, looking where it goes, one every `spacing` metres and up to half of `width`
/// beside it. A click places one. Those without room are left out.
class BrushTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  QString statusText() const override;
  QWidget* makeOptions(QWidget* parent) override;
  void pressOther(Qt::MouseButton) override { cancel(); }
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
  QString result_;            // of the last drag, when not all had room
};

/// Fills a polygon with people; as many as fit when there is too little room. The people are shown
/// while the polygon grows.
class FillTool : public CornerDrawing {
  Q_OBJECT
 public:
  using CornerDrawing::CornerDrawing;

  QWidget* makeOptions(QWidget* parent) override;

  std::size_t count() const { return count_; }
  void setCount(std::size_t count) { count_ = count; }
  void setRecipe(const CrowdRecipe& recipe) { recipe_ = recipe; }

 protected:
  QString idleText() const override;
  void preview(const Corners& corners) override;
  void make(const Corners& corners) override;

 private:
  CrowdRecipe recipe_;
  std::size_t count_ = 20;
  QString result_;  // of the last fill, when not all had room
};

}  // namespace editor

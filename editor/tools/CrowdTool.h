#pragma once

#include "editor/tools/CrowdGenerator.h"
#include "editor/tools/DrawingTools.h"

namespace editor {

/// Places people along a drag, facing its direction, one every `spacing` metres and up to half of
/// `width` beside it. A click places one person. Positions without free space are skipped.
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
  void placeAt(const Vec2& at, double heading);
  void placeAlong(const Vec2& world);
  void show() {
    showCrowd(scene(), people_);
    Q_EMIT statusTextChanged();
  }

  CrowdRecipe recipe_;
  double spacing_ = 1.0;             // [m]
  double width_ = 0.0;               // [m]
  std::optional<FreeSpace> ground_;  // Exists during a gesture.
  std::vector<sim2d::Human> people_;
  Vec2 last_ = Vec2::Zero();  // Position of the last person along the drag.
  int drawn_ = 0;             // Number of people drawn by the recipe so far.
  QString result_;            // Message after a drag in which some people found no space.
};

/// Fills a polygon with people, or with as many as fit. The people are shown while the polygon is
/// drawn.
class FillTool : public CornerDrawingTool {
  Q_OBJECT
 public:
  using CornerDrawingTool::CornerDrawingTool;

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
  QString result_;  // Message after a fill in which some people found no space.
};

}  // namespace editor

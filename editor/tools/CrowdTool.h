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
  /// Person number `drawn` of this gesture.
  sim2d::Human sampled(int drawn) const;
  void show() {
    showCrowd(scene(), {people_, {}});
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

/// Fills a polygon with people, or with as many as fit, and with goals if the scenario has none.
/// The people are shown while the polygon is drawn. Until the next command, a change of the options
/// fills the last polygon again.
class FillTool : public CornerDrawingTool {
  Q_OBJECT
 public:
  FillTool(ScenarioDocument& document, MapScene& scene, QObject* parent);

  QWidget* makeOptions(QWidget* parent) override;
  void deactivate() override;

  std::size_t count() const { return count_; }
  void setCount(std::size_t count) { count_ = count; }
  void setRecipe(const CrowdRecipe& recipe) { recipe_ = recipe; }

 protected:
  QString idleText() const override;
  void preview(const Corners& corners) override;
  void make(const Corners& corners) override;

 private:
  void applyOptions();

  CrowdRecipe recipe_;
  std::size_t count_ = 20;
  QString result_;        // Message after a fill in which some people found no space.
  Corners last_;          // The last polygon; empty after any other command.
  bool filling_ = false;  // Commands of this tool are being pushed or undone.
};

}  // namespace editor

#pragma once

#include "editor/tools/Crowd.h"
#include "editor/tools/Drawing.h"

namespace editor {

/// Fills a polygon with people; as many as fit when there is too little room. The people are shown
/// while the polygon grows.
class FillTool : public CornerDrawing {
  Q_OBJECT
 public:
  using CornerDrawing::CornerDrawing;

  QWidget* makeOptions(QWidget* parent) override;

  int count() const { return count_; }
  void setCount(int count) { count_ = count; }
  const CrowdRecipe& recipe() const { return recipe_; }
  void setRecipe(const CrowdRecipe& recipe) { recipe_ = recipe; }

 protected:
  QString idleText() const override;
  void preview(const Corners& corners) override;
  void make(const Corners& corners) override;

 private:
  CrowdRecipe recipe_;
  int count_ = 20;
  QString result_;  // of the last fill, when not all had room
};

}  // namespace editor

#pragma once

#include "editor/tools/CornerTool.h"
#include "editor/tools/Crowd.h"

namespace editor {

/// Fills a polygon with people; as many as fit when there is too little room. The people are shown
/// while the polygon grows.
class FillTool : public CornerTool {
  Q_OBJECT
 public:
  using CornerTool::CornerTool;

  QString name() const override { return tr("Fill"); }
  QString iconName() const override { return QStringLiteral("tool-fill"); }
  QKeySequence shortcut() const override { return QKeySequence(Qt::Key_L); }
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

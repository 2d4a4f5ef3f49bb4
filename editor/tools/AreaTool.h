#pragma once

#include "editor/tools/CornerDrawing.h"

namespace editor {

/// Areas: sources, sinks, waiting areas and exits. A drag makes a rectangle, clicks any polygon;
/// 1 to 4 choose the kind. A source needs somebody whom its people are like: the selected person,
/// else the first one; without people it brings a pattern of its own that takes no part itself.
class AreaTool : public CornerDrawing {
  Q_OBJECT
 public:
  using CornerDrawing::CornerDrawing;

  bool keyPress(const QKeyEvent& event) override;
  QWidget* makeOptions(QWidget* parent) override;

  sim2d::AreaKind kind() const { return kind_; }
  void setKind(sim2d::AreaKind kind);

 Q_SIGNALS:
  void kindChanged(int index);

 protected:
  QString idleText() const override;
  void preview(const Corners& corners) override;
  void make(const Corners& corners) override;

 private:
  sim2d::Area areaOf(const Corners& corners) const;
  const sim2d::Human* pattern() const;
  void makeSource(sim2d::Area area);
  sim2d::AreaKind kind_ = sim2d::AreaKind::Source;
};

constexpr double kSourceRate = 0.5;  // people per second of a new source

}  // namespace editor

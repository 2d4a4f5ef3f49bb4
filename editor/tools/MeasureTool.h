#pragma once

#include "editor/canvas/Tool.h"

namespace editor {

/// Distance and angle by a drag; the line stays until the next one. Changes nothing.
class MeasureTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  QString statusText() const override;
  void press(const CanvasMouse& mouse) override;
  void move(const CanvasMouse& mouse) override;
  void release(const CanvasMouse& mouse) override;
  void cancel() override;

  /// What is measured: from where to where; none before the first drag.
  const std::optional<std::pair<Vec2, Vec2>>& span() const { return span_; }

 private:
  void show();
  std::optional<std::pair<Vec2, Vec2>> span_;
  Vec2 pressedAt_ = Vec2::Zero();
  bool pressed_ = false;
};

}  // namespace editor

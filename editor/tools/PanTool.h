#pragma once

#include "editor/canvas/Tool.h"

namespace editor {

/// The left button moves the map. The views do the work.
class PanTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  QString name() const override { return tr("Pan"); }
  QString iconName() const override { return QStringLiteral("tool-pan"); }
  QKeySequence shortcut() const override { return QKeySequence(Qt::Key_H); }
  QString statusText() const override { return tr("Drag to move the map · Wheel zooms"); }
  QCursor cursor() const override { return Qt::OpenHandCursor; }
  void activate() override { setHandPan(true); }
  void deactivate() override { setHandPan(false); }
  void press(const CanvasMouse&) override {}
  void move(const CanvasMouse&) override {}
  void release(const CanvasMouse&) override {}
  void cancel() override {}

 private:
  void setHandPan(bool on);
};

}  // namespace editor

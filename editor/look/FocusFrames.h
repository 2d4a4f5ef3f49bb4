#pragma once

#include <QFocusFrame>
#include <QPointer>

namespace editor {

/// Draws a frame around the widget with the keyboard focus if the style does not mark it: lists,
/// texts, the map and custom widgets. As in AppStyle, only while the keyboard is used to move the
/// focus. Installed on the application by applyTheme(). GUI thread.
class FocusFrames : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show(QWidget& widget);
  void hide();

  QPointer<QFocusFrame> frame_;  // Deleted with the window that it is in.
};

}  // namespace editor

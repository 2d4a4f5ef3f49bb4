#pragma once

#include <QObject>

namespace editor {

/// Wraps long tooltips of widgets and list rows to a readable width; Qt shows plain text in one
/// line. Those of fields begin with the path that is shown in part. Installed on the application by
/// applyTheme(). GUI thread.
class WrappedToolTips : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace editor

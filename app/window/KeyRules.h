#pragma once

#include <QKeyEvent>
#include <QMainWindow>

#include "app/window/Workspace.h"

namespace app {

/// One rule for keys in the whole window, whatever has the focus; `rules` says it.
class KeyRules : public QObject {
  Q_OBJECT
 public:
  KeyRules(QMainWindow& window, Workspace& workspace);  // the window owns it

  /// In the order in which they count, for users too.
  static QStringList rules();

  /// What nobody in the window has wanted.
  void takeLeft(QKeyEvent& event);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool isInWindow(const QWidget& widget) const;
  bool isOfWidget(QWidget& focus, const QKeyEvent& event) const;

  QMainWindow& window_;
  Workspace& workspace_;
};

}  // namespace app

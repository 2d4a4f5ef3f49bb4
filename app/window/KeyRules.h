#pragma once

#include <QKeyEvent>
#include <QMainWindow>

#include "app/window/Workspace.h"

namespace app {

/// One rule for keys in the whole window, whatever has the focus:
/// 1. A text that is being typed has all keys that it uses. Enter finishes it and gives the keyboard
///    back to the canvas; Ctrl+Z is the text's own only while there is something typed.
/// 2. A list has the keys that move in it, and Delete if it has rows to remove; Delete in a list
///    never reaches what is selected on the map, but for the list of the scenario, which is that.
/// 3. Buttons, check boxes and combo boxes do not take the focus from a click. Who goes there by Tab
///    uses them with Space and the arrows.
/// 4. All else belongs to the commands of the window (Space runs and pauses), then to the tool of
///    the canvas.
class KeyRules : public QObject {
  Q_OBJECT
 public:
  KeyRules(QMainWindow& window, Workspace& workspace);  // the window owns it

  /// What nobody in the window has wanted.
  void takeLeft(QKeyEvent& event);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool isOfWidget(QWidget& focus, const QKeyEvent& event) const;

  QMainWindow& window_;
  Workspace& workspace_;
};

}  // namespace app

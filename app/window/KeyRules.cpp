#include "app/window/KeyRules.h"

#include <algorithm>
#include <iterator>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>

#include "editor/panels/ScenarioPanel.h"

namespace app {

namespace {

bool isOnlyClicked(const QWidget& widget) {
  const auto* box = qobject_cast<const QComboBox*>(&widget);
  return qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
         (box != nullptr && !box->isEditable());
}

/// Null: nothing is typed there.
QLineEdit* lineOf(QWidget& widget) {
  if (auto* line = qobject_cast<QLineEdit*>(&widget)) {
    return line;
  }
  const bool hasLine = qobject_cast<QAbstractSpinBox*>(&widget) != nullptr ||
                       qobject_cast<QComboBox*>(&widget) != nullptr;
  return hasLine ? widget.findChild<QLineEdit*>() : nullptr;
}

bool isList(const QWidget& widget) {
  return qobject_cast<const QAbstractItemView*>(&widget) != nullptr;
}

bool isInScenarioPanel(const QWidget& widget) {
  const QWidget* each = &widget;
  while (each != nullptr && qobject_cast<const editor::ScenarioPanel*>(each) == nullptr) {
    each = each->parentWidget();
  }
  return each != nullptr;
}

bool isRemoving(const QKeyEvent& event) {
  return event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace;
}

bool isCursorKey(const QKeyEvent& event) {
  constexpr int kCursorKeys[] = {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up,     Qt::Key_Down,
                                 Qt::Key_Home, Qt::Key_End,   Qt::Key_PageUp, Qt::Key_PageDown};
  return std::count(std::begin(kCursorKeys), std::end(kCursorKeys), event.key()) > 0;
}

/// The row has a box to tick.
bool isTickable(const QWidget& widget) {
  const auto* list = qobject_cast<const QAbstractItemView*>(&widget);
  const QModelIndex row = list == nullptr ? QModelIndex() : list->currentIndex();
  return row.flags().testFlag(Qt::ItemIsUserCheckable) && row.data(Qt::CheckStateRole).isValid();
}

bool isPlainSpace(const QKeyEvent& event) {
  return event.key() == Qt::Key_Space && event.modifiers() == Qt::NoModifier;
}

/// The text, that of a number field it may be, would take it and do nothing.
bool isInVain(const QWidget& widget, const QLineEdit& line, const QKeyEvent& event) {
  return (isPlainSpace(event) && qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr) ||
         (event.matches(QKeySequence::Undo) && !line.isModified()) ||
         (event.matches(QKeySequence::Redo) && !line.isRedoAvailable());
}

bool isEnter(const QKeyEvent& event) {
  return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

}  // namespace

KeyRules::KeyRules(QMainWindow& window, Workspace& workspace)
    : QObject(&window), window_(window), workspace_(workspace) {
  qApp->installEventFilter(this);
}

QStringList KeyRules::rules() {
  return {
      tr("A text that is being typed has all keys that it uses; a number does not use Space. Enter "
         "finishes it and gives the keyboard back to the map, Esc does so without what was typed; "
         "Ctrl+Z is the text's own only while something is typed."),
      tr("A list has the keys that move in it, Space in rows with a box to tick, and Delete if it "
         "has rows to remove. Only from the list of the scenario does Delete reach what is "
         "selected on the map."),
      tr("Buttons, check boxes and choices do not take the keyboard from a click. Who goes "
         "there by Tab uses them with Space and the arrows."),
      tr("All else belongs to the commands of the window, such as Space to run and pause, then "
         "to the tool of the map. Arrows move things only while the map has the keyboard; while a "
         "robot is driven by hand they drive it, as W, A, S and D do.")};
}

/// Whether the widget has a key although it does not say so, and a command waits for it.
bool KeyRules::isOfWidget(QWidget& focus, const QKeyEvent& event) const {
  if (isPlainSpace(event)) {
    return isOnlyClicked(focus) || isTickable(focus) || &focus == &workspace_.view();
  }
  return isRemoving(event) && isList(focus) && !isInScenarioPanel(focus);
}

/// In the window, or in one of its panels that floats: commands of the window act there too.
bool KeyRules::isInWindow(const QWidget& widget) const {
  const QWidget* top = widget.window();
  return top == &window_ ||
         (qobject_cast<const QDockWidget*>(top) != nullptr && top->parentWidget() == &window_);
}

bool KeyRules::eventFilter(QObject* watched, QEvent* event) {
  auto* widget = qobject_cast<QWidget*>(watched);
  if (widget == nullptr || !isInWindow(*widget)) {
    return false;
  }
  // Who was asked for its size before it came into the window was polished there.
  const bool isNew = event->type() == QEvent::Polish || event->type() == QEvent::Show;
  if (isNew && isOnlyClicked(*widget) && widget->focusPolicy() != Qt::NoFocus) {
    widget->setFocusPolicy(Qt::TabFocus);
  }
  if (event->type() == QEvent::FocusIn) {
    if (QLineEdit* line = lineOf(*widget)) {
      line->setModified(false);  // what was typed earlier is undone by the command of the window
    }
  }
  if (event->type() != QEvent::ShortcutOverride) {
    return false;
  }
  auto& key = static_cast<QKeyEvent&>(*event);
  const QLineEdit* line = lineOf(*widget);
  if (line != nullptr && isInVain(*widget, *line, key)) {
    key.ignore();
    return true;
  }
  if (isOfWidget(*widget, key)) {
    key.accept();
    return true;
  }
  return false;
}

void KeyRules::takeLeft(QKeyEvent& event) {
  QWidget* focus = window_.focusWidget();
  editor::MapView& view = workspace_.view();
  if (!view.isVisible() || focus == nullptr || focus == &view) {
    return;  // the tool has seen it
  }
  if (QLineEdit* line = lineOf(*focus)) {
    const bool isLeft = event.key() == Qt::Key_Escape;
    while (isLeft && line->isUndoAvailable()) {
      line->undo();
    }
    if (isEnter(event) || isLeft) {
      view.setFocus();
      event.accept();
    }
    return;
  }
  const bool isOfList = isRemoving(event) && isList(*focus);
  if (!isOfList && !isCursorKey(event)) {  // at its ends a list has nothing for the arrows to do
    QCoreApplication::sendEvent(&view.mapScene(), &event);
  }
}

}  // namespace app

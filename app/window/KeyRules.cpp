#include "app/window/KeyRules.h"

#include <exception>
#include <iterator>

#include "app/window/StartPage.h"
#include "editor/panels/ScenarioPanel.h"
#include "sim2d/base/JsonText.h"

namespace app {

namespace {

bool isButtonLike(const QWidget& widget) {
  const auto* box = qobject_cast<const QComboBox*>(&widget);
  return qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
         (box != nullptr && !box->isEditable());
}

/// The text field of a widget; null: none.
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

/// Whether the current row is checkable.
bool isTickable(const QWidget& widget) {
  const auto* list = qobject_cast<const QAbstractItemView*>(&widget);
  const QModelIndex row = list == nullptr ? QModelIndex() : list->currentIndex();
  return row.flags().testFlag(Qt::ItemIsUserCheckable) && row.data(Qt::CheckStateRole).isValid();
}

bool isPlainSpace(const QKeyEvent& event) {
  return event.key() == Qt::Key_Space && event.modifiers() == Qt::NoModifier;
}

/// Whether a text or number field would accept the key without effect.
bool hasNoEffect(const QWidget& widget, const QLineEdit& line, const QKeyEvent& event) {
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
      tr("While you edit text, the text field handles all keys that it uses; number fields do not "
         "use Space. Enter accepts the text, Esc discards it; both return the keyboard focus to "
         "the map. Ctrl+Z undoes typing only while an edit is not accepted."),
      tr("A list handles the keys that move in it, Space in rows with a check box, and Delete if "
         "its rows can be removed. Only in the scenario list does Delete remove the selection on "
         "the map."),
      tr("A click on a button, check box or combo box does not move the keyboard focus. After you "
         "reach one with Tab, use Space and the arrow keys."),
      tr("All other keys go to the commands of the window, such as Space to run and pause, then to "
         "the map tool. The arrow keys move items only while the map has the focus; while you "
         "drive a robot manually, they drive it, as do W, A, S and D.")};
}

/// Whether the widget uses a key that it does not claim and that is also a shortcut.
bool KeyRules::isWidgetKey(QWidget& focus, const QKeyEvent& event) const {
  if (isPlainSpace(event)) {
    return isButtonLike(focus) || isTickable(focus) || &focus == &workspace_.view();
  }
  return isRemoving(event) && isList(focus) && !isInScenarioPanel(focus);
}

/// Whether the widget is in the window or in one of its floating panels, where window shortcuts
/// also apply.
bool KeyRules::isInWindow(const QWidget& widget) const {
  const QWidget* top = widget.window();
  return top == &window_ ||
         (qobject_cast<const QDockWidget*>(top) != nullptr && top->parentWidget() == &window_);
}

/// Keeps the focus where the user can see it.
void KeyRules::adaptFocus(QWidget& widget, QEvent::Type type) {
  // A widget whose size hint was requested earlier was already polished.
  const bool isNew = type == QEvent::Polish || type == QEvent::Show;
  if (isNew && isButtonLike(widget) && widget.focusPolicy() != Qt::NoFocus) {
    widget.setFocusPolicy(Qt::TabFocus);
  }
  const bool isOfPanels =
      qobject_cast<QTabBar*>(&widget) != nullptr && widget.parentWidget() == &window_;
  if (type == QEvent::Move && isOfPanels) {  // Qt moves those without tabs out of the window
    const bool isShown = window_.rect().intersects(widget.geometry());
    widget.setFocusPolicy(isShown ? Qt::TabFocus : Qt::NoFocus);
  }
  if (type == QEvent::Hide && qobject_cast<QDockWidget*>(&widget) != nullptr) {
    editor::MapView& view = workspace_.view();
    if (window_.isVisible() && view.isVisible() && widget.isAncestorOf(window_.focusWidget())) {
      view.setFocus();  // otherwise Qt moves the focus to the next button
    }
  }
}

bool KeyRules::eventFilter(QObject* watched, QEvent* event) {
  auto* widget = qobject_cast<QWidget*>(watched);
  if (widget == nullptr || !isInWindow(*widget)) {
    return false;
  }
  adaptFocus(*widget, event->type());
  if (event->type() == QEvent::FocusIn) {
    if (QLineEdit* line = lineOf(*widget)) {
      line->setModified(false);  // earlier input is undone by the window
    }
  }
  if (event->type() != QEvent::ShortcutOverride) {
    return false;
  }
  auto& key = static_cast<QKeyEvent&>(*event);
  if (startPage_ != nullptr && startPage_->isVisible() && StartPage::isTypedText(key)) {
    key.accept();  // commands without Ctrl or Alt would change what is not shown
    return true;
  }
  const QLineEdit* line = lineOf(*widget);
  if (line != nullptr && hasNoEffect(*widget, *line, key)) {
    key.ignore();
    return true;
  }
  if (isWidgetKey(*widget, key)) {
    key.accept();
    return true;
  }
  return false;
}

void KeyRules::handleUnusedKey(QKeyEvent& event) {
  if (startPage_ != nullptr && startPage_->isVisible()) {
    startPage_->handleKey(event);
    return;
  }
  QWidget* focus = window_.focusWidget();
  editor::MapView& view = workspace_.view();
  if (!view.isVisible() || focus == nullptr || focus == &view) {
    return;  // the tool has received it
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
  if (!isOfList && !isCursorKey(event)) {  // arrow keys have no effect at the ends of a list
    QCoreApplication::sendEvent(&view.mapScene(), &event);
  }
}

bool GuardedApplication::notify(QObject* receiver, QEvent* event) {
  try {
    return QApplication::notify(receiver, event);
  } catch (const std::exception& problem) {
    if (!handler_) {
      throw;
    }
    handler_(base::exceptionMessage(problem));
    return false;
  }
}

}  // namespace app

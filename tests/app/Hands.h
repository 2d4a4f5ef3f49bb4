#pragma once

#include "tests/app/QuietWindow.h"

/// The hands of a user: real events of mouse and keyboard, counted. Message boxes that come up
/// meanwhile are counted as well.
class Hands : public QObject {
 public:
  explicit Hands(app::MainWindow& window) : window_(window) { qApp->installEventFilter(this); }

  int actions() const { return actions_; }  // clicks and drags so far; keys are free
  int boxes() const { return boxes_; }      // message boxes
  bool eventFilter(QObject* object, QEvent* event) override {
    const bool isBox =
        event->type() == QEvent::Show && qobject_cast<QMessageBox*>(object) != nullptr;
    boxes_ += isBox ? 1 : 0;
    return false;
  }
  void countFromHere() { actions_ = 0; }

  void clickOn(QWidget& widget, const QPoint& at, Qt::KeyboardModifiers modifiers = {}) {
    ++actions_;
    QTest::mouseClick(&widget, Qt::LeftButton, modifiers, at);
    QCoreApplication::processEvents();
  }
  void clickMap(const base::Vec2& world, Qt::KeyboardModifiers modifiers = {}) {
    dragMap(world, world, modifiers);
  }
  void dragMap(const base::Vec2& from, const base::Vec2& to, Qt::KeyboardModifiers modifiers = {}) {
    ++actions_;
    QWindow* handle = window_.windowHandle();
    QTest::mouseMove(handle, inWindow(from));
    QTest::mousePress(handle, Qt::LeftButton, modifiers, inWindow(from));
    if (from != to) {
      // QTest::mouseMove hands no modifiers on, so the event goes to the view itself.
      for (const double part : {0.3, 0.7, 1.0}) {
        moveHeld(from + part * (to - from), modifiers);
      }
    }
    QTest::mouseRelease(handle, Qt::LeftButton, modifiers, inWindow(to));
    QCoreApplication::processEvents();
  }
  /// By its icon in the tool bar.
  void chooseTool(const QString& icon) {
    for (QAction* action : window_.workspace().tools().actions().actions()) {
      if (action->data().toString() == icon) {
        clickAction(*action);
        return;
      }
    }
    QFAIL(qPrintable(icon));
  }
  void clickAction(QAction& action) {
    for (QWidget* button : action.associatedWidgets()) {
      if (auto* bar = qobject_cast<QToolBar*>(button)) {
        QWidget* widget = bar->widgetForAction(&action);
        clickOn(*widget, widget->rect().center());
        return;
      }
      auto* shared = qobject_cast<QToolButton*>(button);  // beside its arrow
      if (shared != nullptr && shared->defaultAction() == &action && shared->isVisible()) {
        clickOn(*shared, QPoint(12, shared->height() / 2));
        return;
      }
    }
    QFAIL(qPrintable(action.text()));
  }
  /// A menu of the bar and one of its entries: two clicks.
  void chooseInMenu(const QString& menuTitle, const QString& entry) {
    for (QAction* action : window_.menuBar()->actions()) {
      if (bare(action->text()) != menuTitle) {
        continue;
      }
      clickOn(*window_.menuBar(), window_.menuBar()->actionGeometry(action).center());
      QMenu* menu = action->menu();
      QTRY_VERIFY(menu->isVisible());
      for (QAction* item : menu->actions()) {
        if (bare(item->text()) == entry) {
          clickOn(*menu, menu->actionGeometry(item).center());
          return;
        }
      }
    }
    QFAIL(qPrintable(entry));
  }
  void press(int key, Qt::KeyboardModifiers modifiers = {}) {
    window_.activateWindow();  // as a window manager does when a dialog has closed
    QVERIFY(QTest::qWaitForWindowActive(&window_));
    QTest::keyClick(window_.windowHandle(), static_cast<Qt::Key>(key), modifiers);
    QCoreApplication::processEvents();
  }
  void clickRow(QListWidget& list, int row, Qt::KeyboardModifiers modifiers = {}) {
    clickOn(*list.viewport(), list.visualItemRect(list.item(row)).center(), modifiers);
  }
  void typeInto(QAbstractSpinBox& field, const QString& text) {
    clickOn(field, QPoint(12, field.height() / 2));
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
  }
  /// What a file dialog that opens next is told.
  void answerFileDialog(const QString& path) {
    quiet::answerDialog<QFileDialog>([path](QFileDialog& dialog) {
      auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
      name->setText(path);
      QTest::keyClick(name, Qt::Key_Return);
    });
  }
  QDialog* openDialog() const {
    for (QDialog* dialog : window_.findChildren<QDialog*>()) {
      if (dialog->isVisible()) {
        return dialog;
      }
    }
    return nullptr;
  }

 private:
  static QString bare(QString text) {
    return text.remove(QLatin1Char('&')).remove(QStringLiteral("…"));
  }
  editor::MapView& view() { return window_.workspace().view(); }
  QPoint inWindow(const base::Vec2& world) {
    return view().viewport()->mapTo(&window_, view().viewportFrom(world));
  }
  void moveHeld(const base::Vec2& world, Qt::KeyboardModifiers modifiers) {
    const QPoint at = view().viewportFrom(world);
    QMouseEvent event(QEvent::MouseMove, at, view().viewport()->mapTo(&window_, at),
                      view().viewport()->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, modifiers);
    QCoreApplication::sendEvent(view().viewport(), &event);
    QCoreApplication::processEvents();
  }

  app::MainWindow& window_;
  int actions_ = 0;
  int boxes_ = 0;
};

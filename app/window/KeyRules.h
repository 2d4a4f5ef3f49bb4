#pragma once

#include "app/window/Workspace.h"

namespace app {

class StartPage;

/// Key handling for the whole window, independent of the focus; described by `rules`.
class KeyRules : public QObject {
  Q_OBJECT
 public:
  KeyRules(QMainWindow& window, Workspace& workspace);  // the window owns it

  /// The rules in order of precedence, as text for users.
  static QStringList rules();

  /// While this page is visible, typed text belongs to its search.
  void setStartPage(StartPage& page) { startPage_ = &page; }

  /// Handles a key that no widget of the window has used.
  void handleUnusedKey(QKeyEvent& event);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool isInWindow(const QWidget& widget) const;
  void adaptFocus(QWidget& widget, QEvent::Type type);
  bool isWidgetKey(QWidget& focus, const QKeyEvent& event) const;

  QMainWindow& window_;
  Workspace& workspace_;
  StartPage* startPage_ = nullptr;
};

/// An application that reports exceptions thrown while an event is handled. GUI thread.
class GuardedApplication : public QApplication {
 public:
  GuardedApplication(int& argc, char** argv) : QApplication(argc, argv) {}

  /// Sets the handler for exceptions. Without a handler, the exception is rethrown.
  void setExceptionHandler(std::function<void(const std::string& why)> handler) {
    handler_ = std::move(handler);
  }

  bool notify(QObject* receiver, QEvent* event) override;

 private:
  std::function<void(const std::string& why)> handler_;
};

}  // namespace app

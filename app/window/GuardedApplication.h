#pragma once

#include <functional>
#include <string>
#include <utility>

#include <QApplication>

namespace app {

/// An application in which nothing that is thrown while an event is handled ends the program
/// without a word. GUI thread.
class GuardedApplication : public QApplication {
 public:
  GuardedApplication(int& argc, char** argv) : QApplication(argc, argv) {}

  /// What is done then, with the reason; nothing: the exception goes on.
  void whenBroken(std::function<void(const std::string& why)> act) { act_ = std::move(act); }

  bool notify(QObject* receiver, QEvent* event) override;

 private:
  std::function<void(const std::string& why)> act_;
};

}  // namespace app

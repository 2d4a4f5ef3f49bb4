#pragma once

#include <QObject>
#include <QSocketNotifier>

namespace app {

/// Reports SIGINT, SIGTERM and SIGHUP (Ctrl-C, logout, a closed terminal) in the event loop, so
/// that the program can end in order. Each signal is caught once: the second one terminates the
/// program immediately. A signal that was ignored at the start, such as SIGHUP under nohup, stays
/// ignored. One instance at a time; the destructor restores the previous behaviour.
class TerminationSignals : public QObject {
  Q_OBJECT
 public:
  explicit TerminationSignals(QObject* parent = nullptr);
  ~TerminationSignals() override;
  Q_DISABLE_COPY_MOVE(TerminationSignals)

 Q_SIGNALS:
  void received();

 private:
  QSocketNotifier* notifier_ = nullptr;  // null: the pipe could not be created
};

}  // namespace app

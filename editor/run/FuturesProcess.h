#pragma once

#include <QProcess>

#include "app/run/Futures.h"

namespace editor {

/// Runs `hunavsim futures` in a separate process, which forks up to its limit of parallel children.
/// The window never blocks on it. GUI thread.
class FuturesProcess : public QObject {
  Q_OBJECT
 public:
  explicit FuturesProcess(QObject* parent = nullptr);
  ~FuturesProcess() override;  // Kills the process.
  Q_DISABLE_COPY_MOVE(FuturesProcess)

  void setProgram(const QString& path) { program_ = path; }  // Another executable.
  bool isRunning() const { return process_ != nullptr; }
  void ask(const app::FuturesRequest& request);  // Cancels the previous request.
  void cancel();                                 // No further signals are emitted.

 Q_SIGNALS:
  void futureReceived(const app::Future& future);
  /// All futures have arrived, or `problems` contains the error output of the process.
  void ended(const QString& problems);

 private:
  void read();
  void reportEnd(int code, QProcess::ExitStatus status);

  QString program_;
  QProcess* process_ = nullptr;
};

}  // namespace editor

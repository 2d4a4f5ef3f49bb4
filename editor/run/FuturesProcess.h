#pragma once

#include <QProcess>

#include "app/run/Futures.h"

namespace editor {

/// `hunavsim futures` beside the window: a process of its own, which forks as many as it may use at
/// a time. The window never waits for it. GUI thread.
class FuturesProcess : public QObject {
  Q_OBJECT
 public:
  explicit FuturesProcess(QObject* parent = nullptr);
  ~FuturesProcess() override;  // ends it
  Q_DISABLE_COPY_MOVE(FuturesProcess)

  void setProgram(const QString& path) { program_ = path; }  // another than this one
  bool isRunning() const { return process_ != nullptr; }
  void ask(const app::FuturesQuestion& question);  // ends what was asked before
  void cancel();                                   // nothing is told any more

 Q_SIGNALS:
  void came(const app::Future& future);
  /// All have come, or why not: what it said on standard error.
  void ended(const QString& problems);

 private:
  void read();
  void tellEnd(int code, QProcess::ExitStatus status);

  QString program_;
  QProcess* process_ = nullptr;
  QByteArray rest_;  // of a line that has not come whole
};

}  // namespace editor

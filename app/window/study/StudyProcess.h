#pragma once

#include <QtWidgets>

#include "app/window/study/StudyRows.h"

namespace app {

/// Runs `hunavsim batch` as a child process, so that a crash does not affect the window. GUI
/// thread.
class StudyProcess : public QObject {
  Q_OBJECT
 public:
  enum class Begin { Resume, Restart };

  explicit StudyProcess(QObject* parent);
  /// Interrupts the process and waits; finished runs are kept.
  ~StudyProcess() override;
  Q_DISABLE_COPY_MOVE(StudyProcess)

  void setProgram(const QString& path) { program_ = path; }  // replaces this program
  const QString& program() const { return program_; }
  bool isRunning() const { return process_.state() != QProcess::NotRunning; }
  void start(const QString& experiment, const QString& folder, int jobs, Begin begin,
             bool allowCode);
  void stop();  // as Ctrl-C; `ended` is emitted

 Q_SIGNALS:
  void began(const app::StudyHeader& begin);
  void rowsReceived(const std::vector<app::StudyRow>& rows);  // batched
  /// All runs are finished; otherwise `problems` is the text of standard error.
  void ended(bool isComplete, const QString& problems);

 private:
  void read();
  void reportEnd();

  QString program_;
  QProcess process_;
  bool isStopped_ = false;
};

}  // namespace app

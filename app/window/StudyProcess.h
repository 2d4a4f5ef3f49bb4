#pragma once

#include <QProcess>
#include <QTimer>

#include "app/window/StudyRows.h"

namespace app {

/// `hunavsim batch` beside the window: its own process, so that a run that crashes takes nothing
/// with it. GUI thread.
class StudyProcess : public QObject {
  Q_OBJECT
 public:
  enum class Begin { GoOn, Anew };

  explicit StudyProcess(QObject* parent);
  /// Interrupts it and waits; what is finished is kept.
  ~StudyProcess() override;
  Q_DISABLE_COPY_MOVE(StudyProcess)

  void setProgram(const QString& path) { program_ = path; }  // another than this one
  const QString& program() const { return program_; }
  bool isRunning() const { return process_.state() != QProcess::NotRunning; }
  void start(const QString& experiment, const QString& folder, int jobs, Begin begin,
             bool allowCode);
  void stop();  // like Ctrl-C: `ended` follows

 Q_SIGNALS:
  void began(const app::StudyBegin& begin);
  void rowsCame(const std::vector<app::StudyRow>& rows);  // several at once
  /// All runs are finished, or why not: what it said on standard error.
  void ended(bool isComplete, const QString& problems);

 private:
  void read();
  void tellEnd();

  QString program_;
  QProcess process_;
  QByteArray rest_;  // of a line that has not come whole
  bool isStopped_ = false;
};

}  // namespace app

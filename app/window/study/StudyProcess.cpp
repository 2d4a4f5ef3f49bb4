#include "app/window/study/StudyProcess.h"

#include <csignal>
#include <sys/types.h>
#include <utility>

#include "app/run/DataPaths.h"

namespace app {

namespace {

constexpr int kWaitMs = 5000;  // for an interrupted batch to save its results

}  // namespace

StudyProcess::StudyProcess(QObject* parent)
    : QObject(parent), program_(QString::fromStdString(programPath())) {
  connect(&process_, &QProcess::readyReadStandardOutput, this, &StudyProcess::read);
  connect(&process_, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), this,
          &StudyProcess::reportEnd);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      Q_EMIT ended(false, process_.errorString());
    }
  });
}

StudyProcess::~StudyProcess() {
  process_.disconnect(this);
  if (isRunning()) {
    stop();
    if (!process_.waitForFinished(kWaitMs)) {
      process_.kill();  // results are already in the database
      process_.waitForFinished(kWaitMs);
    }
  }
}

void StudyProcess::start(const QString& experiment, const QString& folder, int jobs, Begin begin,
                         bool allowCode) {
  isStopped_ = false;
  QStringList words = {
      QStringLiteral("batch"),
      experiment,
      QStringLiteral("-o"),
      folder,
      QStringLiteral("--rows"),
      QStringLiteral("--jobs"),
      QString::number(jobs),
      begin == Begin::Restart ? QStringLiteral("--force") : QStringLiteral("--resume")};
  if (allowCode) {
    words.append(QStringLiteral("--allow-code"));
  }
  process_.start(program_, words);
}

/// Waits for exec: before it, the child is a copy of this program and would handle the signal as
/// such.
void StudyProcess::stop() {
  process_.waitForStarted(kWaitMs);
  if (isRunning() && process_.processId() > 0) {
    isStopped_ = true;
    ::kill(static_cast<pid_t>(process_.processId()), SIGINT);
  }
}

void StudyProcess::read() {
  std::vector<StudyRow> rows;
  while (process_.canReadLine()) {
    const QByteArray line = process_.readLine();
    if (std::optional<StudyRow> row = studyRowOf(line)) {
      rows.push_back(*std::move(row));
    } else if (const std::optional<StudyHeader> first = studyHeaderOf(line)) {
      Q_EMIT began(*first);
    }
  }
  if (!rows.empty()) {
    Q_EMIT rowsReceived(rows);
  }
}

/// Exit code 0: success; 1: interrupted, or runs failed (see rows). If stopped before it installs
/// its signal handler, the process is killed by the signal.
void StudyProcess::reportEnd() {
  read();
  const QString errorOutput = QString::fromUtf8(process_.readAllStandardError()).trimmed();
  const bool isNormal = process_.exitStatus() == QProcess::NormalExit;
  const bool isFine = isNormal ? process_.exitCode() <= 1 : isStopped_;
  Q_EMIT ended(isFine && isNormal && !errorOutput.contains(QLatin1String("interrupted:")),
               isFine                  ? QString()
               : errorOutput.isEmpty() ? tr("The batch process crashed.")
                                       : errorOutput);
}

}  // namespace app

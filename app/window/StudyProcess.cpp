#include "app/window/StudyProcess.h"

#include <csignal>
#include <sys/types.h>
#include <utility>

#include "app/run/DataPaths.h"

namespace app {

namespace {

constexpr int kWaitMs = 5000;  // for a batch that is interrupted to put away what it has

}  // namespace

StudyProcess::StudyProcess(QObject* parent)
    : QObject(parent), program_(QString::fromStdString(programPath())) {
  connect(&process_, &QProcess::readyReadStandardOutput, this, &StudyProcess::read);
  connect(&process_, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), this,
          &StudyProcess::tellEnd);
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
      process_.kill();  // its results are in the database already
      process_.waitForFinished(kWaitMs);
    }
  }
}

void StudyProcess::start(const QString& experiment, const QString& folder, int jobs, Begin begin,
                         bool allowCode) {
  rest_.clear();
  isStopped_ = false;
  QStringList words = {
      QStringLiteral("batch"),
      experiment,
      QStringLiteral("-o"),
      folder,
      QStringLiteral("--rows"),
      QStringLiteral("--jobs"),
      QString::number(jobs),
      begin == Begin::Anew ? QStringLiteral("--force") : QStringLiteral("--resume")};
  if (allowCode) {
    words.append(QStringLiteral("--allow-code"));
  }
  process_.start(program_, words);
}

/// Until it is another program it is a copy of this one: the signal would be taken as if for us.
void StudyProcess::stop() {
  process_.waitForStarted(kWaitMs);
  if (isRunning() && process_.processId() > 0) {
    isStopped_ = true;
    ::kill(static_cast<pid_t>(process_.processId()), SIGINT);
  }
}

void StudyProcess::read() {
  rest_ += process_.readAllStandardOutput();
  std::vector<StudyRow> rows;
  int begin = 0;
  for (int end = rest_.indexOf('\n'); end >= 0; end = rest_.indexOf('\n', begin)) {
    const QByteArray line = rest_.mid(begin, end - begin);
    if (std::optional<StudyRow> row = studyRowOf(line)) {
      rows.push_back(*std::move(row));
    } else if (const std::optional<StudyBegin> first = studyBeginOf(line)) {
      Q_EMIT began(*first);
    }
    begin = end + 1;
  }
  rest_.remove(0, begin);
  if (!rows.empty()) {
    Q_EMIT rowsCame(rows);
  }
}

/// 0: all is well; 1: it was interrupted, or runs have failed, which rows tell. Who is stopped
/// before it listens to signals ends by one.
void StudyProcess::tellEnd() {
  read();
  const QString said = QString::fromUtf8(process_.readAllStandardError()).trimmed();
  const bool isNormal = process_.exitStatus() == QProcess::NormalExit;
  const bool isFine = isNormal ? process_.exitCode() <= 1 : isStopped_;
  Q_EMIT ended(isFine && isNormal && !said.contains(QLatin1String("interrupted:")),
               isFine           ? QString()
               : said.isEmpty() ? tr("The batch has crashed.")
                                : said);
}

}  // namespace app

#include "editor/run/FuturesProcess.h"

#include "app/run/DataPaths.h"

namespace editor {

FuturesProcess::FuturesProcess(QObject* parent)
    : QObject(parent), program_(QString::fromStdString(app::programPath())) {}

FuturesProcess::~FuturesProcess() {
  cancel();
}

void FuturesProcess::ask(const app::FuturesRequest& request) {
  cancel();
  process_ = new QProcess(this);
  connect(process_, &QProcess::readyReadStandardOutput, this, &FuturesProcess::read);
  connect(process_, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), this,
          &FuturesProcess::reportEnd);
  connect(process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      const QString why = process_->errorString();
      cancel();
      Q_EMIT ended(why);
    }
  });
  process_->start(program_, {QStringLiteral("futures"), QStringLiteral("-")});
  if (process_ != nullptr) {  // Otherwise the process failed to start, which is reported.
    process_->write(QByteArray::fromStdString(app::encodeFuturesRequest(request)));
    process_->closeWriteChannel();
  }
}

/// Kills the process; its children exit with it.
void FuturesProcess::cancel() {
  QProcess* const process = std::exchange(process_, nullptr);
  if (process == nullptr) {
    return;
  }
  constexpr int kKilledMs = 1000;
  process->disconnect(this);
  process->kill();
  process->waitForFinished(kKilledMs);  // Returns almost immediately.
  process->deleteLater();               // The process may be the sender of the current signal.
}

void FuturesProcess::read() {
  while (process_ != nullptr && process_->canReadLine()) {  // A receiver of the signal may cancel.
    const QByteArray line = process_->readLine().chopped(1);
    if (const std::optional<app::Future> future = app::futureOf(line.toStdString())) {
      Q_EMIT futureReceived(*future);
    }
  }
}

void FuturesProcess::reportEnd(int code, QProcess::ExitStatus status) {
  read();
  if (process_ == nullptr) {
    return;
  }
  const QString said = QString::fromUtf8(process_->readAllStandardError()).trimmed();
  const bool isFine = status == QProcess::NormalExit && code == 0;
  process_->deleteLater();
  process_ = nullptr;
  Q_EMIT ended(isFine ? QString() : said.isEmpty() ? tr("The futures simulation crashed.") : said);
}

}  // namespace editor

#include <algorithm>
#include <thread>

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QUrl>

#include "app/window/StudyEarlier.h"
#include "app/window/StudyPanel.h"
#include "app/window/StudyWords.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

int cores() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace

/// Before the file is written: it stays that of the results beside it, until they go.
bool StudyPanel::mayWrite(StudyProcess::Begin begin) {
  const QString folder = resultsFolder();
  const QString busy = whoWritesInto(folder);
  QString problem = busy;
  if (problem.isEmpty() && begin == StudyProcess::Begin::GoOn) {
    const base::Result<std::string> text =
        isEdited_ ? form_->textFor(QFileInfo(file_).absolutePath()).toStdString()
                  : base::readTextFile(file_.toStdString());
    problem = text ? whyNotGoOn(folder, *text) : QString();  // else the batch tells it
  }
  if (!problem.isEmpty()) {
    say(editor::capitalized(problem), true);
    anew_->setVisible(busy.isEmpty());
  }
  return problem.isEmpty();
}

/// Else it is asked for, and `then` is done after a yes.
bool StudyPanel::mayRun(const std::vector<ForeignCode>& code, const std::function<void()>& then) {
  if (code_.allows(code)) {
    return true;
  }
  code_.ask(then);
  say(tr("Its runs start programs of others: allow them above the map"));
  Q_EMIT codeWanted(code);
  return false;
}

void StudyPanel::start(StudyProcess::Begin begin) {
  if (isRunning()) {
    return;
  }
  if (file_.isEmpty()) {
    askFile(true);
  }
  const base::Result<Experiment> checked = experiment();
  if (file_.isEmpty() || !checked) {
    check();
    return;
  }
  check_.stop();  // it would take the place of what is said here
  start_->setEnabled(true);
  const std::vector<ForeignCode> code = codeOf(*checked);
  if (!mayWrite(begin) || !mayRun(code, [this, begin] { start(begin); }) || !save()) {
    return;
  }
  begun_ = *checked;
  begun_->allowCode = !code.empty();
  anew_->hide();
  process_.start(file_, resultsFolder(), cores(), begin, begun_->allowCode);
  say(tr("Begins…"));
  follow();
}

void StudyPanel::stop() {
  process_.stop();
  say(tr("Stops…"));
}

void StudyPanel::showProgress() {
  const std::vector<StudyRow>& rows = results_->runs().rows();
  const std::size_t finished = rows.size();
  const std::size_t made = finished - std::min(before_, finished);
  QString text = tr("%1 of %2 runs").arg(finished).arg(total_);
  if (isRunning() && made > 0 && finished < total_) {
    const double seconds = 1e-3 * static_cast<double>(since_.elapsed());
    const double left =
        seconds / static_cast<double>(made) * static_cast<double>(total_ - finished);
    text += tr(", %1 left").arg(studyTimeText(left));
  }
  const auto failed =
      std::count_if(rows.begin(), rows.end(), [](const StudyRow& row) { return !row.isOk; });
  if (failed > 0) {
    text += tr(", %1 failed").arg(failed);
  }
  progress_->setValue(
      total_ == 0
          ? 0
          : static_cast<int>(static_cast<std::size_t>(progress_->maximum()) * finished / total_));
  say(text);
  Q_EMIT counted(static_cast<int>(finished));
}

void StudyPanel::finish(bool isComplete, const QString& problems) {
  results_->compare();
  if (!problems.isEmpty()) {
    const QStringList lines = problems.split(QLatin1Char('\n'));
    say(withoutSeverity(lines.front()), true);
    says_->setToolTip(problems);
    anew_->setVisible(QFileInfo::exists(resultsFolder()));
  } else {
    showProgress();
    says_->setToolTip({});
    if (!isComplete) {
      say(says_->text() + tr(": stopped, what is finished is kept"));
    }
  }
  follow();
}

/// One after the other: the second click waits for nothing.
void StudyPanel::runProgram(const QStringList& words, const QString& saying,
                            const std::function<void()>& then) {
  if (helper_.state() != QProcess::NotRunning) {
    return;
  }
  say(saying);
  helper_.disconnect(this);
  connect(&helper_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      say(helper_.errorString(), true);
    }
  });
  connect(&helper_, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), this,
          [this, then](int code, QProcess::ExitStatus status) {
            const bool isFine = status == QProcess::NormalExit && code <= 1;
            if (isFine) {
              showProgress();
              then();
            } else {
              say(QString::fromUtf8(helper_.readAllStandardError()).trimmed(), true);
            }
          });
  helper_.start(process_.program(), words);
}

/// The folder of a run that was kept, else the run is made once more.
void StudyPanel::play(int run) {
  const QString kept = QDir(resultsFolder()).filePath(QStringLiteral("runs/%1").arg(run));
  if (QFileInfo::exists(kept)) {
    Q_EMIT runWanted(kept);
    return;
  }
  if (!shown_ || static_cast<std::size_t>(run) >= shown_->runCount()) {
    say(tr("Run %1 was not kept, and its experiment cannot be read any more").arg(run), true);
    return;
  }
  const std::vector<ForeignCode> code = codeOf(*shown_);
  if (!mayRun(code, [this, run] { play(run); })) {
    return;
  }
  shown_->allowCode = !code.empty();
  QStringList words;
  for (const std::string& word : shown_->wordsOf(static_cast<std::size_t>(run))) {
    words.append(QString::fromStdString(word));
  }
  played_ = std::make_unique<QTemporaryDir>();
  const QString folder = played_->filePath(QStringLiteral("run_%1").arg(run));
  words << QStringLiteral("--quiet") << QStringLiteral("-o") << folder;
  runProgram(words, tr("Makes run %1 once more…").arg(run),
             [this, folder] { Q_EMIT runWanted(folder); });
}

void StudyPanel::openReport() {
  const QString folder = resultsFolder();
  runProgram({QStringLiteral("report"), folder, QStringLiteral("--quiet")},
             tr("Writes the report…"), [folder] {
               QDesktopServices::openUrl(
                   QUrl::fromLocalFile(QDir(folder).filePath(QStringLiteral("report.html"))));
             });
}

}  // namespace app

#include "app/window/study/StudyProcess.h"

#include <cmath>
#include <csignal>
#include <filesystem>
#include <memory>
#include <sys/types.h>
#include <utility>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "app/report/Study.h"
#include "app/run/BatchFolder.h"
#include "app/run/DataPaths.h"
#include "sim2d/base/Text.h"

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

namespace {

bool isIn(const QString& folder, const char* name) {
  return QFileInfo::exists(QDir(folder).filePath(QLatin1String(name)));
}

/// The first problem: "results.sqlite: the results cannot be read …".
QString textOf(const base::Diagnostics& problems) {
  const base::Diagnostic& first = problems.front();
  const QString file = QFileInfo(QString::fromStdString(first.file)).fileName();
  return QStringLiteral("%1: %2").arg(file, QString::fromStdString(first.message));
}

/// Converts booleans and numbers as `batch --rows` does.
std::optional<double> numberOf(const std::string& field) {
  if (field == "True" || field == "False") {
    return field == "True" ? 1.0 : 0.0;
  }
  const std::optional<double> number = base::parseDouble(field);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

/// A row without metrics. `result`: how the run ended.
template <class Run, class Result>
StudyRow rowOf(const Run& run, int number, const Result& result, const QStringList& paths) {
  StudyRow row;
  row.run = number;
  row.scenario = QString::fromStdString(run.scenario);
  row.seed = run.seed;
  for (int k = 0; k < paths.size(); ++k) {
    row.values[paths[k]] = QString::fromStdString(run.values[static_cast<std::size_t>(k)]);
  }
  row.isOk = result.ok;
  row.reason = QString::fromStdString(result.reason);
  return row;
}

StudyRow rowOf(const StoredRun& stored, const QStringList& paths) {
  StudyRow row = rowOf(stored, static_cast<int>(stored.run), stored.row, paths);
  for (const auto& [column, field] : stored.row.fields) {
    if (const std::optional<double> number = numberOf(field)) {
      row.metrics[QString::fromStdString(column)] = *number;
    }
  }
  return row;
}

QStringList pathsOf(const std::vector<std::string>& paths) {
  QStringList all;
  for (const std::string& path : paths) {
    all.append(QString::fromStdString(path));
  }
  return all;
}

RestoredStudy restoredFrom(const ResultStore& store) {
  RestoredStudy earlier;
  earlier.paths = pathsOf(store.study().paths);
  earlier.runs = store.study().shard.runCount(store.study().runs);
  earlier.experiment = store.study().experiment;
  earlier.rows.reserve(store.finished());
  const base::Diagnostics unread = store.forEach(
      [&](const StoredRun& stored) { earlier.rows.push_back(rowOf(stored, earlier.paths)); });
  earlier.trouble = unread.empty() ? QString() : textOf(unread);
  earlier.experimentPath = store.study().experimentPath;
  earlier.inputs = store.study().inputs;
  if (!earlier.inputs.empty()) {
    earlier.inputs.erase(earlier.inputs.begin());  // the experiment
  }
  return earlier;
}

/// The folder of which `file` has this relative path; none: of no folder.
std::optional<std::filesystem::path> baseOf(const std::filesystem::path& relative,
                                            const std::filesystem::path& file) {
  const std::filesystem::path wanted = relative.lexically_normal();
  std::filesystem::path base = file.lexically_normal();
  for (auto part = wanted.end(); part != wanted.begin();) {
    --part;
    if (base.filename() != *part || *part == "..") {
      return std::nullopt;
    }
    base = base.parent_path();
  }
  return base;
}

StudyRow rowOf(const report::Results& results, std::size_t at, const QStringList& paths) {
  const report::Results::Run& run = results.runs[at];
  StudyRow row = rowOf(run, static_cast<int>(run.number), run, paths);
  for (std::size_t key = 0; key < results.keys.size(); ++key) {
    if (std::isfinite(results.metrics[key][at])) {
      row.metrics[QString::fromStdString(results.keys[key])] = results.metrics[key][at];
    }
  }
  return row;
}

/// Reads results.csv, which does not contain the total number of runs.
RestoredStudy restoredFromCsv(const QString& folder) {
  const std::string file = QDir(folder).filePath(QStringLiteral("results.csv")).toStdString();
  RestoredStudy earlier;
  const base::Result<std::string> text = base::readTextFile(file);
  const base::Result<report::Results> results =
      text ? report::parseResults(*text, file) : base::Result<report::Results>(text.diagnostics());
  if (!results) {
    earlier.trouble = textOf(results.diagnostics());
    return earlier;
  }
  earlier.paths = pathsOf(results->paths);
  earlier.runs = results->runs.size();
  earlier.rows.reserve(earlier.runs);
  for (std::size_t run = 0; run < earlier.runs; ++run) {
    earlier.rows.push_back(rowOf(*results, run, earlier.paths));
  }
  return earlier;
}

/// Appends the available actions to the problem.
QString withChoices(const QString& problem) {
  return QObject::tr("%1: restart (deletes them), or save as another file").arg(problem);
}

}  // namespace

RestoredStudy restoredStudyIn(const QString& folder) {
  QString trouble;
  if (isIn(folder, "results.sqlite")) {
    const base::Result<LockedResults> opened = readResults(folder.toStdString());
    if (opened) {
      return restoredFrom(*opened->store);
    }
    trouble = textOf(opened.diagnostics());
  }
  RestoredStudy earlier = isIn(folder, "results.csv") ? restoredFromCsv(folder) : RestoredStudy();
  earlier.trouble = trouble.isEmpty() ? earlier.trouble : trouble;
  return earlier;
}

QString changedInputOf(const std::string& experimentPath, std::vector<InputHash> inputs,
                       const QString& file) {
  const std::optional<std::filesystem::path> base = baseOf(experimentPath, file.toStdString());
  if (!base) {
    inputs.erase(std::remove_if(inputs.begin(), inputs.end(),
                                [](const InputHash& input) {
                                  return std::filesystem::path(input.path).is_relative();
                                }),
                 inputs.end());
  }
  const std::vector<std::string> changed =
      changedInputs(inputs, base ? base->string() : std::string());
  return changed.empty() ? QString()
                         : QFileInfo(QString::fromStdString(changed.front())).fileName();
}

bool isBatchFolder(const QString& folder) {
  return isIn(folder, "results.sqlite") ||
         (isIn(folder, "results.csv") && isIn(folder, "manifest.json"));
}

namespace {

/// The path as the batch was given it, which may have been started in another folder.
QString writtenExperimentOf(const QString& folder) {
  if (isIn(folder, "results.sqlite")) {
    if (const base::Result<LockedResults> opened = readResults(folder.toStdString())) {
      return QString::fromStdString(opened->store->study().experimentPath);
    }
  }
  QFile manifest(QDir(folder).filePath(QStringLiteral("manifest.json")));
  if (!manifest.open(QIODevice::ReadOnly)) {
    return {};
  }
  const QJsonArray inputs =
      QJsonDocument::fromJson(manifest.readAll()).object()[QLatin1String("inputs")].toArray();
  return inputs.first()[QLatin1String("path")].toString();  // it is the first input
}

}  // namespace

QString experimentOfBatch(const QString& folder) {
  return QString::fromStdString(
      experimentFileOf(writtenExperimentOf(folder).toStdString(), folder.toStdString())
          .value_or(std::string()));
}

base::Diagnostic missingExperimentOf(const QString& folder) {
  const bool isPiped = writtenExperimentOf(folder) == QLatin1String(kStandardInput);
  return base::error(isPiped ? "batch.piped-experiment" : "batch.no-experiment", {},
                     folder.toStdString());
}

QString resumeObstacle(const QString& folder, const std::string& experiment) {
  const QString name = QFileInfo(folder).fileName();
  if (!isIn(folder, "results.sqlite")) {
    return isIn(folder, "results.csv")
               ? withChoices(QObject::tr("the results in %1 have no results.sqlite, which is "
                                         "required to resume")
                                 .arg(name))
               : QString();
  }
  const base::Result<LockedResults> opened = readResults(folder.toStdString());
  if (!opened) {
    return textOf(opened.diagnostics());
  }
  return opened->store->study().experiment == experiment
             ? QString()
             : withChoices(QObject::tr("the results in %1 belong to another experiment").arg(name));
}

QString folderWriter(const QString& folder) {
  if (!QFileInfo::exists(folder)) {
    return {};
  }
  const base::Result<std::unique_ptr<FolderLock>> lock = FolderLock::acquire(folder.toStdString());
  return lock ? QString() : textOf(lock.diagnostics());
}

}  // namespace app

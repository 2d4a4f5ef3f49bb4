#include "app/window/study/RestoredStudy.h"

#include <cmath>
#include <memory>
#include <utility>

#include <QtWidgets>

#include "app/report/Results.h"
#include "app/run/BatchFolder.h"
#include "sim2d/base/Text.h"

namespace app {

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

StudyRow rowOf(const StoredRun& stored, const QStringList& paths) {
  StudyRow row;
  row.run = static_cast<int>(stored.run);
  row.scenario = QString::fromStdString(stored.scenario);
  row.seed = stored.seed;
  for (int k = 0; k < paths.size(); ++k) {
    row.values[paths[k]] = QString::fromStdString(stored.values[static_cast<std::size_t>(k)]);
  }
  row.isOk = stored.row.ok;
  row.reason = QString::fromStdString(stored.row.reason);
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
  return earlier;
}

StudyRow rowOf(const report::Results& results, std::size_t at, const QStringList& paths) {
  const report::Results::Run& run = results.runs[at];
  StudyRow row;
  row.run = static_cast<int>(run.number);
  row.scenario = QString::fromStdString(run.scenario);
  row.seed = run.seed;
  for (int k = 0; k < paths.size(); ++k) {
    row.values[paths[k]] = QString::fromStdString(run.values[static_cast<std::size_t>(k)]);
  }
  row.isOk = run.ok;
  row.reason = QString::fromStdString(run.reason);
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

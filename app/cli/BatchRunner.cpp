#include "app/cli/BatchRunner.h"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <sys/prctl.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <QEventLoop>
#include <QStringList>
#include <QTimer>

#include "app/run/DataPaths.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kPollMs = 100;
constexpr int kPatienceMs = 3000;  // for children to end after they were asked to

std::string fieldOf(const Json& value) {
  if (value.is_null()) {
    return {};
  }
  if (value.is_boolean()) {
    return value.get<bool>() ? "True" : "False";
  }
  if (value.is_number_float()) {
    return base::formatDouble(value.get<double>());
  }
  return value.dump();
}

Json readJson(const fs::path& path) {
  const base::Result<std::string> text = base::readTextFile(path.string());
  return text ? Json::parse(*text, nullptr, false) : Json();
}

/// The first line that says what went wrong.
std::string firstError(const std::string& output) {
  for (const std::string& line : base::split(output, '\n')) {
    const std::size_t at = line.find("error: ");
    if (at != std::string::npos) {
      return base::trimmed(line.substr(at + 7));
    }
  }
  return {};
}

BatchRow readRow(const fs::path& folder) {
  BatchRow row;
  const Json manifest = readJson(folder / "manifest.json");
  const Json metrics = readJson(folder / "metrics.json");
  if (manifest.is_object()) {
    row.ok = manifest.value("status", "") == "finished";
    row.reason = row.ok ? std::string() : manifest.value("reason", "");
    if (manifest.contains("simulated_seconds")) {
      row.simulated = fieldOf(manifest["simulated_seconds"]);
    }
  }
  if (metrics.is_object() && metrics.contains("metrics")) {
    for (const auto& [key, entry] : metrics["metrics"].items()) {
      row.metrics[key] = fieldOf(entry.value("value", Json()));
    }
  }
  return row;
}

/// Out of the reach of Ctrl-C in the terminal: the parent asks it to end, once. It does not outlive
/// the parent.
class Child : public QProcess {
 public:
  using QProcess::QProcess;

 protected:
  void setupChildProcess() override {
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  }
};

}  // namespace

BatchRunner::BatchRunner(const Experiment& experiment, std::string runsFolder, int jobs)
    : experiment_(experiment),
      runsFolder_(std::move(runsFolder)),
      jobs_(jobs),
      rows_(experiment.runCount()) {}

void BatchRunner::execute(const std::function<bool()>& wantsStop,
                          const std::function<void(std::size_t)>& onProgress) {
  onProgress_ = onProgress;
  QEventLoop loop;
  QTimer poll;
  connect(&poll, &QTimer::timeout, &loop, [this, &loop, &wantsStop] {
    if (!stopping_ && wantsStop && wantsStop()) {
      stopping_ = true;
      stopChildren();
    }
    if (children_.empty()) {
      loop.quit();
    }
  });
  startMore();
  poll.start(kPollMs);
  loop.exec();
}

void BatchRunner::startMore() {
  while (!stopping_ && next_ < rows_.size() && children_.size() < static_cast<std::size_t>(jobs_)) {
    start(next_++);
  }
}

std::string BatchRunner::folderOf(std::size_t run) const {
  return (fs::path(runsFolder_) / std::to_string(run)).string();
}

QStringList BatchRunner::arguments(std::size_t run) const {
  const Experiment::Run values = experiment_.run(run);
  QStringList words = {
      QStringLiteral("run"), QString::fromStdString(experiment_.scenarioPaths[values.scenario]),
      QStringLiteral("--quiet"), QStringLiteral("-o"), QString::fromStdString(folderOf(run))};
  const auto add = [&words](const char* option, const std::string& value) {
    words << QString::fromLatin1(option) << QString::fromStdString(value);
  };
  if (experiment_.record == Experiment::Record::Metrics) {
    words << QStringLiteral("--totals");  // nothing else of the folder is looked at
  }
  add("--seed", std::to_string(values.seed));
  const auto addIf = [&add](const char* option, const std::optional<std::string>& value) {
    if (value) {
      add(option, *value);
    }
  };
  addIf("--duration", experiment_.duration);
  addIf("--dt", experiment_.dt);
  addIf("--model", experiment_.model);
  addIf("--robot", experiment_.robot);
  addIf("--planner", experiment_.planner);
  addIf("--metrics-profile", experiment_.metricsProfile);
  for (std::size_t k = 0; k < experiment_.values.size(); ++k) {
    add("--set", experiment_.values[k].first + "=" + values.values[k]);
  }
  return words;
}

void BatchRunner::start(std::size_t run) {
  removeFolder(run);  // an earlier batch may have left one, and this run may fail before it writes
  auto* process = new Child(this);
  process->setStandardInputFile(QProcess::nullDevice());
  process->setStandardOutputFile(QProcess::nullDevice());
  children_.push_back(process);
  const auto finish = [this, process, run] { onFinished(process, run); };
  connect(process, QOverload<int, QProcess::ExitStatus>::of(&QProcess::finished), this, finish);
  connect(process, &QProcess::errorOccurred, this, [finish](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      finish();
    }
  });
  process->start(QString::fromStdString(programPath()), arguments(run));
}

void BatchRunner::onFinished(QProcess* process, std::size_t run) {
  const auto place = std::find(children_.begin(), children_.end(), process);
  if (place == children_.end()) {
    return;
  }
  children_.erase(place);
  process->deleteLater();
  if (stopping_) {
    removeFolder(run);  // cut short: not a result
    return;
  }
  BatchRow row = readRow(folderOf(run));
  if (process->error() == QProcess::FailedToStart) {
    row.reason = "the process could not be started";
  } else if (process->exitStatus() == QProcess::CrashExit) {
    row.ok = false;
    row.reason = "the process crashed";
  } else if (process->exitCode() != 0) {
    row.ok = false;
    if (row.reason.empty()) {
      row.reason = firstError(process->readAllStandardError().toStdString());
    }
  }
  if (!row.ok && row.reason.empty()) {
    row.reason = "exit code " + std::to_string(process->exitCode());
  }
  keepOrRemove(run, row);
  rows_[run] = std::move(row);
  ++finished_;
  if (onProgress_) {
    onProgress_(finished_);
  }
  startMore();
}

void BatchRunner::keepOrRemove(std::size_t run, const BatchRow& row) const {
  const bool keep = experiment_.record == Experiment::Record::All ||
                    (experiment_.record == Experiment::Record::Failed && !row.ok);
  if (!keep) {
    removeFolder(run);
  }
}

void BatchRunner::removeFolder(std::size_t run) const {
  std::error_code ignored;  // a folder that stays does no harm to the results
  fs::remove_all(folderOf(run), ignored);
}

void BatchRunner::stopChildren() {
  const std::vector<QProcess*> children = children_;
  for (QProcess* child : children) {
    child->terminate();
  }
  for (QProcess* child : children) {
    if (!child->waitForFinished(kPatienceMs)) {
      child->kill();
      child->waitForFinished(kPatienceMs);
    }
  }
}

}  // namespace app

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "app/capsule/Rerun.h"
#include "app/capsule/Unpacked.h"
#include "app/run/Batch.h"
#include "app/run/BatchFolder.h"
#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "app/run/Experiment.h"
#include "app/run/ExperimentRunner.h"
#include "app/run/ResultStore.h"
#include "sim2d/base/Text.h"

namespace capsule {

namespace {

namespace fs = std::filesystem;

/// Runs of an unpacked batch.
class BatchRepeater {
 public:
  BatchRepeater(const UnpackedCapsule& capsule, const RerunOptions& options,
                app::Experiment experiment)
      : capsule_(capsule),
        options_(options),
        experiment_(std::move(experiment)),
        folder_(app::pathIn(capsule.root, "rerun")),
        runner_(experiment_, app::pathIn(folder_, "runs"), options.loader) {}

  /// Errors: code that may not or cannot start. Other problems are differences.
  base::Diagnostics prepare(Rerun& rerun) {
    base::Diagnostics refused;
    for (const base::Diagnostic& problem :
         runner_.check(base::Severity::Error, app::ExperimentRunner::Checked::FirstRuns)) {
      const bool isCode = problem.code == "code.not-allowed";
      base::append(isCode ? refused : rerun.differences,
                   atMembers({problem}, capsule_.root, capsule_.file));
    }
    base::append(rerun.differences, foreignInputs(packed(runner_.inputs()), capsule_.manifest,
                                                  capsule_.root, capsule_.file));
    return refused;
  }

  base::Diagnostics execute(const std::vector<std::size_t>& runs, Rerun& rerun) {
    app::BatchJob job;
    job.runs = runs;
    job.jobs = options_.jobs;
    job.execute = [this](std::size_t run, const app::BatchJob::ReportInputs& reportInputs) {
      return runner_.run(run, reportInputs);
    };
    job.storeRow = [&](std::size_t run, const app::ResultRow& row) {
      rows_[run] = row;
      rows_[run].reason = withRecordedPaths(row.reason, capsule_.manifest, capsule_.root);
      rerun.finished.push_back(run);
      base::append(foreign_, foreignInputs(packed(row.inputs), capsule_.manifest, capsule_.root,
                                           capsule_.file));
      if (options_.showProgress) {
        options_.showProgress(rerun.finished.size(), runs.size());
      }
      return base::Diagnostics();
    };
    job.wantsStop = [this] { return options_.stop && options_.stop->isStopRequested(); };
    base::Diagnostics problems = app::runBatch(job);
    std::sort(rerun.finished.begin(), rerun.finished.end());
    base::append(rerun.differences, app::newDiagnostics(rerun.differences, foreign_));
    return problems;
  }

  base::Diagnostics compareRows(const ResultTable& stored, Rerun& rerun) const {
    const base::Result<ResultTable> repeated = repeatedTable();
    if (!repeated) {
      return repeated.diagnostics();
    }
    base::append(rerun.differences, rowDifferences(stored, *repeated, "capsule.value-differs",
                                                   capsule_.file + "/study/results.csv"));
    return {};
  }

  void compareFolders(Rerun& rerun) const {
    for (const std::size_t run : rerun.finished) {
      const std::string name = "runs/" + std::to_string(run) + "/";
      base::append(rerun.differences, runFolderDifferences(capsule_, kStudyFolder + name,
                                                           app::pathIn(folder_, name), true));
    }
  }

 private:
  /// Without code that was left out.
  std::vector<app::InputHash> packed(std::vector<app::InputHash> used) const {
    if (omittedCode(capsule_.manifest) != nullptr) {
      used.erase(std::remove_if(used.begin(), used.end(),
                                [](const app::InputHash& each) { return each.sha256.empty(); }),
                 used.end());
    }
    return used;
  }

  /// results.csv of the repeated runs, written as the batch wrote its own.
  base::Result<ResultTable> repeatedTable() const {
    std::error_code ignored;
    fs::create_directories(folder_, ignored);
    const base::Result<app::Study> study = app::studyOf(experiment_, {}, {});
    if (!study) {
      return study.diagnostics();
    }
    auto store = app::ResultStore::create(app::pathIn(folder_, "results.sqlite"), *study);
    if (!store) {
      return store.diagnostics();
    }
    for (const auto& [run, row] : rows_) {
      const app::Experiment::Run of = experiment_.run(run);
      const base::Diagnostics problems =
          (*store)->add({run, experiment_.scenarios[of.scenario], of.seed, of.values, row});
      if (!problems.empty()) {
        return problems;
      }
    }
    const std::string path = app::pathIn(folder_, "results.csv");
    const base::Diagnostics unwritten = app::writeResults(**store, path);
    const base::Result<std::string> text = base::readTextFile(path);
    if (!unwritten.empty() || !text) {
      return unwritten.empty() ? text.diagnostics() : unwritten;
    }
    return readResultTable(*text, path);
  }

  const UnpackedCapsule& capsule_;
  const RerunOptions& options_;
  const app::Experiment experiment_;
  const std::string folder_;
  app::ExperimentRunner runner_;
  std::map<std::size_t, app::ResultRow> rows_;  // by run
  base::Diagnostics foreign_;
};

}  // namespace

base::Result<Rerun> rerunBatch(const UnpackedCapsule& capsule, const ResultTable& table,
                               const std::vector<std::size_t>& runs, const RerunOptions& options) {
  const app::DataFolderOverride shipped(app::pathIn(capsule.root, kSharedFolder));
  Rerun rerun;
  base::Result<app::Experiment> experiment =
      app::readExperiment(pathOfInput(capsule.manifest.inputs.front(), capsule.root));
  if (!experiment) {
    rerun.differences = atMembers(experiment.diagnostics(), capsule.root, capsule.file);
    return rerun;
  }
  experiment->allowCode = options.allowCode;
  const std::size_t count = experiment->runCount();
  std::vector<std::size_t> known = runs;
  known.erase(
      std::remove_if(known.begin(), known.end(), [count](std::size_t run) { return run >= count; }),
      known.end());  // reported as rows that are not planned
  BatchRepeater repeater(capsule, options, *std::move(experiment));
  base::Diagnostics problems = repeater.prepare(rerun);
  if (problems.empty()) {
    problems = repeater.execute(known, rerun);
  }
  if (problems.empty()) {
    problems = repeater.compareRows(table, rerun);
  }
  repeater.compareFolders(rerun);
  return base::resultOf(std::move(rerun), std::move(problems));
}

}  // namespace capsule

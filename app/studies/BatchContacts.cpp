#include "app/studies/BatchContacts.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "app/run/BatchFolder.h"
#include "app/run/Experiment.h"
#include "app/run/WorkerTasks.h"
#include "sim2d/base/JsonText.h"

namespace app {

namespace {

/// The experiment of a batch and its completed runs.
struct FinishedBatch {
  Experiment experiment;
  std::vector<std::size_t> runs;  // indices
};

/// Errors of input files that are no longer those of the batch; the experiment itself is stored.
base::Diagnostics changedFiles(const Study& study) {
  base::Diagnostics problems;
  for (std::size_t k = 1; k < study.inputs.size(); ++k) {
    if (sha256OfFile(study.inputs[k].path) != study.inputs[k].sha256) {
      problems.push_back(base::error("again.input-changed", {}, study.inputs[k].path));
    }
  }
  return problems;
}

base::Result<FinishedBatch> readBatch(const std::string& folder) {
  const base::Result<LockedResults> results = readResults(folder);
  if (!results) {
    return results.diagnostics();
  }
  const Study& study = results->store->study();
  base::Result<Experiment> experiment = parseExperiment(study.experiment, study.experimentPath);
  if (!experiment) {
    return experiment.diagnostics();
  }
  FinishedBatch batch;
  batch.experiment = *std::move(experiment);
  base::Diagnostics problems = changedFiles(study);
  base::append(problems, results->store->forEach([&](const StoredRun& run) {
    if (run.row.ok) {
      batch.runs.push_back(run.run);
    }
  }));
  return base::resultOf(std::move(batch), std::move(problems));
}

ContactReport failedReport(const std::string& problem) {
  ContactReport report;
  report.problem = problem;
  return report;
}

/// In a worker: simulates the run and analyses it.
ContactReport reportOfRun(const Experiment& experiment, std::size_t run,
                          const ContactReportOptions& options, FileCache& files) {
  const RunSpec spec = experiment.specOf(run);
  const base::Result<RunSettings> settings = runSettingsOf(spec);
  if (!settings) {
    return failedReport(settings.diagnostics().front().message);
  }
  const Bundle bundle = readBundle(spec, *settings, files);
  const base::Result<RepeatableRun> repeatable = repeatableRunOf(bundle, {});
  if (!repeatable) {
    return failedReport(repeatable.diagnostics().front().message);
  }
  base::Result<ContactReport> report = reportContacts(*repeatable, options, {});
  return report ? *std::move(report) : failedReport(report.diagnostics().front().message);
}

}  // namespace

base::Result<std::vector<ContactReport>> reportBatchContacts(
    const std::string& folder, const ContactReportOptions& options,
    const sim2d::ImageLoader& loader, const std::function<bool()>& wantsStop,
    const std::function<void(std::size_t done, std::size_t all)>& showProgress) {
  const base::Result<FinishedBatch> batch = readBatch(folder);
  if (!batch) {
    return batch.diagnostics();
  }
  FileCache files(loader);
  ContactReportOptions ofRun = options;
  ofRun.jobs = 1;
  std::vector<std::pair<std::size_t, ContactReport>> reports;
  WorkerTasks tasks;
  tasks.count = batch->runs.size();
  tasks.jobs = options.jobs;
  tasks.wantsStop = wantsStop;
  tasks.work = [&](std::size_t task) {
    try {
      return contactReportText(reportOfRun(batch->experiment, batch->runs[task], ofRun, files));
    } catch (const std::exception& problem) {
      return contactReportText(failedReport(base::exceptionMessage(problem)));
    }
  };
  tasks.take = [&](std::size_t task, const std::string& text) {
    ContactReport report =
        contactReportOf(text).value_or(failedReport("the process ended unexpectedly"));
    report.run = std::to_string(batch->runs[task]);
    reports.emplace_back(task, std::move(report));
    showProgress(reports.size(), tasks.count);
  };
  if (!runTasks(tasks)) {
    return base::error("contacts.no-process", {}, folder);
  }
  std::sort(reports.begin(), reports.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<ContactReport> sorted;
  sorted.reserve(reports.size());
  for (auto& [task, report] : reports) {
    sorted.push_back(std::move(report));
  }
  return sorted;
}

}  // namespace app

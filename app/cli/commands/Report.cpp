#include <filesystem>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/ReportFiles.h"
#include "app/cli/RunProgress.h"
#include "app/report/Comparison.h"
#include "app/run/Batch.h"
#include "app/run/BatchFolder.h"
#include "app/run/ManifestFiles.h"
#include "app/run/OutputFolder.h"
#include "app/studies/BatchContacts.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  report::StudyOptions studyOptions;
  std::string metrics, pareto, weights;  // comma-separated
  bool noPdf = false, analysesContacts = false;
  int jobs = processorCount();  // of the analysis of contacts
  bool force = false;
};

/// The options of `sensitivity` that give a study its design; empty: it has none.
std::vector<std::string> sensitivityOptions(const Study& study) {
  const auto design = nlohmann::json::parse(base::shallowJson(study.design), nullptr, false);
  if (!design.is_object() || study.shard.count > 1) {
    return {};
  }
  const bool isMorris = design.value("method", "") == "morris";
  return {"--method", isMorris ? "morris" : "sobol", "--points",
          std::to_string(design.value("points", std::size_t{0}))};
}

/// Whether the manifest in the folder is that of a batch without runs left.
bool isFinishedBatch(const std::string& folder) {
  const base::Result<Manifest> manifest = readManifest(folder);
  const std::string text = manifest ? manifest->text : std::string();
  const auto json = nlohmann::json::parse(base::shallowJson(text), nullptr, false);
  return json.is_object() && json.value("status", nlohmann::json()) == "finished";
}

/// Error if the folder is in use, or the batch has no results.csv because it was killed. Empty if
/// there is no batch.
base::Diagnostics checkBatchFinished(const std::string& folder) {
  if (base::Diagnostics problems = completeCommit(folder); !problems.empty()) {
    return problems;
  }
  if (!ResultStore::isResultDatabase(pathIn(folder, "results.sqlite"))) {
    return {};
  }
  const base::Result<LockedResults> results = readResults(folder);
  const bool isLocked = !results && results.diagnostics().front().code == "batch.locked";
  if (entryExists(pathIn(folder, "results.csv")) && !isLocked) {
    return {};
  }
  if (!results) {
    const bool isRunning = isLocked && !isFinishedBatch(folder);  // otherwise of another command
    return isRunning ? base::Diagnostics{base::error("report.batch-runs", {}, folder)}
                     : results.diagnostics();
  }
  const Study& study = results->store->study();
  std::vector<std::string> words = {
      "hunavsim",
      study.design.empty() || study.shard.count > 1 ? "batch" : "sensitivity",
      study.experimentPath,
      "-o",
      folder,
      "--resume"};
  for (const std::string& word : sensitivityOptions(study)) {
    words.push_back(word);
  }
  if (study.shard.count > 1) {
    words.insert(words.end(), {"--shard", study.shard.text()});
  }
  if (study.allowsCode) {
    words.emplace_back("--allow-code");
  }
  if (study.timeLimit > 0.0) {
    words.insert(words.end(), {"--time-limit", base::formatDouble(study.timeLimit)});
  }
  return {base::error(
      "report.batch-cut",
      {results->store->finished(), study.shard.runCount(study.runs), report::shellText(words)},
      folder)};
}

/// "path_length=2,success=1". Reports values that are not numbers >= 0.
base::Diagnostics readWeights(const std::string& words,
                              std::vector<std::pair<std::string, double>>& weights) {
  base::Diagnostics problems;
  for (const std::string& word : base::split(words, ',')) {
    const std::size_t equals = word.find('=');
    const std::string number = equals == std::string::npos ? "" : word.substr(equals + 1);
    const std::optional<double> weight = base::parseDouble(base::trimmed(number));
    if (!weight || !(*weight >= 0.0) || *weight > 1e6) {
      problems.push_back(base::error("report.weights", {word}));
      continue;
    }
    weights.emplace_back(base::trimmed(word.substr(0, equals)), *weight);
  }
  return problems;
}

base::Diagnostics parseReportOptions(const ReportOptions& options,
                                     report::StudyOptions& studyOptions) {
  base::Diagnostics problems;
  if (!options.metrics.empty()) {
    for (const std::string& key : base::split(options.metrics, ',')) {
      studyOptions.metrics.push_back(base::trimmed(key));
    }
  }
  if (!options.pareto.empty()) {
    const std::vector<std::string> keys = base::split(options.pareto, ',');
    if (keys.size() != 2) {
      problems.push_back(base::error("report.pareto", {options.pareto}));
    } else {
      studyOptions.paretoX = base::trimmed(keys[0]);
      studyOptions.paretoY = base::trimmed(keys[1]);
    }
  }
  if (!options.weights.empty()) {
    base::append(problems, readWeights(options.weights, studyOptions.weights));
  }
  return problems;
}

/// Repeats the runs of the batch to analyse their contacts. False: interrupted.
bool analyseContacts(const ReportOptions& options, bool quiet, report::Study& study) {
  ContactReportOptions analysis;
  analysis.jobs = options.jobs;
  catchInterrupts();
  RunProgress progress(quiet, 0, false);
  progress.setStage("contacts");
  base::Result<std::vector<ContactReport>> contacts =
      reportBatchContacts(study.folder, analysis, loadMapImage, wasInterrupted,
                          [&progress](std::size_t done, std::size_t all) {
                            progress.setTotal(all);
                            progress.show(done, done);
                          });
  progress.clear();
  requireFine(contacts.diagnostics());
  base::Diagnostics incomplete;
  for (const ContactReport& report : *contacts) {
    if (!report.problem.empty()) {
      incomplete.push_back(base::warning("contacts.run-failed", {report.run, report.problem}));
    }
  }
  printDiagnostics(incomplete);
  study.contacts = *std::move(contacts);
  return !wasInterrupted();
}

void warnOfConstantCells(const report::Study& study) {
  const std::vector<std::string> constant = report::constantCells(study);
  if (!constant.empty()) {
    printDiagnostics({base::warning("batch.seeds-alike", {constant.size(), constant.front()},
                                    pathIn(study.folder, "results.csv"))});
  }
}

int reportCommand(const ReportOptions& options, const Invocation& given) {
  report::StudyOptions studyOptions = options.studyOptions;
  studyOptions.loader = loadMapImage;
  requireFine(parseReportOptions(options, studyOptions), ExitWrongCommandLine);
  requireFine(checkBatchFinished(studyOptions.folder));
  Progress progress(given.quiet || given.json);
  progress.show("reading results");
  base::Result<report::Study> study = report::readStudy(studyOptions);
  requireFine(study.diagnostics());
  if (options.analysesContacts) {
    progress.clear();
    if (!analyseContacts(options, given.quiet || given.json, *study)) {
      printError("interrupted: no report was written");
      return ExitRunFailed;
    }
  }
  const std::vector<std::string> words = given.argumentsForResults();
  const auto onProgress = [&progress](const std::string& what) { progress.show(what); };
  const base::Result<report::Report> report =
      study->sensitivity ? sensitivityReport(*study, words)
                         : report::makeReport(*study, studyOptions.weights, words, onProgress);
  progress.clear();
  warnOfConstantCells(*study);
  requireFine(report ? report->problems : report.diagnostics());
  const std::vector<base::FileContent> files = filesOf(*report, !options.noPdf);
  requireFine(writeReport(studyOptions.folder, files, options.force));
  if (given.json) {
    nlohmann::ordered_json written = nlohmann::ordered_json::array();
    for (const base::FileContent& file : files) {
      written.push_back((fs::path(options.studyOptions.folder) / file.path).string());
    }
    print(base::jsonText(nlohmann::ordered_json{{"written", written}}) + "\n");
  } else if (!given.quiet) {
    printLine((fs::path(options.studyOptions.folder) / "report.html").string());
  }
  // otherwise the report is incomplete
  return report->problems.empty() && !study->isExperimentUnreadable ? ExitFine : ExitRunFailed;
}

Drawing drawingOfReport(const ReportOptions& /*options*/) {
  return Drawing::Pictures;
}

}  // namespace

void addReport(CommandRegistry& commands) {
  const auto [command, options] =
      commands.add("report", "Write tables, statistics and figures of a batch as one HTML page",
                   reportCommand, drawingOfReport);
  command.add_option("folder", options.studyOptions.folder, "Folder of a batch")->required();
  command.add_option("--metrics", options.metrics,
                     "Metrics to show, comma-separated keys (default: a selection; "
                     "tables/all_metrics.csv contains all)");
  command.add_option("--compare", options.studyOptions.compare,
                     "Path of the values to compare, or \"scenario\" (default: the planner, "
                     "otherwise the first varied path)");
  command.add_option("--pareto", options.pareto,
                     "Two keys for the trade-off plot (default: "
                     "time_to_reach_goal,minimum_distance_to_people)");
  command.add_option("--weights", options.weights,
                     "Weights of a composite score: KEY=WEIGHT,… (default: none)");
  command.add_option("--level", options.studyOptions.level, "Confidence level (default: 0.95)")
      ->check(CLI::Range(0.5, 0.999));
  command
      .add_option("--resamples", options.studyOptions.resamples,
                  "Bootstrap resamples (default: 2000)")
      ->check(CLI::Range(100, 100000));
  CLI::Option* const contacts =
      command.add_flag("--contacts", options.analysesContacts,
                       "Repeat the runs to analyse each contact: when and by whom it could last "
                       "have been avoided, and what the robots cost each person");
  addJobs(command, options.jobs);
  command.get_option("--jobs")->needs(contacts);
  command.add_flag("--no-pdf", options.noPdf, "Write figures as SVG only");
  addForce(command, options.force);
  commands.addExamples(
      command, {{"hunavsim report results", "Write results/report.html", "the folder of a batch"},
                {"hunavsim report results --metrics spl,time_to_reach_goal",
                 "Show selected metrics only", "the folder of a batch"},
                {"hunavsim report results --contacts",
                 "Also analyse who could have avoided each contact", "the folder of a batch"}});
}

}  // namespace app
